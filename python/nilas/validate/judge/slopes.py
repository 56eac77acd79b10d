"""Slopes d ln load / d ln factor with their error, beside those of formulas."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from nilas.study.results.scatter import t_quantile
from nilas.validate.cases.case import SlopeReference
from nilas.validate.formulas import Formula, FormulaError
from nilas.validate.judge.simulated import CaseResult, Estimate, PointResult
from nilas.validate.judge.verdicts import LEAST_RUNS, Row, Verdict


@dataclass(frozen=True)
class Slope:
    """The slope of a case over a factor, and those of the formulas over the same points."""

    factor: str
    simulated: Estimate
    formulas: tuple[tuple[Formula, float], ...]
    row: Row


def slopes_of(result: CaseResult) -> list[Slope]:
    """All slopes that the case asks for, but those over factors of which it has one level alone."""
    return [
        _slope(result, wanted)
        for wanted in result.case.slopes
        if len(result.along(wanted.factor)) > 1
    ]


def straight_slope(x: Sequence[float], y: Sequence[float]) -> float:
    """Slope of the straight line through ln y over ln x, by least squares.

    >>> round(straight_slope([1.0, 2.0, 4.0], [3.0, 12.0, 48.0]), 9)
    2.0
    """
    across, up = np.log(np.asarray(x, dtype=float)), np.log(np.asarray(y, dtype=float))
    across = across - across.mean()
    return float(across @ up / (across @ across))


def jackknife_slope(x: Sequence[float], values: np.ndarray) -> Estimate:
    """Slope of the logarithm of the mean, with the error by leaving out each seed in turn.

    ``values``: a row for each seed, a column for each point. Means are taken before logarithms,
    so that a single run without load does no harm. The interval is Student's. NaN where a mean is
    not above 0, or where there is one seed.
    """
    seeds = len(values)
    means = values.mean(axis=0) if seeds else np.zeros(len(x))
    if not seeds or (means <= 0).any():
        return Estimate(math.nan, math.nan, seeds, "seeds")
    slope = straight_slope(x, means)
    if seeds < 2:
        return Estimate(slope, math.nan, seeds, "seeds")
    left = [(means * seeds - row) / (seeds - 1) for row in values]
    if any((one <= 0).any() for one in left):
        return Estimate(slope, math.nan, seeds, "seeds")
    parts = np.array([straight_slope(x, one) for one in left])
    error = math.sqrt((seeds - 1) / seeds * float(((parts - parts.mean()) ** 2).sum()))
    return Estimate(slope, error * t_quantile(seeds - 1), seeds, "seeds")


def _slope(result: CaseResult, wanted: SlopeReference) -> Slope:
    points = result.along(wanted.factor)
    known = [one for one in points if one.values.get(wanted.quantity)]
    x = [one.inputs[wanted.input] for one in known]
    shared = _shared_seeds(known, wanted.quantity)
    simulated = Estimate(math.nan, math.nan, len(shared), "seeds")
    if len(set(x)) > 1:
        table = [
            [one.values[wanted.quantity][seed] / _divisor(one, wanted) for one in known]
            for seed in shared
        ]
        simulated = jackknife_slope(x, np.array(table).reshape(len(shared), len(known)))
    formulas, remarks = [], []
    for formula in wanted.formulas:
        slope, remark = _formula_slope(formula, points, wanted)
        formulas.append((formula, slope))
        remarks.append(remark)
    row = _row(result, wanted, simulated, formulas, remarks, len(known))
    return Slope(wanted.factor, simulated, tuple(formulas), row)


def _shared_seeds(points: Sequence[PointResult], quantity: str) -> list[int]:
    """Seeds that all points have, in the order of the first point."""
    if not points:
        return []
    first, *others = (one.values[quantity] for one in points)
    return [seed for seed in first if all(seed in values for values in others)]


def _divisor(one: PointResult, wanted: SlopeReference) -> float:
    return one.inputs[wanted.per] if wanted.per else 1.0


def _formula_slope(
    formula: Formula, points: Sequence[PointResult], wanted: SlopeReference
) -> tuple[float, str]:
    """The slope of a formula over the points, and what there is to say of it."""
    try:
        x = [one.inputs[wanted.input] for one in points]
        if len(set(x)) < 2:
            return math.nan, f"{formula.title}: one value alone has no slope."
        y = [formula.value(one.inputs) / _divisor(one, wanted) for one in points]
        slope = straight_slope(x, y)
        outside = sum(bool(formula.outside(one.inputs)) for one in points)
    except FormulaError as error:
        return math.nan, str(error)
    text = f"{formula.title} {slope:.2f}"
    if outside:
        text += f" ({outside} of {len(points)} points are outside of its range)"
    elif not formula.counts_for_slopes:
        text += " (does not count for the verdict)"
    return slope, text + "."


def _row(result, wanted, simulated: Estimate, formulas, remarks, known: int) -> Row:
    points = result.along(wanted.factor)
    trusted = [
        slope
        for formula, slope in formulas
        if not math.isnan(slope)
        and formula.counts_for_slopes
        and not any(formula.outside(one.inputs) for one in points)
    ]
    low, high = (min(trusted), max(trusted)) if trusted else (math.nan, math.nan)
    remarks = [*remarks, f"{known} of {len(points)} points have runs."]
    if result.case.unjudged:
        verdict, remarks = Verdict.UNJUDGED, [result.case.unjudged, *remarks]
    elif not trusted:
        verdict = Verdict.UNJUDGED
    elif simulated.runs < LEAST_RUNS or math.isnan(simulated.interval) or known < 2:
        verdict = Verdict.FEW
    else:
        apart = max(low - simulated.mean, simulated.mean - high, 0.0)
        verdict = Verdict.WITHIN if apart <= simulated.interval else Verdict.OUTSIDE
    title = " to ".join(formula.title for formula, _ in formulas)
    source = "; ".join(dict.fromkeys(formula.source for formula, _ in formulas))
    divided = f"({wanted.quantity} / {wanted.per})" if wanted.per else wanted.quantity
    quantity = f"d ln {divided} / d ln {wanted.factor}"
    return Row(result.case.name, f"over {wanted.factor}", quantity, "1", simulated, title,
               (low + high) / 2, low, high, verdict, source, " ".join(remarks))  # fmt: skip
