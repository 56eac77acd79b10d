"""The spectrum against noise whose spectrum is known, and the correlation with ice ahead."""

import math

import numpy as np
import pandas as pd
import pytest
from scipy import signal

from nilas.errors import InputError
from nilas.loads.ice_ahead import clipped_area, correlation, follow, ice_ahead
from nilas.loads.series import LoadSeries
from nilas.loads.spectrum import spectrum_of_series


def noise(count, random, memory=0.0):
    return signal.lfilter([1.0], [1.0, -memory], random.normal(size=count + 200))[200:]


def loads(count, memory, seed, runs=1, step=0.1):
    random = np.random.default_rng(seed)
    return [LoadSeries(noise(count, random, memory), 0.0, step, step) for _ in range(runs)]


def true_density(frequency, memory, step):
    """One-sided spectral density of an AR(1) process with unit noise."""
    turn = np.exp(-2j * math.pi * frequency * step)
    return 2 * step / np.abs(1 - memory * turn) ** 2


@pytest.mark.parametrize("memory", [0.0, 0.6])
def test_intervals_hold_the_true_density_in_95_percent_of_cases(memory):
    held = []
    for seed in range(100):
        found = spectrum_of_series(loads(2000, memory, seed))
        # The ends of the spectrum have half the freedom, and the mean was deducted.
        inner = found.iloc[2:-2:4]
        true = true_density(inner.index.to_numpy(), memory, 0.1)
        held.append(((inner.low <= true) & (true <= inner.high)).mean())
    assert np.mean(held) == pytest.approx(0.95, abs=0.015)


def test_more_runs_narrow_the_interval_and_the_area_is_the_variance():
    one, six = (spectrum_of_series(loads(2000, 0.6, 1, runs)) for runs in (1, 6))
    assert six.attrs["freedom"] == pytest.approx(6 * one.attrs["freedom"])
    width = ((six.high - six.low) / six.density).iloc[3]
    assert width < 0.5 * ((one.high - one.low) / one.density).iloc[3]
    area = six.density.sum() * six.index[1]
    assert area == pytest.approx(1 / (1 - 0.36), rel=0.1)


def test_series_that_do_not_fit_are_told():
    with pytest.raises(InputError, match="needs 72 steps"):
        spectrum_of_series(loads(71, 0.0, 1))
    with pytest.raises(InputError, match="different time steps"):
        spectrum_of_series(loads(100, 0.0, 1) + loads(100, 0.0, 1, step=0.2))


def test_correlations_of_slow_series_have_intervals_that_hold_no_correlation():
    """By counting pairs as independent, intervals would leave out zero in about half of the cases."""
    random = np.random.default_rng(2)
    held, worth = 0, []
    for _ in range(300):
        _, low, high, pairs = correlation(noise(100, random, 0.8), noise(100, random, 0.8))
        held += low <= 0 <= high
        worth.append(pairs)
    assert held / 300 == pytest.approx(0.95, abs=0.04)
    # The true correlations of neighbours give 22 of 100 pairs; those of short series are smaller.
    assert 20 < np.mean(worth) < 30


def test_a_load_that_follows_after_a_delay_is_found_there():
    random = np.random.default_rng(3)
    ice = pd.Series(noise(300, random, 0.7), index=0.5 * np.arange(300))
    load = pd.Series(ice.to_numpy() + 0.5 * random.normal(size=300), index=ice.index + 4.0)
    found = follow(ice, load, np.arange(0.0, 8.5, 0.5))
    assert found.best_delay_s == 4.0
    best = found.table.loc[4.0]
    assert best.low > 0.7 and best.high < 1


def test_a_constant_series_gives_a_reason_instead_of_a_correlation():
    times = 0.5 * np.arange(100)
    still = pd.Series(0.8, index=times)
    moving = pd.Series(noise(100, np.random.default_rng(4)), index=times)
    for ice, load in ((still, moving), (moving, still)):
        with pytest.raises(InputError, match="does not change"):
            follow(ice, load, [0.0, 1.0])


def test_polygons_are_cut_to_the_window():
    square = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    assert clipped_area(square, 10.0, 4.0) == pytest.approx(2.0)
    assert clipped_area(square + [3.0, 0.0], 10.0, 4.0) == pytest.approx(4.0)
    assert clipped_area(square + [30.0, 0.0], 10.0, 4.0) == 0.0
    turned = square @ (np.array([[1.0, -1.0], [1.0, 1.0]]) / math.sqrt(2))
    assert clipped_area(turned, 10.0, 4.0) == pytest.approx(2.0)


def test_a_window_full_of_ice_is_covered_and_one_behind_the_field_is_not(small_run):
    cover = ice_ahead(small_run)
    assert len(cover) == len(small_run.replay.times)
    assert 0 < cover.iloc[0] <= 1
