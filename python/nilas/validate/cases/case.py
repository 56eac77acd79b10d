"""A case of validation as plain values, as its file describes it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from nilas.study.describe.plan import Plan
from nilas.study.describe.study import Study
from nilas.validate.formulas import Formula
from nilas.validate.measured.rows import MeasuredRow


@dataclass(frozen=True)
class Reference:
    """What a quantity is compared with, at each point.

    ``formulas``: one formula, or several whose values make an envelope. ``least``: the smallest of
    their values counts instead. ``at_most``: it is an upper bound, and smaller is right too.
    ``same_over``: factors over which the quantity should not change, from that of the first point.
    ``value``: a number that the quantity should have, with its ``source``. ``where``: the levels of
    factors at which the reference holds; factors that are not named may have any.
    """

    quantity: str
    formulas: tuple[Formula, ...] = ()
    least: bool = False
    at_most: bool = False
    where: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    same_over: tuple[str, ...] = ()
    value: float | None = None
    source: str = ""
    remark: str = ""


@dataclass(frozen=True)
class SlopeReference:
    """The slope d ln quantity / d ln factor beside those of formulas.

    ``input``: the input of the formulas that the factor is. ``per``: an input by which the quantity
    is divided first, as a load by its area, or nothing.
    """

    quantity: str
    factor: str
    input: str
    formulas: tuple[Formula, ...]
    per: str = ""


@dataclass(frozen=True)
class Slice:
    """The small part of a case that takes seconds. ``points``: numbers of points, from 1."""

    seeds: int
    points: tuple[int, ...]
    overrides: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Case:
    """One case.

    ``minutes``: processor time that it takes, as far as it was measured. ``inputs``: inputs of
    formulas as numbers or as paths of attributes of the scene. ``unjudged``: why no verdict is
    given for the whole case, or nothing.
    """

    file: Path
    name: str
    title: str
    question: str
    minutes: float
    study: Study
    inputs: Mapping[str, float | str]
    references: tuple[Reference, ...]
    slopes: tuple[SlopeReference, ...]
    slice: Slice
    measured: tuple[MeasuredRow, ...] = ()
    unjudged: str = ""
    points: tuple[int, ...] = field(default=())

    def placed(self, folder: Path) -> Case:
        """The same case with its study in ``folder``."""
        return replace(self, study=replace(self.study, out=(folder / self.name).absolute()))

    def sliced(self) -> Case:
        """The small part of the case, as a case. What it sets goes before what factors set."""
        part = dict(self.slice.overrides)
        factors = tuple(
            replace(
                factor,
                levels=tuple(
                    replace(
                        level,
                        overrides=tuple(
                            (path, part.get(path, value)) for path, value in level.overrides
                        ),
                    )
                    for level in factor.levels
                ),
            )
            for factor in self.study.factors
        )
        study = replace(
            self.study,
            factors=factors,
            overrides=tuple((dict(self.study.overrides) | part).items()),
            seeds=replace(self.study.seeds, count=self.slice.seeds, chosen=(), until=None),
        )
        return replace(self, study=study, points=self.slice.points)

    def plan(self, seeds: int | None = None) -> Plan:
        """The plan of the case, of its first ``seeds`` seeds at each point where given."""
        study = self.study
        if seeds is not None and seeds < study.seeds.count:
            fewer = replace(study.seeds, count=seeds, chosen=study.seeds.chosen[:seeds], until=None)
            study = replace(study, seeds=fewer)
        plan = Plan(study)
        if self.points:
            chosen = [point for point in plan.points if point.number in self.points]
            plan = Plan(study, chosen)
        return plan
