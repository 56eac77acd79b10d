"""Bars of sensitivities, and the scatter between seeds."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.figure import Figure

from nilas.study.results.anova import Anova
from nilas.study.results.drawing import ACCENT, CHANCE, INK, PARTS, SOFT, WARM, figure, svg_of
from nilas.study.results.regression import Slopes
from nilas.study.results.response_data import ResponseData
from nilas.study.results.sobol import SobolIndices

_MOST_POINTS = 16


def plot_shares(data: ResponseData, anova: Anova) -> str:
    """One bar of 100 %: what each factor, each pair, and chance make of the scatter."""
    names = [" x ".join(data.factors[k].name for k in effect.factors) for effect in anova.effects]
    parts = [(name, effect.share) for name, effect in zip(names, anova.effects, strict=True)]
    if len(data.factors) > 2:
        parts.append(("three or more together", anova.higher))
    if anova.seeds > 1:
        parts.append(("chance between seeds", anova.chance))
    fig, (axes,) = figure(10.8, 0.8)
    start = 0.0
    for number, (name, share) in enumerate(parts):
        colour = CHANCE if name.startswith("chance") else PARTS[number % len(PARTS)]
        axes.barh(
            0,
            share,
            height=1.0,
            left=start,
            color=colour,
            edgecolor="white",
            linewidth=1.5,
            label=f"{name} {100 * share:.0f} %",
        )
        if share > 0.09:
            text = INK if colour == CHANCE else "white"
            axes.text(
                start + share / 2,
                0,
                f"{100 * share:.0f} %",
                ha="center",
                va="center",
                color=text,
                fontsize=10,
            )
        start += share
    axes.set_xlim(0, 1)
    axes.axis("off")
    shown = len(parts)
    _legend_below(fig, min(shown, 4))
    return svg_of(fig, title=f"Shares of the scatter of {data.response.name}")


def plot_slopes(data: ResponseData, slopes: Slopes) -> str:
    """Standardised slopes with intervals of 95 %, the strongest on top."""
    order = np.argsort(np.abs(slopes.slope))
    fig, (axes,) = figure(5.4, 0.95 + 0.42 * len(order))
    for place, number in enumerate(order):
        sure = abs(slopes.slope[number]) > slopes.interval[number]
        colour = (ACCENT if slopes.slope[number] > 0 else WARM) if sure else CHANCE
        axes.barh(place, slopes.slope[number], color=colour, height=0.62)
        axes.errorbar(
            slopes.slope[number],
            place,
            xerr=slopes.interval[number],
            color=INK,
            capsize=3,
            linewidth=1.1,
        )
    axes.axvline(0, color=SOFT, linewidth=0.9)
    axes.set_yticks(range(len(order)), [data.numeric[number].name for number in order])
    axes.grid(False, axis="y")
    axes.set_xlabel("standardised slope")
    return svg_of(fig, title=f"Standardised slopes of {data.response.name}")


def plot_sobol(data: ResponseData, indices: SobolIndices) -> str:
    """First and total index of each factor with intervals of 95 %, the strongest on top."""
    order = np.argsort(indices.total)
    fig, (axes,) = figure(5.4, 1.25 + 0.62 * len(order))
    for shift, colour, label, values, intervals in (
        (0.19, ACCENT, "alone (first order)", indices.first, indices.first_interval),
        (-0.19, PARTS[2], "with all others (total)", indices.total, indices.total_interval),
    ):
        places = np.arange(len(order)) + shift
        axes.barh(places, values[order], height=0.34, color=colour, label=label)
        axes.errorbar(
            values[order],
            places,
            xerr=intervals[order],
            fmt="none",
            ecolor=INK,
            capsize=3,
            elinewidth=1.1,
        )
    axes.set_yticks(range(len(order)), [data.factors[number].name for number in order])
    axes.grid(False, axis="y")
    axes.set_xlabel("share of the variance")
    _legend_below(fig, 2)
    return svg_of(fig, title=f"Sobol indices of {data.response.name}")


def plot_seeds(data: ResponseData, bound: float | None) -> str | None:
    """How well each point's mean is known: its standard error over its size."""
    known = []
    for point in data.points:
        scatter = data.scatter(point)
        if scatter.count > 1 and scatter.mean and scatter.deviation:
            label = ", ".join(level.label for level in point.levels) or "scene"
            known.append((100 * scatter.standard_error / abs(scatter.mean), scatter.count, label))
    if not known:
        return None
    known.sort()
    left_out = len(known) > _MOST_POINTS
    shown = known[-_MOST_POINTS:]
    fig, (axes,) = figure(5.4, 0.95 + 0.21 * len(shown))
    places = range(len(shown))
    errors = [error for error, _, _ in shown]
    axes.hlines(places, 0, errors, color=CHANCE, linewidth=2)
    fine = [bound is None or error <= 100 * bound for error in errors]
    axes.scatter(errors, places, color=[ACCENT if one else WARM for one in fine], s=26, zorder=3)
    for place, (error, count, _) in zip(places, shown, strict=True):
        axes.annotate(
            f"{count}",
            (error, place),
            xytext=(6, -3),
            textcoords="offset points",
            fontsize=8,
            color=SOFT,
        )
    if bound is not None and math.isfinite(bound):
        axes.axvline(100 * bound, color=WARM, linestyle="--", linewidth=1.1)
    axes.set_yticks(places, [label for _, _, label in shown], fontsize=8)
    axes.set_xlim(left=0)
    axes.grid(False, axis="y")
    what = "worst points" if left_out else "points"
    axes.set_xlabel(f"standard error of the mean [%], {what}, number of seeds beside")
    return svg_of(fig, title=f"Standard error of {data.response.name}")


def _legend_below(fig: Figure, columns: int) -> None:
    place = (0.02, 0.0)
    fig.legend(
        loc="upper left", bbox_to_anchor=place, ncol=columns, handlelength=1.0, columnspacing=1.4
    )
