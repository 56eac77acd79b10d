"""Mean of a few values, and how far it may be off."""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Scatter:
    """``deviation``: standard deviation of one value. ``interval``: half width of the interval
    that holds the mean with 95 %, by Student's distribution. NaN: not known."""

    count: int
    mean: float
    deviation: float
    standard_error: float
    interval: float


def scatter_of(values: Sequence[float]) -> Scatter:
    """The scatter of values that do not depend on each other.

    Sums are exact, so the order of the values does not matter.

    >>> scatter_of([1.0, 3.0]).standard_error
    1.0
    """
    count = len(values)
    if count == 0:
        return Scatter(0, math.nan, math.nan, math.nan, math.nan)
    mean = math.fsum(values) / count
    if count == 1:
        return Scatter(1, mean, math.nan, math.nan, math.nan)
    deviation = math.sqrt(math.fsum((value - mean) ** 2 for value in values) / (count - 1))
    error = deviation / math.sqrt(count)
    return Scatter(count, mean, deviation, error, error * t_quantile(count - 1))


@functools.cache
def t_quantile(freedom: int, confidence: float = 0.95) -> float:
    """Student's factor for a two-sided interval, to ten digits so that all machines agree.

    >>> t_quantile(3)
    3.182446305
    """
    from scipy.stats import t

    return float(f"{t.ppf(0.5 + confidence / 2, freedom):.10g}")
