"""Return levels against distributions whose levels are known, and how peaks are taken apart."""

import math

import numpy as np
import pytest
from scipy import stats

from nilas.errors import InputError
from nilas.loads.events import events_above, extremal_index
from nilas.loads.peaks import peaks_of_series
from nilas.loads.series import LoadSeries, filtered
from nilas.loads.tail import LEAST_EVENTS, LEAST_FOR_SHAPE, fit_tail, log_likelihood


def series(values, step=0.1, filter_s=0.1):
    return LoadSeries(np.asarray(values, dtype=float), 0.0, step, filter_s)


def test_the_likelihood_is_that_of_scipy():
    excess = stats.genpareto.rvs(0.2, scale=3.0, size=50, random_state=1)
    for shape in (-0.01, 0.0, 0.2):
        expected = stats.genpareto.logpdf(excess, shape, scale=4.0).sum() + 50 * math.log(0.5) - 5.0
        assert log_likelihood(excess, 10.0, 0.5, 4.0, shape) == pytest.approx(expected, rel=1e-9)


def test_a_fit_of_many_peaks_finds_rate_scale_and_shape():
    for shape in (-0.2, 0.0, 0.2):
        excess = stats.genpareto.rvs(shape, scale=2.0, size=20000, random_state=2)
        tail = fit_tail(excess, 5000.0)
        assert tail.rate == 4.0
        assert tail.scale == pytest.approx(2.0, rel=0.04)
        assert tail.shape == pytest.approx(shape, abs=0.03)


def true_level(shape, events):
    """Return level of excesses of scale 1 in a period with so many events on average."""
    return math.log(events) if shape == 0 else (events**shape - 1) / shape


@pytest.mark.parametrize(
    ("shape", "mean_count", "periods", "least"),
    [(0.0, 20, 1.0, 0.88), (0.0, 60, 3.0, 0.9), (0.2, 60, 3.0, 0.88), (-0.2, 60, 3.0, 0.88)],
)
def test_intervals_hold_the_true_level_in_nearly_95_percent_of_samples(
    shape, mean_count, periods, least
):
    random = np.random.default_rng(3)
    held, asked = 0, 0
    for _ in range(100):
        excess = stats.genpareto.rvs(shape, size=random.poisson(mean_count), random_state=random)
        found = fit_tail(excess, float(mean_count), 10.0).return_level(periods * mean_count)
        if found.is_known:
            asked += 1
            held += found.low <= 10.0 + true_level(shape, periods * mean_count) <= found.high
    assert asked >= 90
    assert least <= held / asked


def test_too_few_events_are_told_and_give_no_number():
    few = fit_tail(np.ones(LEAST_EVENTS - 1), 10.0).return_level(5.0)
    assert not few.is_known and "too few events: 9" in few.reason
    some = fit_tail(np.ones(LEAST_FOR_SHAPE - 1), 10.0)
    assert "exponential" in some.return_level(10.0).reason
    assert "bear 10 s at most" in some.return_level(20.0).reason
    many = fit_tail(stats.expon.rvs(size=LEAST_FOR_SHAPE, random_state=4), 10.0)
    assert many.return_level(100.0).is_known and not many.return_level(101.0).is_known
    assert "more rarely" in many.return_level(0.1).reason


def test_counts_that_scatter_more_than_chance_widen_the_interval():
    excess = stats.expon.rvs(size=60, random_state=5)
    plain, spread = (fit_tail(excess, 60.0, 0.0, k).return_level(120.0) for k in (1.0, 4.0))
    assert spread.level == plain.level
    assert spread.high - spread.low > 1.6 * (plain.high - plain.low)


def test_means_over_the_filter_are_exact_and_their_largest_is_found_between_steps():
    times, means = filtered(series([0, 0, 6, 0, 0], step=1.0), 1.5)
    assert means.max() == pytest.approx(4.0)
    assert times[np.argmax(means)] == pytest.approx(3.0)
    with pytest.raises(InputError, match="filter"):
        filtered(series([1, 2]), 5.0)


def test_independent_exceedances_have_an_extremal_index_of_one_and_repeated_ones_less():
    random = np.random.default_rng(6)
    alone = np.flatnonzero(random.random(200000) < 0.02)
    assert extremal_index(np.diff(alone)) == pytest.approx(1.0, abs=0.03)
    # The largest of two neighbours: exceedances come in pairs, so the index is one half.
    noise = random.random(200000)
    pairs = np.flatnonzero(np.maximum(noise[1:], noise[:-1]) > 0.99)
    assert extremal_index(np.diff(pairs)) == pytest.approx(0.5, abs=0.03)


def test_each_pulse_gives_one_peak():
    values = np.zeros(4000)
    starts = np.arange(100, 4000, 200)
    for start, height in zip(starts, np.linspace(5, 9, len(starts))):
        values[start : start + 20] = height * np.hanning(20)
    found = events_above(0.1 * np.arange(4000), values, 1.0, 0.5)
    assert len(found.peak) == len(starts)
    assert found.peak.max() == values.max()


def test_the_level_of_a_process_is_that_of_a_run_of_the_period():
    """The median number of exceedances of the level in long runs of an AR(1) process is 1 a period."""
    random = np.random.default_rng(7)

    def process(count):
        noise = random.normal(size=count)
        out = np.empty(count)
        out[0] = noise[0]
        for k in range(1, count):
            out[k] = 0.9 * out[k - 1] + math.sqrt(1 - 0.81) * noise[k]
        return out

    peaks = peaks_of_series([series(process(20000)) for _ in range(4)])
    level = peaks.return_level(4000.0)
    long = process(400000)
    crossings = len(events_above(0.1 * np.arange(400000), long, level.level, 5.0).peak)
    assert level.is_known and level.low < level.level < level.high
    assert 3 <= crossings <= 30  # 10 periods
    assert peaks.remarks == ()


def test_a_load_towards_minus_has_its_peaks_there_and_runs_that_differ_are_told():
    random = np.random.default_rng(8)
    base = random.exponential(size=4000)
    down = peaks_of_series([series(-base), series(-base[::-1])])
    assert down.side == -1 and (down.events["peak"] > 0).all()
    uneven = peaks_of_series([series(base), series(3 * random.exponential(size=4000))])
    assert any("how often" in remark for remark in uneven.remarks)
    assert uneven.tail.dispersion > 2
    with pytest.raises(InputError, match="no load"):
        peaks_of_series([])
