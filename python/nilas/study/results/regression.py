"""Regression of a response on the numeric factors: standardised slopes, and curves with bands."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import numpy as np

from nilas.study.results.scatter import t_quantile


@dataclass(frozen=True)
class Slopes:
    """``slope``: standard deviations of the response per standard deviation of each factor.
    ``interval``: half widths of about 95 %. ``explained``: share of the scatter, R squared."""

    slope: np.ndarray
    interval: np.ndarray
    explained: float


def standardised_slopes(factors: np.ndarray, values: np.ndarray) -> Slopes | None:
    """Slopes of the straight fit. ``factors``: a row per run, a column per factor.

    None where there are too few runs, or nothing scatters.

    >>> x = np.array([[0.0], [1.0], [2.0], [3.0]])
    >>> round(float(standardised_slopes(x, 2 * x[:, 0] + 1).slope[0]), 6)
    1.0
    """
    runs, count = factors.shape
    if runs < count + 2 or values.std() == 0.0 or (factors.std(axis=0) == 0.0).any():
        return None
    scaled = (factors - factors.mean(axis=0)) / factors.std(axis=0)
    target = (values - values.mean()) / values.std()
    fit = _fit(np.column_stack([np.ones(runs), scaled]), target)
    if fit is None:
        return None
    errors = np.sqrt(np.diag(fit.covariance))[1:]
    return Slopes(fit.coefficients[1:], errors * t_quantile(fit.freedom), fit.explained)


@dataclass(frozen=True)
class Curve:
    """The response over one factor with all others at their middle, and its band of 95 %."""

    x: np.ndarray
    y: np.ndarray
    band: np.ndarray


@dataclass(frozen=True)
class Surface:
    """A fit by a polynomial of second order, or of first order where runs are few."""

    coefficients: np.ndarray
    covariance: np.ndarray
    freedom: int
    explained: float
    order: int
    low: np.ndarray
    high: np.ndarray

    def curve(self, place: int, count: int = 60) -> Curve:
        """The curve over the factor number ``place``."""
        x = np.zeros((count, self.low.size))
        x[:, place] = np.linspace(-1.0, 1.0, count)
        terms = _terms(x, self.order)
        y = terms @ self.coefficients
        spread = np.sqrt(np.maximum(np.einsum("ij,jk,ik->i", terms, self.covariance, terms), 0.0))
        own = self.low[place] + (x[:, place] + 1) / 2 * (self.high[place] - self.low[place])
        return Curve(own, y, spread * t_quantile(self.freedom))


def fit_surface(factors: np.ndarray, values: np.ndarray) -> Surface | None:
    """The polynomial that fits best. Factors are scaled to -1 .. 1 first."""
    low, high = factors.min(axis=0), factors.max(axis=0)
    if (high <= low).any() or values.std() == 0.0:
        return None
    scaled = 2 * (factors - low) / (high - low) - 1
    for order in (2, 1):
        terms = _terms(scaled, order)
        # A fit needs some more runs than terms, or its band means nothing.
        if len(values) >= terms.shape[1] + 3:
            fit = _fit(terms, values)
            if fit is not None:
                return Surface(
                    fit.coefficients, fit.covariance, fit.freedom, fit.explained, order, low, high
                )
    return None


@dataclass(frozen=True)
class _Fit:
    coefficients: np.ndarray
    covariance: np.ndarray
    freedom: int
    explained: float


def _fit(terms: np.ndarray, values: np.ndarray) -> _Fit | None:
    """Least squares with the covariance of the coefficients, or None where terms depend."""
    runs, count = terms.shape
    if runs <= count or np.linalg.matrix_rank(terms) < count:
        return None
    coefficients, *_ = np.linalg.lstsq(terms, values, rcond=None)
    rest = float(((values - terms @ coefficients) ** 2).sum())
    total = float(((values - values.mean()) ** 2).sum())
    freedom = runs - count
    covariance = np.linalg.inv(terms.T @ terms) * (rest / freedom)
    return _Fit(coefficients, covariance, freedom, 1.0 - rest / total if total > 0 else math.nan)


def _terms(x: np.ndarray, order: int) -> np.ndarray:
    columns = [np.ones(len(x)), *x.T]
    if order == 2:
        pairs = itertools.combinations_with_replacement(range(x.shape[1]), 2)
        columns += [x[:, i] * x[:, j] for i, j in pairs]
    return np.column_stack(columns)
