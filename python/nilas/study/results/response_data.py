"""The values of one response with their factors, ready for plots and fits."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from nilas.study.describe.factor import Factor
from nilas.study.describe.points import Point, row_names
from nilas.study.describe.study import Response
from nilas.study.results.anova import Anova, analyse
from nilas.study.results.collected import Collected, Row
from nilas.study.results.regression import Slopes, Surface, fit_surface, standardised_slopes
from nilas.study.results.scatter import Scatter, scatter_of
from nilas.study.results.sobol import SobolIndices, sobol_indices


@dataclass
class ResponseData:
    """One response over all runs that have it.

    ``rows`` and ``values`` go together. ``of_points``: the values of each point by its number.
    ``numeric``: the factors that are numbers and vary. ``x``: their values, a row for each run;
    logarithms where the factor is logarithmic.
    """

    collected: Collected
    response: Response
    rows: list[Row]
    values: np.ndarray
    of_points: dict[int, list[float]]
    numeric: list[Factor]
    x: np.ndarray

    @property
    def points(self) -> list[Point]:
        return self.collected.plan.points

    @property
    def factors(self) -> tuple[Factor, ...]:
        return self.collected.plan.study.factors

    def scatter(self, point: Point) -> Scatter:
        return scatter_of(self.of_points[point.number])

    def slopes(self) -> Slopes | None:
        return standardised_slopes(self.x, self.values) if self.numeric else None

    def surface(self) -> Surface | None:
        return fit_surface(self.x, self.values) if self.numeric else None

    def anova(self) -> Anova | None:
        """The analysis of variance, where the design is full and has all of its points."""
        study = self.collected.plan.study
        if study.design.kind != "full" or not study.factors:
            return None
        levels = [len(factor.levels) for factor in study.factors]
        if len(self.points) != int(np.prod(levels)):
            return None
        return analyse(levels, [self.of_points[point.number] for point in self.points])

    def sobol(self) -> SobolIndices | None:
        study = self.collected.plan.study
        if study.design.kind != "saltelli":
            return None
        means = {point.name: self.scatter(point) for point in self.points}
        values = [means[name].mean if means[name].count else None for name in row_names(study)]
        return sobol_indices(values, len(study.factors))


def response_data(collected: Collected, place: int) -> ResponseData:
    """The data of the response number ``place``."""
    rows = [row for row in collected.rows if row.values[place] is not None]
    values = np.array([row.values[place] for row in rows], dtype=float)
    factors = collected.plan.study.factors
    columns, numeric = [], []
    for number, factor in enumerate(factors):
        if not factor.is_numeric:
            continue
        column = np.array([row.run.point.levels[number].number for row in rows], dtype=float)
        if len(set(column)) > 1:
            numeric.append(factor)
            columns.append(np.log(column) if factor.logarithmic else column)
    x = np.column_stack(columns) if columns else np.zeros((len(rows), 0))
    response = collected.plan.study.responses[place]
    return ResponseData(collected, response, rows, values, collected.values_of(place), numeric, x)
