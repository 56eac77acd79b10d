"""Sensitivities against answers that are known from elsewhere."""

import itertools
import math

import numpy as np
import pytest

from nilas.study.describe.points import shares_of
from nilas.study.results.anova import analyse
from nilas.study.results.regression import fit_surface, standardised_slopes
from nilas.study.results.scatter import scatter_of
from nilas.study.results.sobol import sobol_indices


def test_shares_of_variance_are_those_by_hand():
    # y = 4 a + b with a, b in {0, 1} and seeds at +-1 of it. Squares: a: 8 * (4/2)^2 = 32,
    # b: 8 * (1/2)^2 = 2, both together 0, chance 8 * 1 = 8. Sum 42.
    values = [[4 * a + b - 1.0, 4 * a + b + 1.0] for a in (0, 1) for b in (0, 1)]
    found = analyse([2, 2], values)
    assert [effect.share for effect in found.effects] == pytest.approx(
        [32 / 42, 2 / 42, 0], abs=1e-14
    )
    assert found.chance == pytest.approx(8 / 42)
    # F of a is (32 / 1) / (8 / 4) = 16 with 1 and 4 degrees of freedom: t = 4 with 4 degrees.
    assert found.effects[0].probability == pytest.approx(0.016130, abs=1e-5)


def test_shares_add_up_with_three_factors():
    random = np.random.default_rng(3)
    found = analyse([2, 3, 4], random.normal(size=(24, 3)).tolist())
    total = sum(effect.share for effect in found.effects) + found.higher + found.chance
    assert total == pytest.approx(1.0, abs=1e-12)


def test_points_with_more_seeds_are_cut_to_the_poorest():
    found = analyse([2], [[1.0, 3.0, 50.0], [5.0, 7.0]])
    assert found.seeds == 2 and found.effects[0].share == pytest.approx(16 / 20)


def test_no_analysis_where_a_point_has_no_value_or_nothing_scatters():
    assert analyse([2], [[1.0], []]) is None
    assert analyse([2], [[1.0], [1.0]]) is None


def ishigami(x):
    """Ishigami and Homma (1990), on the unit cube."""
    a, b, c = (2 * math.pi * share - math.pi for share in x)
    return math.sin(a) + 7 * math.sin(b) ** 2 + 0.1 * c**4 * math.sin(a)


def test_sobol_indices_of_ishigami_are_the_closed_form():
    # V1 = (1 + b pi^4 / 5)^2 / 2, V2 = a^2 / 8, V13 = 8 b^2 pi^8 / 225 for a = 7, b = 0.1.
    v1, v2 = (1 + 0.1 * math.pi**4 / 5) ** 2 / 2, 49 / 8
    v13 = 8 * 0.01 * math.pi**8 / 225
    whole = v1 + v2 + v13
    values = [ishigami(row) for row in shares_of("saltelli", 3, 4096, 1)]
    found = sobol_indices(values, 3)
    # 4096 base points leave about 0.02, by the intervals that the function itself states.
    assert found.first == pytest.approx([v1 / whole, v2 / whole, 0.0], abs=0.02)
    assert found.total == pytest.approx([(v1 + v13) / whole, v2 / whole, v13 / whole], abs=0.02)
    assert max(*found.first_interval, *found.total_interval) < 0.06


def test_sobol_indices_are_those_of_salib():
    salib = pytest.importorskip(
        "SALib.analyze.sobol", reason="SALib is not installed (pip install SALib)"
    )
    values = np.array([ishigami(row) for row in shares_of("saltelli", 3, 1024, 1)])
    problem = {"num_vars": 3, "names": ["a", "b", "c"], "bounds": [[0, 1]] * 3}
    theirs = salib.analyze(problem, values, calc_second_order=False, seed=1)
    found = sobol_indices(list(values), 3)
    assert found.first == pytest.approx(theirs["S1"], abs=0.01)
    assert found.total == pytest.approx(theirs["ST"], abs=0.01)


def test_sobol_leaves_out_base_points_with_a_failed_run():
    values = [ishigami(row) for row in shares_of("saltelli", 3, 64, 1)]
    holed = [None if place == 7 else value for place, value in enumerate(values)]
    assert sobol_indices(holed, 3).samples == 63
    assert sobol_indices([None] * 20, 3) is None


def test_slopes_of_a_plane_are_known():
    # For y = 3 a - 4 b on a symmetric grid the slopes are 3/5 and -4/5, and nothing is left over.
    grid = np.array(list(itertools.product([-1.0, 0.0, 1.0], repeat=2)))
    found = standardised_slopes(grid, 3 * grid[:, 0] - 4 * grid[:, 1])
    assert found.slope == pytest.approx([0.6, -0.8], abs=1e-12)
    assert found.explained == pytest.approx(1.0)


def test_a_surface_of_second_order_is_found_exactly():
    grid = np.array(list(itertools.product(np.linspace(0, 4, 5), np.linspace(1, 3, 5))))
    surface = fit_surface(grid, grid[:, 0] ** 2 - grid[:, 1])
    curve = surface.curve(0)
    # The other factor is at its middle, 2.
    assert curve.y == pytest.approx(curve.x**2 - 2, abs=1e-9)
    assert surface.order == 2 and float(curve.band.max()) < 1e-6


def test_the_band_of_a_mean_covers_it_about_as_often_as_it_says():
    # 95 % of 2000 intervals: the standard deviation of the share is 0.5 %.
    random = np.random.default_rng(5)
    inside = 0
    for _ in range(2000):
        found = scatter_of(random.normal(3.0, 2.0, 4).tolist())
        inside += abs(found.mean - 3.0) <= found.interval
    assert 0.935 < inside / 2000 < 0.965
