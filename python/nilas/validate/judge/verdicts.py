"""Verdicts: simulated means beside references, in words."""

from __future__ import annotations

import enum
import math
from collections.abc import Iterator
from dataclasses import dataclass

from nilas.study.describe.points import Point
from nilas.study.results.scatter import scatter_of
from nilas.validate.cases.case import Reference
from nilas.validate.formulas import Formula, FormulaError
from nilas.validate.judge.simulated import CaseResult, Estimate, PointResult

LEAST_RUNS = 3
# A mean that is known worse than this agrees with nearly everything.
LARGEST_ERROR = 0.5


class Verdict(enum.Enum):
    """What a comparison says."""

    WITHIN = "within"
    OUTSIDE = "outside by more than its error"
    OUT_OF_RANGE = "outside the formula's range"
    FEW = "not enough runs"
    UNJUDGED = "not judged"


@dataclass(frozen=True)
class Row:
    """One comparison.

    ``low`` and ``high``: the envelope, or the interval of a measured value. A bound has no ``low``,
    which is then minus infinity.
    """

    case: str
    point: str
    quantity: str
    unit: str
    simulated: Estimate
    reference: str
    value: float
    low: float
    high: float
    verdict: Verdict
    source: str
    remark: str = ""

    @property
    def ratio(self) -> float:
        """The simulated mean over the reference; NaN where the reference is no number or 0."""
        return self.simulated.mean / self.value if self.value else math.nan


def rows_of(result: CaseResult) -> list[Row]:
    """All comparisons of a case, reference by reference."""
    rows = []
    for reference in result.case.references:
        if reference.same_over:
            rows += _same_rows(result, reference)
        else:
            for one in result.points:
                rows += _point_rows(result, reference, one)
    rows += _measured_rows(result)
    return [_unjudged(row, result.case.unjudged) for row in rows] if result.case.unjudged else rows


def is_known(estimate: Estimate) -> bool:
    """Whether a mean is known well enough for a verdict."""
    return estimate.runs >= LEAST_RUNS and estimate.relative <= LARGEST_ERROR


def _point_rows(result: CaseResult, reference: Reference, one: PointResult) -> Iterator[Row]:
    if not holds_at(reference, result, one.point):
        return
    if reference.value is not None:
        yield _value_row(result, reference, one)
    elif reference.least:
        yield _least_row(result, reference, one)
    elif len(reference.formulas) > 1:
        yield _envelope_row(result, reference, one)
    elif reference.formulas:
        yield _formula_row(result, reference, one)


def _formula_row(result: CaseResult, reference: Reference, one: PointResult) -> Row:
    formula = reference.formulas[0]
    estimate = one.estimate(reference.quantity)
    value, reasons = _evaluated(formula, one)
    if math.isnan(value) or reasons:
        verdict = Verdict.OUT_OF_RANGE
    elif formula.doubt:
        verdict, reasons = Verdict.UNJUDGED, [formula.doubt]
    else:
        verdict = _compared(estimate, value, value)
    return _row(result, reference, one, estimate, formula.title, (value, value, value), verdict,
                formula.source, reasons)  # fmt: skip


def _envelope_row(result: CaseResult, reference: Reference, one: PointResult) -> Row:
    estimate = one.estimate(reference.quantity)
    values, reasons, doubts = [], [], []
    for formula in reference.formulas:
        value, why = _evaluated(formula, one)
        reasons += [f"{formula.title}: {text}" for text in why]
        if not math.isnan(value):
            values.append(value)
        if formula.doubt:
            doubts.append(f"{formula.title}: {formula.doubt}")
    low, high = (min(values), max(values)) if values else (math.nan, math.nan)
    middle = math.sqrt(low * high) if values and low > 0 else (low + high) / 2
    if reasons or not values:
        verdict = Verdict.OUT_OF_RANGE
    elif doubts:
        verdict, reasons = Verdict.UNJUDGED, doubts
    else:
        verdict = _compared(estimate, low, high)
    title = " to ".join(formula.title for formula in reference.formulas)
    source = "; ".join(dict.fromkeys(formula.source for formula in reference.formulas))
    return _row(result, reference, one, estimate, title, (middle, low, high), verdict, source,
                reasons)  # fmt: skip


def _least_row(result: CaseResult, reference: Reference, one: PointResult) -> Row:
    """Against the smallest of the formulas' values, which may be an upper bound alone."""
    estimate = one.estimate(reference.quantity)
    values, reasons, doubts = [], [], []
    for formula in reference.formulas:
        value, why = _evaluated(formula, one)
        reasons += [f"{formula.title}: {text}" for text in why]
        values.append(value)
        if formula.doubt:
            doubts.append(f"{formula.title}: {formula.doubt}")
    value = min(values)
    low = -math.inf if reference.at_most else value
    if reasons or math.isnan(math.fsum(values)):
        verdict = Verdict.OUT_OF_RANGE
    elif doubts:
        verdict, reasons = Verdict.UNJUDGED, doubts
    else:
        verdict = _compared(estimate, low, value)
        smallest = reference.formulas[values.index(value)]
        reasons = [f"The least is {smallest.title}."] if len(values) > 1 else []
    title = " and ".join(formula.title for formula in reference.formulas)
    title = f"at most {title}" if reference.at_most else f"the least of {title}"
    source = "; ".join(dict.fromkeys(formula.source for formula in reference.formulas))
    return _row(result, reference, one, estimate, title, (value, low, value), verdict, source,
                reasons)  # fmt: skip


def _value_row(result: CaseResult, reference: Reference, one: PointResult) -> Row:
    value = float(reference.value or 0.0)
    estimate = one.estimate(reference.quantity)
    low = -math.inf if reference.at_most else value
    # A mean that should be 0 has no relative error; its own error decides.
    few = estimate.runs < LEAST_RUNS
    verdict = Verdict.FEW if few else _compared(estimate, low, value, demand_known=bool(value))
    title = f"at most {value:g}" if reference.at_most else f"{value:g}"
    return _row(result, reference, one, estimate, title, (value, low, value), verdict,
                reference.source, [])  # fmt: skip


def _same_rows(result: CaseResult, reference: Reference) -> Iterator[Row]:
    """Each other level of the factors against the base, over the same seeds."""
    base = result.base
    for factor in reference.same_over:
        for one in result.along(factor):
            if one is not base:
                yield _same_row(result, reference, base, one)


def _same_row(result: CaseResult, reference: Reference, base: PointResult, one: PointResult) -> Row:
    quantity = reference.quantity
    mine, theirs = one.values.get(quantity, {}), base.values.get(quantity, {})
    shared = [seed for seed in mine if seed in theirs]
    difference = scatter_of([mine[seed] - theirs[seed] for seed in shared])
    mean = scatter_of([theirs[seed] for seed in shared]).mean
    own = scatter_of([mine[seed] for seed in shared]).mean
    estimate = Estimate(own, difference.interval, len(shared), "differences of the same seeds")
    if len(shared) < LEAST_RUNS or not difference.interval <= LARGEST_ERROR * abs(mean):
        verdict = Verdict.FEW
    else:
        verdict = _compared(estimate, mean, mean, demand_known=False)
    remark = []
    if mean and not math.isnan(own):
        remark = [
            f"It differs by {100 * (own / mean - 1):+.2g} % ± "
            f"{100 * difference.interval / abs(mean):.2g} %, by the same seeds."
        ]
    title = f"same as at {_levels_text(result, base.point, one.point)}"
    return _row(result, reference, one, estimate, title, (mean, mean, mean), verdict,
                reference.source or "the case itself", remark)  # fmt: skip


def _measured_rows(result: CaseResult) -> Iterator[Row]:
    factors = [factor.name for factor in result.case.study.factors]
    for measured in result.case.measured:
        for one in result.points:
            labels = {
                name: level.label for name, level in zip(factors, one.point.levels, strict=True)
            }
            if not _same_conditions(labels, measured.conditions):
                continue
            for quantity, found in measured.quantities.items():
                estimate = one.estimate(quantity)
                own = 0.0 if math.isnan(found.interval) else found.interval
                low, high = found.value - own, found.value + own
                joint = Estimate(
                    estimate.mean, math.hypot(estimate.interval, own), estimate.runs, estimate.by
                )
                verdict = _compared(joint, found.value, found.value)
                reasons = [measured.remark] if measured.remark else []
                if math.isnan(found.interval):
                    reasons.append("The source does not state how well its mean is known.")
                title = f"measured, test {measured.test}"
                yield _row(result, Reference(quantity), one, estimate, title,
                           (found.value, low, high), verdict, measured.source, reasons)  # fmt: skip


def holds_at(reference: Reference, result: CaseResult, point: Point) -> bool:
    """Whether a point has the levels of factors to which a reference is confined."""
    labels = {
        factor.name: level.label
        for factor, level in zip(result.case.study.factors, point.levels, strict=True)
    }
    return all(labels[name] in wanted for name, wanted in reference.where.items())


def _same_conditions(labels: dict[str, str], conditions) -> bool:
    for name, text in conditions.items():
        try:
            if not math.isclose(float(labels[name]), float(text), rel_tol=1e-9):
                return False
        except ValueError:
            if labels[name] != text:
                return False
    return True


def _evaluated(formula: Formula, one: PointResult) -> tuple[float, list[str]]:
    try:
        return formula.value(one.inputs), formula.outside(one.inputs)
    except FormulaError as error:
        return math.nan, [str(error)]


def _compared(estimate: Estimate, low: float, high: float, *, demand_known: bool = True) -> Verdict:
    """Whether the interval of the mean meets that of the reference."""
    if math.isnan(estimate.mean) or math.isnan(estimate.interval):
        return Verdict.FEW
    # What lies below a bound with all of its interval needs not be known better.
    below = math.isinf(low) and estimate.runs >= LEAST_RUNS
    below = below and estimate.mean + estimate.interval <= high
    if demand_known and not below and not is_known(estimate):
        return Verdict.FEW
    apart = max(low - estimate.mean, estimate.mean - high, 0.0)
    return Verdict.WITHIN if apart <= estimate.interval else Verdict.OUTSIDE


def _row(result, reference, one, estimate, title, values, verdict, source, reasons) -> Row:
    reasons = list(reasons)
    if reference.remark:
        reasons.append(reference.remark)
    if one.failed:
        reasons.append(f"{one.failed} runs failed.")
    value, low, high = values
    return Row(result.case.name, one.label, reference.quantity, result.unit(reference.quantity),
               estimate, title, value, low, high, verdict, source, " ".join(reasons))  # fmt: skip


def _levels_text(result: CaseResult, base: Point, point: Point) -> str:
    factors = result.case.study.factors
    words = [
        f"{factor.name} {one.label}"
        for factor, one, other in zip(factors, base.levels, point.levels, strict=True)
        if one.label != other.label
    ]
    return ", ".join(words)


def _unjudged(row: Row, why: str) -> Row:
    """The same row without a verdict, as far as it had one."""
    if row.verdict not in (Verdict.WITHIN, Verdict.OUTSIDE):
        return row
    return Row(
        **{**row.__dict__, "verdict": Verdict.UNJUDGED, "remark": f"{why} {row.remark}".strip()}
    )
