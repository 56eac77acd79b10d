"""The tail of a load: peaks over a threshold that come at random, and their return level.

Peaks come as a Poisson process, and their excesses over the threshold follow a generalised Pareto
distribution. Coles (2001), chapter 4: the return level is exceeded once in its period on average.
Its interval is that of the profile likelihood.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import optimize, stats

# The shape cannot be told from fewer events; then an exponential tail is taken.
LEAST_FOR_SHAPE = 30
# With fewer events even the scale is not known.
LEAST_EVENTS = 10
# A level may be extrapolated to this many times the exposure where the shape is known, else to once.
MOST_TIMES_EXPOSURE = 10.0
_SHAPES = (-0.5, 0.5)
_CONFIDENCE = 0.95


@dataclass(frozen=True)
class ReturnLevel:
    """The load that is exceeded once in ``period_s`` on average, and its interval of 95 % [N].

    All three are nan where the events do not suffice; ``reason`` then says why.

    >>> ReturnLevel(60.0, math.nan, math.nan, math.nan, "There are too few events.").is_known
    False
    """

    period_s: float
    level: float
    low: float
    high: float
    reason: str = ""

    @property
    def is_known(self) -> bool:
        """Whether there is a level."""
        return not math.isnan(self.level)


def log_likelihood(
    excess: NDArray[np.float64], exposure: float, rate: float, scale: float, shape: float
) -> float:
    """Logarithm of the likelihood of these excesses in this exposure.

    >>> one = log_likelihood(np.array([1.0]), 1.0, 1.0, 1.0, 0.0)
    >>> one  # log of the rate, less rate times exposure, less excess over scale
    -2.0
    """
    if rate <= 0 or scale <= 0:
        return -math.inf
    count = len(excess)
    events = count * math.log(rate) - rate * exposure - count * math.log(scale)
    if abs(shape) < 1e-9:
        return events - float(excess.sum()) / scale
    inner = 1 + shape * excess / scale
    if inner.min() <= 0:
        return -math.inf
    return events - (1 + 1 / shape) * float(np.log(inner).sum())


@dataclass(frozen=True)
class Tail:
    """A fitted tail. ``excess``: peaks less the threshold, ``exposure``: observed time [s].

    ``dispersion``: by how much the scatter of the counts between runs exceeds that of events at
    random, at least 1. It widens intervals by its root.

    >>> tail = fit_tail(np.array([1.0, 3.0] * 10), 100.0, threshold=5.0)
    >>> tail.rate, tail.scale, tail.shape
    (0.2, 2.0, 0.0)
    >>> round(tail.return_level(50.0).level, 3)  # 5 + 2 ln(0.2 * 50)
    9.605
    """

    excess: NDArray[np.float64]
    exposure: float
    threshold: float
    rate: float
    scale: float
    shape: float
    dispersion: float = 1.0

    @property
    def has_shape(self) -> bool:
        """Whether the events suffice to fit the shape."""
        return len(self.excess) >= LEAST_FOR_SHAPE

    def level(self, period: float) -> float:
        """The best estimate of the return level [N], without asking whether it is known."""
        return self.threshold + self.scale * _growth(self.rate * period, self.shape)

    def return_level(self, period: float) -> ReturnLevel:
        """The return level of a period [s] with its interval, or the reason why there is none."""
        reason = self._refused(period)
        if reason:
            return ReturnLevel(period, math.nan, math.nan, math.nan, reason)
        best = self.level(period)
        top = log_likelihood(self.excess, self.exposure, self.rate, self.scale, self.shape)
        drop = 0.5 * self.dispersion * stats.chi2.ppf(_CONFIDENCE, 1)

        def short(level: float) -> float:
            return top - drop - self._profile(level, period)

        low = _crossing(short, best, self.threshold, -1)
        high = _crossing(short, best, self.threshold, +1)
        return ReturnLevel(period, best, low, high, self._remark())

    def _refused(self, period: float) -> str:
        count = len(self.excess)
        if count < LEAST_EVENTS:
            return (
                f"There are too few events: {count} peaks above the threshold, and {LEAST_EVENTS} are"
                " the least. Run longer, or more seeds."
            )
        if self.rate * period <= 1:
            return "Peaks above the threshold come more rarely than once in this period."
        most = MOST_TIMES_EXPOSURE if self.has_shape else 1.0
        if period > most * self.exposure * (1 + 1e-9):
            return (
                f"There are too few events for this period: {count} peaks in {self.exposure:g} s bear"
                f" {most * self.exposure:g} s at most. Run longer, or more seeds."
            )
        return ""

    def _remark(self) -> str:
        if self.has_shape:
            return ""
        return (
            f"With {len(self.excess)} events the tail is taken as exponential; {LEAST_FOR_SHAPE} are"
            " needed to fit its shape."
        )

    def _profile(self, level: float, period: float) -> float:
        """The largest likelihood of all tails with this return level."""

        def loss(parameters: NDArray[np.float64]) -> float:
            rate = (1 + math.exp(min(parameters[0], 50.0))) / period
            shape = float(parameters[1]) if self.has_shape else 0.0
            if not _SHAPES[0] <= shape <= _SHAPES[1]:
                return math.inf
            scale = (level - self.threshold) / _growth(rate * period, shape)
            return -log_likelihood(self.excess, self.exposure, rate, scale, shape)

        begin = math.log(max(self.rate * period - 1, 1e-6))
        if not self.has_shape:
            found = optimize.minimize_scalar(
                lambda x: loss(np.array([x])), bounds=(begin - 8, begin + 4), method="bounded"
            )
            return -float(found.fun)
        # A tail of another shape may be the only one that bears the largest peak.
        shapes = np.linspace(_SHAPES[0] + 0.02, _SHAPES[1] - 0.02, 9)
        first = min(shapes, key=lambda shape: loss(np.array([begin, shape])))
        found = optimize.minimize(
            loss, [begin, first], method="Nelder-Mead",
            options={"xatol": 1e-4, "fatol": 1e-5, "initial_simplex": _simplex(begin, first)},
        )  # fmt: skip
        return -float(found.fun)


def fit_tail(
    excess: NDArray[np.float64], exposure: float, threshold: float = 0.0, dispersion: float = 1.0
) -> Tail:
    """The tail of greatest likelihood. The shape lies between -0.5 and 0.5.

    With fewer than 30 events the shape is 0, an exponential tail.

    >>> fit_tail(np.array([2.0, 2.0]), 4.0).scale
    2.0
    """
    excess = np.asarray(excess, dtype=float)
    count = len(excess)
    mean = float(excess.mean()) if count else math.nan
    rate = count / exposure
    if count < LEAST_FOR_SHAPE:
        return Tail(excess, exposure, threshold, rate, mean, 0.0, dispersion)

    def loss(parameters: NDArray[np.float64]) -> float:
        log_scale, shape = parameters
        if not _SHAPES[0] <= shape <= _SHAPES[1]:
            return math.inf
        return -log_likelihood(excess, exposure, rate, math.exp(log_scale), shape)

    found = optimize.minimize(loss, [math.log(mean), 0.05], method="Nelder-Mead",
                              options={"xatol": 1e-6, "fatol": 1e-8, "maxiter": 2000})  # fmt: skip
    log_scale, shape = found.x
    return Tail(excess, exposure, threshold, rate, math.exp(log_scale), float(shape), dispersion)


def _growth(events: float, shape: float) -> float:
    """(events^shape - 1) / shape: return level less threshold, over the scale."""
    if abs(shape) < 1e-9:
        return math.log(events)
    return math.expm1(shape * math.log(events)) / shape


def _simplex(begin: float, shape: float) -> NDArray[np.float64]:
    return np.array([[begin, shape], [begin + 0.3, shape], [begin, shape + 0.05]])


def _crossing(short, best: float, threshold: float, side: int) -> float:
    """The level on one side of the best at which the likelihood has fallen far enough [N]."""
    reach = best - threshold
    inner, width = best, 0.1 * reach
    for _ in range(60):
        outer = best + side * width
        if side < 0 and outer <= threshold:
            outer = threshold + 1e-6 * reach
        if short(outer) > 0:
            return float(optimize.brentq(short, inner, outer, xtol=1e-4 * reach))
        if side < 0 and width >= reach:
            return threshold
        inner, width = outer, 1.6 * width
    return math.inf
