"""What a study shows, in sentences."""

from __future__ import annotations

import math

import numpy as np

from nilas.study.results.anova import Anova
from nilas.study.results.collected import Collected
from nilas.study.results.regression import Slopes
from nilas.study.results.response_data import ResponseData
from nilas.study.results.scatter import Scatter
from nilas.study.results.sobol import SobolIndices

_SURE = 0.05
_STRAIGHT = 0.7
_WIDE = 0.2


def headline(collected: Collected) -> list[str]:
    """The state of the study: what is done, what failed, what is missing."""
    rows, study = collected.rows, collected.plan.study
    done = len(rows) - len(collected.failed)
    points = len(collected.plan.points)
    sentences = [f"{done} runs at {points} points are done."]
    if collected.failed:
        sentences.append(
            f"{len(collected.failed)} runs failed; they are listed below with their reasons."
        )
    if collected.missing:
        sentences.append(f"{collected.missing} runs are still missing, so all figures may change.")
    if study.seeds.until:
        until = study.seeds.until
        bound = f"{100 * until.relative_error:g} % of {until.response}"
        if collected.unsettled:
            sentences.append(
                f"At {collected.unsettled} points {until.most} seeds were not enough for a "
                f"standard error below {bound}."
            )
        elif not collected.missing:
            sentences.append(f"The standard error is below {bound} at every point.")
    programs = {row.made_by["program_sha256"] for row in rows if row.made_by["program_sha256"]}
    if len(programs) > 1:
        sentences.append(
            f"{len(programs)} builds of the program made these runs. To compare them, make "
            f"all with one build."
        )
    early = sum(bool(row.message) and row.status == "done" for row in rows)
    if early:
        sentences.append(
            f"{early} runs ended before their time, or lack a value; study.csv says why."
        )
    return sentences


def findings(
    data: ResponseData, anova: Anova | None, slopes: Slopes | None, sobol: SobolIndices | None
) -> list[str]:
    """What one response shows."""
    sentences = [_range(data)] if data.rows else ["No run has a value of it yet."]
    if anova:
        sentences += _shares(data, anova)
    if sobol:
        sentences.append(_strongest(data, sobol))
    if slopes:
        sentences += _directions(data, slopes)
    return sentences


def _range(data: ResponseData) -> str:
    known = [(data.scatter(point), point) for point in data.points if data.of_points[point.number]]
    unit = f" {data.response.unit}" if data.response.unit else ""
    low = min(known, key=lambda one: one[0].mean)
    high = max(known, key=lambda one: one[0].mean)
    if low[0].mean == high[0].mean and data.values.std() == 0.0:
        return f"It is {low[0].mean:.6g}{unit} in every run."
    if len(known) == 1:
        return f"The mean is {with_interval(low[0])}{unit}."

    def place(point) -> str:
        pairs = zip(data.factors, point.levels, strict=True)
        return ", ".join(f"{factor.name} {level.label}" for factor, level in pairs)

    return (
        f"The mean of a point goes from {with_interval(low[0])}{unit} ({place(low[1])}) "
        f"to {with_interval(high[0])}{unit} ({place(high[1])})."
    )


def _shares(data: ResponseData, anova: Anova) -> list[str]:
    names = [
        " with ".join(data.factors[k].name for k in effect.factors) for effect in anova.effects
    ]
    ranked = sorted(zip(names, anova.effects, strict=True), key=lambda one: -one[1].share)
    sure = [(name, effect) for name, effect in ranked if effect.probability < _SURE]
    sentences = []
    if anova.seeds == 1:
        name, effect = ranked[0]
        sentences.append(
            f"Most of the scatter, {100 * effect.share:.0f} %, comes with {name}. "
            "With one seed a point, chance is not known: more seeds tell it."
        )
        return sentences
    if sure:
        told = ", ".join(f"{name} {100 * effect.share:.0f} %" for name, effect in sure)
        sentences.append(f"Shares of the scatter that chance does not explain: {told}.")
    weak = [name for name, effect in ranked if not effect.probability < _SURE]
    if weak:
        sentences.append(f"Not to be told from chance: {', '.join(weak)}.")
    sentences.append(f"The ice of different seeds makes {100 * anova.chance:.0f} % of the scatter.")
    return sentences


def _strongest(data: ResponseData, sobol: SobolIndices) -> str:
    best = int(np.argmax(sobol.total))
    alone, together = (100 * min(float(index[best]), 1.0) for index in (sobol.first, sobol.total))
    text = (
        f"{data.factors[best].name} matters most: {alone:.0f} % of the variance alone, "
        f"{max(together, alone):.0f} % together with the other factors."
    )
    if max(sobol.total_interval[best], sobol.first_interval[best]) > _WIDE:
        text += " The intervals are wide: twice the points make them 0.7 times as wide."
    return text


def _directions(data: ResponseData, slopes: Slopes) -> list[str]:
    sentences = []
    order = np.argsort(-np.abs(slopes.slope))
    up = [data.numeric[k].name for k in order if slopes.slope[k] > slopes.interval[k]]
    down = [data.numeric[k].name for k in order if -slopes.slope[k] > slopes.interval[k]]
    if up:
        sentences.append(f"It rises with {', '.join(up)}.")
    if down:
        sentences.append(f"It falls with {', '.join(down)}.")
    if slopes.explained < _STRAIGHT:
        sentences.append(
            f"Straight lines explain only {100 * slopes.explained:.0f} % of the scatter, "
            f"so the slopes tell a part of it."
        )
    return sentences


def with_interval(scatter: Scatter) -> str:
    """Mean and interval to the digits that the interval allows.

    >>> with_interval(Scatter(4, 41.234, 2.0, 1.0, 3.18))
    '41.2 ± 3.2'
    >>> with_interval(Scatter(1, 41.2, *3 * [math.nan]))
    '41.2'
    """
    if not math.isfinite(scatter.interval):
        return f"{scatter.mean:.3g}"
    if scatter.interval == 0.0:
        return f"{scatter.mean:.4g} ± 0"
    digits = max(1 - math.floor(math.log10(scatter.interval)), 0)
    return f"{scatter.mean:.{min(digits, 12)}f} ± {scatter.interval:.{min(digits, 12)}f}"
