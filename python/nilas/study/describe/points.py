"""The points of a study: which levels of the factors go together."""

from __future__ import annotations

import hashlib
import itertools
import re
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from nilas.study.describe.factor import Factor, Level
from nilas.study.describe.faults import StudyError
from nilas.study.describe.read_factors import level_of
from nilas.study.describe.study import Study

# Longer names of folders are hard to read, and some file systems refuse them.
_LONGEST_NAME = 80


@dataclass(frozen=True)
class Point:
    """One level of each factor. ``number`` counts from 1 in the order of the design."""

    number: int
    name: str
    levels: tuple[Level, ...]

    @property
    def overrides(self) -> tuple[tuple[str, str], ...]:
        return tuple(pair for level in self.levels for pair in level.overrides)


def points_of(study: Study) -> list[Point]:
    """All points of the design, without repetitions."""
    names: set[str] = set()
    points: list[Point] = []
    for levels in _rows(study):
        name = point_name(study.factors, levels)
        # A table may name a point twice, and coarse whole numbers may meet.
        if name not in names:
            names.add(name)
            points.append(Point(len(points) + 1, name, levels))
    return points


def row_names(study: Study) -> list[str]:
    """The name of the point of each row of the design, repetitions included."""
    return [point_name(study.factors, levels) for levels in _rows(study)]


def _rows(study: Study) -> Iterator[tuple[Level, ...]]:
    factors, design = study.factors, study.design
    if design.kind == "full":
        yield from itertools.product(*(factor.levels for factor in factors))
    elif design.kind == "one-at-a-time":
        base = tuple(factor.levels[0] for factor in factors)
        yield base
        for place, factor in enumerate(factors):
            for level in factor.levels[1:]:
                yield base[:place] + (level,) + base[place + 1 :]
    elif design.kind == "table":
        for row in design.rows:
            yield tuple(_level_of_row(factor, row[factor.name]) for factor in factors)
    else:
        for shares in shares_of(design.kind, len(factors), design.points, design.seed):
            yield tuple(
                factor.level_at(float(share)) for factor, share in zip(factors, shares, strict=True)
            )


def _level_of_row(factor: Factor, text: str) -> Level:
    """A value of a table: a level by its label, or any value where the factor names attributes."""
    for level in factor.levels:
        if level.label == text or level.label == level_of(text, ()).label:
            return level
    if not factor.paths:
        labels = ", ".join(level.label for level in factor.levels)
        raise StudyError(f"The factor {factor.name} has no value '{text}'. It has {labels}.")
    return level_of(text, factor.paths)


def shares_of(kind: str, dimensions: int, points: int, seed: int) -> np.ndarray:
    """Points in the unit cube, one a row, by ``scipy.stats.qmc``.

    ``saltelli`` gives, for each of ``points`` base points, the rows A, AB of each factor, and B,
    as Saltelli et al. (2010) need them: (dimensions + 2) rows each.

    >>> shares_of("sobol", 2, 4, 1).shape, shares_of("saltelli", 2, 4, 1).shape
    ((4, 2), (16, 2))
    """
    from scipy.stats import qmc

    if kind == "latin-hypercube":
        return qmc.LatinHypercube(dimensions, seed=seed).random(points)
    if kind == "sobol":
        return qmc.Sobol(dimensions, scramble=True, seed=seed).random(points)
    both = qmc.Sobol(2 * dimensions, scramble=True, seed=seed).random(points)
    first, second = both[:, :dimensions], both[:, dimensions:]
    rows = []
    for a, b in zip(first, second, strict=True):
        rows.append(a)
        for place in range(dimensions):
            mixed = a.copy()
            mixed[place] = b[place]
            rows.append(mixed)
        rows.append(b)
    return np.array(rows)


def point_name(factors: tuple[Factor, ...], levels: tuple[Level, ...]) -> str:
    """The name of a point's folder: its values where they fit, else a hash of them.

    The name depends on the values alone. So a study can get more values later, and finds the
    runs that are done.
    """
    if not factors:
        return "scene"
    parts = [f"{factor.name}-{level.label}" for factor, level in zip(factors, levels, strict=True)]
    name = "_".join(parts)
    if len(name) <= _LONGEST_NAME and re.fullmatch(r"[\w.+-]+", name):
        return name
    digest = hashlib.sha256("\n".join(parts).encode()).hexdigest()
    return f"point-{digest[:12]}"
