"""The rule for the number of seeds."""

import math

import pytest

from nilas.study.carry_out.stopping import relative_error, seeds_wanted
from nilas.study.describe.study import Seeds, Until

RULE = Seeds(3, until=Until("load", 0.1, 12))


def test_the_relative_error_is_that_of_the_mean():
    # Mean 4, deviation sqrt(((-2)^2 + 0 + 2^2) / 2) = 2, standard error 2 / sqrt(3), over 4.
    assert relative_error([2.0, 4.0, 6.0]) == pytest.approx(2 / math.sqrt(3) / 4, rel=1e-15)


def test_without_a_rule_the_number_is_fixed():
    assert seeds_wanted(Seeds(5), [1.0, 100.0]) == 5


def test_values_that_agree_are_enough():
    assert seeds_wanted(RULE, [10.0, 10.1, 9.9]) == 3


def test_the_next_number_follows_from_the_scatter():
    # The error 0.12 is 1.2 times the bound: 3 * 1.44 = 4.3, so 5 seeds are asked for.
    d = 0.12 * math.sqrt(3) * 10
    assert seeds_wanted(RULE, [10 - d, 10.0, 10 + d]) == 5


def test_a_round_at_most_doubles_the_seeds_and_never_passes_the_most():
    wild = [1.0, 100.0, -50.0, 3.0, 80.0, 7.0, -9.0, 60.0]
    assert seeds_wanted(RULE, wild[:3]) == 6
    assert seeds_wanted(RULE, wild[:6]) == 12
    assert seeds_wanted(RULE, wild * 2) == 12


def test_the_answer_depends_on_complete_rounds_only():
    wild = [1.0, 100.0, -50.0]
    assert seeds_wanted(RULE, [*wild, 1.0]) == seeds_wanted(RULE, wild) == 6


def test_runs_that_failed_count_as_seeds_without_a_value():
    assert seeds_wanted(RULE, [10.0, None, 10.0]) == 3
    assert seeds_wanted(RULE, [None, None, 10.0]) == 6


def test_a_load_of_zero_everywhere_needs_no_more_seeds():
    assert seeds_wanted(RULE, [0.0, 0.0, 0.0]) == 3
