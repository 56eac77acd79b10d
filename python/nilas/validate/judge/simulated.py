"""What the runs of a case gave: means at each point, and how well they are known."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from nilas.study.carry_out.records import Records
from nilas.study.describe.points import Point
from nilas.study.results.collected import Collected, collect
from nilas.study.results.scatter import scatter_of
from nilas.validate.cases.case import Case
from nilas.validate.cases.scene_values import inputs_at, scale_of
from nilas.validate.formulas.formula import SCALE_POWERS

# A response of this name next to QUANTITY holds the error that each run states of it.
STATED = "_stated_error"


@dataclass(frozen=True)
class Estimate:
    """A mean over runs and the half width of its interval of 95 %.

    ``by``: what the interval was taken from, ``seeds`` or ``single runs``. NaN: not known.
    """

    mean: float
    interval: float
    runs: int
    by: str

    @property
    def relative(self) -> float:
        return self.interval / abs(self.mean) if self.mean else math.inf


@dataclass(frozen=True)
class PointResult:
    """What is known of a point.

    ``values``: by quantity and seed, at the scale of the scene file.
    """

    point: Point
    label: str
    inputs: Mapping[str, float]
    values: Mapping[str, Mapping[int, float]]
    failed: int

    def estimate(self, quantity: str) -> Estimate:
        """Mean and interval: the wider of that between seeds and that which runs state."""
        values = list(self.values.get(quantity, {}).values())
        stated = list(self.values.get(quantity + STATED, {}).values())
        scatter = scatter_of(values)
        between = scatter.interval
        within = math.nan
        if stated and values:
            within = math.sqrt(math.fsum(one**2 for one in stated) / len(stated) / len(values))
        if math.isnan(between) or within > between:
            return Estimate(scatter.mean, within, scatter.count, "single runs")
        return Estimate(scatter.mean, between, scatter.count, "seeds")


@dataclass(frozen=True)
class CaseResult:
    """All points of a case. The first is the base, from which the others differ."""

    case: Case
    points: tuple[PointResult, ...]
    collected: Collected

    @property
    def base(self) -> PointResult:
        return self.points[0]

    def along(self, factor: str) -> list[PointResult]:
        """The points at which all other factors have the level of the base."""
        place = [one.name for one in self.case.study.factors].index(factor)
        return [one for one in self.points if _differs(self.base.point, one.point) <= {place}]

    def unit(self, quantity: str) -> str:
        return next(one.unit for one in self.case.study.responses if one.name == quantity)


def result_of(case: Case) -> CaseResult:
    """Gathers the finished runs of a case. Points without any run are there, too."""
    plan = case.plan()
    collected = collect(plan, Records(plan))
    values: dict[int, dict[str, dict[int, float]]] = {one.number: {} for one in plan.points}
    failed = {one.number: 0 for one in plan.points}
    for row in collected.rows:
        point = row.run.point
        failed[point.number] += row.status != "done"
        scale = scale_of(case.study, point)
        for response, value in zip(case.study.responses, row.values, strict=True):
            if value is not None:
                power = SCALE_POWERS.get(response.unit, 0.0)
                of_quantity = values[point.number].setdefault(response.name, {})
                of_quantity[row.run.seed] = value / scale**power
    points = [
        PointResult(
            point,
            label_of(case, plan.points[0], point),
            inputs_at(case.study, case.inputs, point),
            values[point.number],
            failed[point.number],
        )
        for point in plan.points
    ]
    return CaseResult(case, tuple(points), collected)


def label_of(case: Case, base: Point, point: Point) -> str:
    """The factors in which a point differs from the base; of a measured table all of them."""
    factors = case.study.factors
    places: Sequence[int] = sorted(_differs(base, point))
    if case.study.design.kind in ("table", "full"):
        places = range(len(factors))
    words = []
    for place in places:
        unit = f" {factors[place].unit}" if factors[place].unit else ""
        words.append(f"{factors[place].name} {point.levels[place].label}{unit}")
    return ", ".join(words) or "base"


def _differs(base: Point, point: Point) -> set[int]:
    pairs = zip(base.levels, point.levels, strict=True)
    return {place for place, (one, other) in enumerate(pairs) if one.label != other.label}
