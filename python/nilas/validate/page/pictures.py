"""Pictures of a case: loads over each factor beside the formulas, and slopes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from nilas.study.describe.factor import Factor
from nilas.study.results.drawing import (
    ACCENT,
    INK,
    PARTS,
    SOFT,
    WARM,
    figure,
    grid_of_axes,
    svg_of,
)
from nilas.validate.formulas import Formula, FormulaError
from nilas.validate.judge.simulated import CaseResult, PointResult
from nilas.validate.judge.slopes import Slope
from nilas.validate.judge.verdicts import Row, Verdict, holds_at

# Colours of verdicts, which the page uses too.
COLOURS = {
    Verdict.WITHIN: "#2e7d32",
    Verdict.OUTSIDE: WARM,
    Verdict.OUT_OF_RANGE: SOFT,
    Verdict.FEW: SOFT,
    Verdict.UNJUDGED: SOFT,
}
_MARKS = ("s", "^", "v", "D", "P", "X", "<", ">")
# A bound that is higher than this many times the runs is named in the legend alone.
_SIGHT = 3.0


@dataclass(frozen=True)
class _Line:
    """What a quantity is drawn beside: the smallest value of ``formulas``.

    ``points``: numbers of the points at which it holds.
    """

    title: str
    formulas: tuple[Formula, ...]
    points: frozenset[int]
    is_bound: bool = False

    @property
    def doubted(self) -> bool:
        return any(formula.doubt for formula in self.formulas)

    def value(self, one: PointResult) -> float:
        values = [_value(formula, one) for formula in self.formulas]
        if one.point.number not in self.points or any(map(math.isnan, values)):
            return math.nan
        return min(values)

    def scale(self, values: Sequence[float], highest: float) -> list[float]:
        """The values that the picture must hold: none in doubt, and no bound far above the runs."""
        finite = [value for value in values if math.isfinite(value)]
        if self.doubted:
            return []
        return [one for one in finite if one <= _SIGHT * highest] if self.is_bound else finite


def plot_factors(result: CaseResult, quantity: str) -> str | None:
    """The quantity over each factor of the case, or None where nothing varies or nothing ran."""
    factors = [one for one in result.case.study.factors if len(result.along(one.name)) > 1]
    if not factors or not any(one.values.get(quantity) for one in result.points):
        return None
    fig, axes = grid_of_axes(len(factors), sharey=False)
    lines = _lines(result, quantity)
    for factor, one in zip(factors, axes, strict=True):
        _plot_factor(one, result, factor, quantity, lines)
    unit = result.unit(quantity)
    for place, one in enumerate(axes):
        if place % 3 == 0:
            one.set_ylabel(f"{quantity} [{unit}]" if unit else quantity)
    handles, labels = axes[0].get_legend_handles_labels()
    _legend(fig, handles, labels)
    return svg_of(fig, title=f"{quantity} of {result.case.name} over each factor")


def plot_points(rows: Sequence[Row], title: str) -> str | None:
    """Simulated means beside their references, point by point: for cases without one base."""
    shown = [row for row in rows if math.isfinite(row.simulated.mean)]
    if not shown:
        return None
    fig, (axes,) = figure(8.6, 1.2 + 0.3 * len(shown))
    places = range(len(shown))
    for place, row in zip(places, shown, strict=True):
        colour = COLOURS[row.verdict]
        if math.isfinite(row.low):
            axes.plot([row.low, row.high], [place, place], color=ACCENT, alpha=0.35, linewidth=7)
            axes.plot(row.value, place, marker="|", color=ACCENT, markersize=11)
        error = row.simulated.interval if math.isfinite(row.simulated.interval) else 0.0
        axes.errorbar(row.simulated.mean, place, xerr=error, fmt="o", color=colour, capsize=3)
    labels = [f"{row.point}: {row.reference}" for row in shown]
    axes.set_yticks(list(places), labels, fontsize=8)
    axes.invert_yaxis()
    axes.set_xlabel(f"{shown[0].quantity} [{shown[0].unit}]")
    return svg_of(fig, title=title)


def plot_slopes(slopes: Sequence[Slope], name: str) -> str | None:
    """Slopes with their intervals, and the slopes of the formulas as marks."""
    shown = [one for one in slopes if math.isfinite(one.simulated.mean)]
    if not shown:
        return None
    fig, (axes,) = figure(7.2, 1.4 + 0.45 * len(shown))
    formulas = list(dict.fromkeys(formula.title for one in shown for formula, _ in one.formulas))
    for place, one in enumerate(shown):
        if math.isfinite(one.row.low):
            axes.plot(
                [one.row.low, one.row.high], [place] * 2, color=ACCENT, alpha=0.2, linewidth=12
            )
        error = one.simulated.interval if math.isfinite(one.simulated.interval) else 0.0
        axes.errorbar(
            one.simulated.mean, place, xerr=error, fmt="o", color=COLOURS[one.row.verdict],
            capsize=4, label="runs" if place == 0 else None, zorder=4,
        )  # fmt: skip
        for formula, slope in one.formulas:
            number = formulas.index(formula.title)
            axes.plot(slope, place, _MARKS[number % len(_MARKS)], color=PARTS[number % len(PARTS)],
                      markerfacecolor="none")  # fmt: skip
    for number, title in enumerate(formulas):
        axes.plot([], [], _MARKS[number % len(_MARKS)], color=PARTS[number % len(PARTS)],
                  markerfacecolor="none", label=title)  # fmt: skip
    axes.set_yticks(range(len(shown)), [one.factor for one in shown])
    axes.invert_yaxis()
    axes.set_xlabel("slope d ln quantity / d ln factor")
    axes.axvline(0.0, color=INK, linewidth=0.7)
    _legend(fig, *axes.get_legend_handles_labels())
    return svg_of(fig, title=f"slopes of {name}")


def _legend(fig, handles, labels) -> None:
    """A legend below the axes; the picture grows by it."""
    fig.legend(handles, labels, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=4)


def _lines(result: CaseResult, quantity: str) -> list[_Line]:
    found = []
    for reference in result.case.references:
        if reference.quantity != quantity or not reference.formulas:
            continue
        points = frozenset(
            one.point.number for one in result.points if holds_at(reference, result, one.point)
        )
        if reference.least:
            kind = "At most" if reference.at_most else "The least of"
            titles = " and ".join(formula.title for formula in reference.formulas)
            title = f"{kind}: {titles}"
            found.append(_Line(title, reference.formulas, points, reference.at_most))
        else:
            found += [_Line(formula.title, (formula,), points) for formula in reference.formulas]
    return list(dict.fromkeys(found))


def _plot_factor(
    axes, result: CaseResult, factor: Factor, quantity: str, lines: Sequence[_Line]
) -> None:
    points = result.along(factor.name)
    place = [one.name for one in result.case.study.factors].index(factor.name)
    numeric = factor.is_numeric
    if numeric:
        points = sorted(points, key=lambda one: one.point.levels[place].number or 0.0)
    x = [
        (one.point.levels[place].number or 0.0) if numeric else float(number)
        for number, one in enumerate(points)
    ]
    estimates = [one.estimate(quantity) for one in points]
    error = [one.interval if math.isfinite(one.interval) else 0.0 for one in estimates]
    known = [one.mean + width for one, width in zip(estimates, error, strict=True)]
    highest = max(filter(math.isfinite, known), default=0.0)
    low = [one.mean - width for one, width in zip(estimates, error, strict=True)]
    top, bottom = highest, min([0.0, *filter(math.isfinite, low)])
    for number, line in enumerate(lines):
        y = [line.value(one) for one in points]
        inside = line.scale(y, highest)
        top, bottom = max([top, *inside]), min([bottom, *inside])
        title = f"{line.title} (above)" if line.is_bound and not inside else line.title
        style = ("--" if line.doubted else "-") if numeric else "none"
        axes.plot(x, y, linestyle=style, marker=_MARKS[number % len(_MARKS)], linewidth=1.2,
                  markersize=4, color=PARTS[number % len(PARTS)], markerfacecolor="none",
                  label=title)  # fmt: skip
    axes.errorbar(x, [one.mean for one in estimates], yerr=error, fmt="o", color=INK, capsize=4,
                  linewidth=1.6, label="runs", zorder=5)  # fmt: skip
    for position, one in zip(x, points, strict=True):
        values = list(one.values.get(quantity, {}).values())
        axes.scatter([position] * len(values), values, s=9, color=SOFT, alpha=0.6, linewidths=0)
    if not numeric:
        axes.set_xticks(x, [one.point.levels[place].label for one in points])
        axes.margins(x=0.3)
    axes.set_xlabel(factor.title)
    axes.set_ylim(bottom=1.1 * bottom, top=1.1 * top if top > 0 else None)


def _value(formula: Formula, one: PointResult) -> float:
    """The formula's value, NaN where it has none or is outside of its range."""
    try:
        return math.nan if formula.outside(one.inputs) else formula.value(one.inputs)
    except FormulaError:
        return math.nan
