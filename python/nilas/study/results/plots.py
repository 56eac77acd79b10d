"""Plots of a response over the factors."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nilas.study.describe.factor import Factor
from nilas.study.results.drawing import (
    ACCENT,
    HEAT,
    INK,
    SOFT,
    add_runs,
    figure,
    grid_of_axes,
    series_colours,
    svg_of,
)
from nilas.study.results.response_data import ResponseData
from nilas.study.results.scatter import scatter_of

_MOST_LINES = 8
_MOST_CELLS = 12


def plot_levels(data: ResponseData, order: Sequence[int]) -> str:
    """Means over the first factor of ``order``, a line for each level of the second.

    Bands are intervals of 95 % of the mean over the runs at that place. Further factors are
    averaged over.
    """
    first = data.factors[order[0]]
    second = data.factors[order[1]] if len(order) > 1 else None
    labels = [level.label for level in second.levels][:_MOST_LINES] if second else [""]
    fig, (axes,) = figure(5.6, 4.0)
    positions = _positions(first)
    for colour, label in zip(series_colours(len(labels)), labels, strict=True):
        chosen = [
            number
            for number, row in enumerate(data.rows)
            if second is None or row.run.point.levels[order[1]].label == label
        ]
        where = [positions[data.rows[number].run.point.levels[order[0]].label] for number in chosen]
        values = [float(data.values[number]) for number in chosen]
        add_runs(axes, where, values, chosen, colour)
        _line(axes, where, values, colour, label, first)
    if second:
        axes.legend(title=second.title, title_fontsize=9, loc="best")
    _name_axes(axes, first, data.response.title)
    return svg_of(fig, data.rows, f"{data.response.name} over {first.name}")


def plot_map(data: ResponseData, order: Sequence[int]) -> str | None:
    """The mean at each pair of levels of two factors, as colours and numbers."""
    across, up = data.factors[order[0]], data.factors[order[1]]
    if max(len(across.levels), len(up.levels)) > _MOST_CELLS:
        return None
    cells = np.full((len(up.levels), len(across.levels)), np.nan)
    for i, level_up in enumerate(up.levels):
        for k, level_across in enumerate(across.levels):
            values = [
                float(value)
                for row, value in zip(data.rows, data.values, strict=True)
                if row.run.point.levels[order[0]].label == level_across.label
                and row.run.point.levels[order[1]].label == level_up.label
            ]
            cells[i, k] = scatter_of(values).mean
    if not np.isfinite(cells).any():
        return None
    fig, (axes,) = figure(
        min(2.0 + 0.95 * len(across.levels), 5.6), min(1.2 + 0.7 * len(up.levels), 4.0)
    )
    picture = axes.pcolormesh(cells, cmap=HEAT, edgecolors="white", linewidth=2)
    low, high = np.nanmin(cells), np.nanmax(cells)
    for (i, k), value in np.ndenumerate(cells):
        dark = high > low and np.isfinite(value) and (value - low) / (high - low) > 0.5
        text = f"{value:.3g}" if np.isfinite(value) else "no run"
        axes.text(
            k + 0.5,
            i + 0.5,
            text,
            ha="center",
            va="center",
            color="white" if dark else INK,
            fontsize=9,
        )
    axes.set_xticks(np.arange(len(across.levels)) + 0.5, [level.label for level in across.levels])
    axes.set_yticks(np.arange(len(up.levels)) + 0.5, [level.label for level in up.levels])
    axes.grid(False)
    axes.tick_params(length=0)
    for side in ("left", "bottom"):
        axes.spines[side].set_visible(False)
    axes.set_xlabel(across.title)
    axes.set_ylabel(up.title)
    fig.colorbar(picture, ax=axes, label=data.response.title).outline.set_visible(False)
    return svg_of(fig, title=f"{data.response.name} over {across.name} and {up.name}")


def plot_curves(data: ResponseData) -> str:
    """Every run over each factor, with the fitted curve and its band where numbers allow it."""
    fig, axes = grid_of_axes(len(data.factors))
    surface = data.surface()
    names = [factor.name for factor in data.numeric]
    everything = range(len(data.rows))
    for number, (factor, one) in enumerate(zip(data.factors, axes, strict=True)):
        positions = _positions(factor) if not factor.is_numeric else None
        x = [
            float(level.number or 0.0) if positions is None else positions[level.label]
            for level in (row.run.point.levels[number] for row in data.rows)
        ]
        if surface and factor.name in names:
            curve = surface.curve(names.index(factor.name))
            own = np.exp(curve.x) if factor.logarithmic else curve.x
            one.fill_between(
                own,
                curve.y - curve.band,
                curve.y + curve.band,
                color=ACCENT,
                alpha=0.18,
                linewidth=0,
            )
            one.plot(own, curve.y, color=ACCENT, linewidth=2.2, zorder=4)
        add_runs(one, x, [float(value) for value in data.values], list(everything), SOFT)
        _name_axes(one, factor, data.response.title if number % 3 == 0 else "")
    return svg_of(fig, data.rows, f"{data.response.name} over each factor")


def _line(
    axes, where: list[float], values: list[float], colour, label: str, factor: Factor
) -> None:
    """Means with their band. Categories get bars in place of a line that would join them."""
    places = sorted(set(where))
    scatters = [
        scatter_of([v for w, v in zip(where, values, strict=True) if w == place])
        for place in places
    ]
    means = np.array([scatter.mean for scatter in scatters])
    bands = np.array([scatter.interval for scatter in scatters])
    if factor.is_numeric:
        if np.isfinite(bands).any():
            axes.fill_between(
                places, means - bands, means + bands, color=colour, alpha=0.16, linewidth=0
            )
        axes.plot(
            places,
            means,
            color=colour,
            linewidth=2.2,
            marker="o",
            markersize=5.5,
            label=label,
            zorder=4,
        )
    else:
        error = np.where(np.isfinite(bands), bands, 0.0)
        axes.errorbar(
            places, means, yerr=error, color=colour, fmt="o", capsize=5, label=label, zorder=4
        )


def _positions(factor: Factor) -> dict[str, float]:
    """Where each level stands on the axis: its number, or its place in the list."""
    if factor.is_numeric:
        return {level.label: float(level.number or 0.0) for level in factor.levels}
    return {level.label: float(place) for place, level in enumerate(factor.levels)}


def _name_axes(axes, factor: Factor, title: str) -> None:
    axes.set_xlabel(factor.title)
    axes.set_ylabel(title)
    if factor.logarithmic:
        axes.set_xscale("log")
    if not factor.is_numeric:
        axes.set_xticks(range(len(factor.levels)), [level.label for level in factor.levels])
        axes.set_xlim(-0.5, len(factor.levels) - 0.5)
    elif factor.levels and len(factor.levels) <= 8 and not factor.logarithmic:
        axes.set_xticks(
            [level.number for level in factor.levels], [level.label for level in factor.levels]
        )
