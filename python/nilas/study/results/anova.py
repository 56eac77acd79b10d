"""Analysis of variance of a full design: which factor makes how much of the scatter."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Effect:
    """``share``: part of the sum of squares. ``probability``: that chance alone makes as much; NaN
    where runs were not repeated, so that chance is not known."""

    factors: tuple[int, ...]
    share: float
    probability: float


@dataclass(frozen=True)
class Anova:
    """Effects of single factors and of pairs; the rest of all factors together; chance.

    ``seeds``: values of each point that were used, the same number everywhere.
    """

    effects: tuple[Effect, ...]
    higher: float
    chance: float
    seeds: int


def analyse(levels: Sequence[int], values: Sequence[Sequence[float]]) -> Anova | None:
    """The analysis of a full design.

    ``levels``: number of levels of each factor. ``values``: the values of each point, with the
    last factor changing fastest. Points get the same number of values, that of the poorest one:
    then the parts are orthogonal and add up. None where a point has no value, or nothing scatters.

    >>> found = analyse([2, 2], [[0.0], [0.0], [1.0], [1.0]])
    >>> [round(effect.share, 3) for effect in found.effects]
    [1.0, 0.0, 0.0]
    """
    seeds = min((len(of_point) for of_point in values), default=0)
    if seeds == 0 or not levels:
        return None
    data = np.array([list(of_point[:seeds]) for of_point in values]).reshape(*levels, seeds)
    total = float(((data - data.mean()) ** 2).sum())
    if total <= 0.0 or not math.isfinite(total):
        return None
    means = data.mean(axis=-1)
    chance = float(((data - means[..., None]) ** 2).sum())
    freedom = means.size * (seeds - 1)
    effects = []
    parts: dict[tuple[int, ...], np.ndarray] = {(): np.full(means.shape, means.mean())}
    explained = 0.0
    for size in (1, 2):
        for chosen in itertools.combinations(range(len(levels)), size):
            part = _part(means, chosen, parts)
            parts[chosen] = part
            squares = seeds * float((part**2).sum())
            explained += squares
            own = math.prod(levels[axis] - 1 for axis in chosen)
            effects.append(
                Effect(chosen, squares / total, _probability(squares, own, chance, freedom))
            )
    higher = max(total - chance - explained, 0.0) / total
    return Anova(tuple(effects), higher, chance / total, seeds)


def _part(
    means: np.ndarray, chosen: tuple[int, ...], parts: dict[tuple[int, ...], np.ndarray]
) -> np.ndarray:
    """The mean over all other factors, less the parts of smaller sets."""
    others = tuple(axis for axis in range(means.ndim) if axis not in chosen)
    part = np.broadcast_to(means.mean(axis=others, keepdims=True), means.shape).copy()
    for smaller, known in parts.items():
        if set(smaller) < set(chosen):
            part -= known
    return part


def _probability(squares: float, own: int, chance: float, freedom: int) -> float:
    if freedom == 0 or own == 0:
        return math.nan
    if chance <= 0.0:
        return 0.0 if squares > 0.0 else 1.0
    from scipy.stats import f

    return float(f.sf(squares / own / (chance / freedom), own, freedom))
