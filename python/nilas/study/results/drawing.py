"""Look of the figures, and how they become text of the page."""

from __future__ import annotations

import html
import io
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import matplotlib
import matplotlib.style
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure

from nilas.study.results.collected import Row

INK, SOFT, LINE, ACCENT, WARM = "#16242f", "#5a6b78", "#d9e1e7", "#0b63b5", "#d9730d"
# From deep water to bright ice with warm ends: steps that colour-blind people can order.
SERIES = LinearSegmentedColormap.from_list(
    "series", ["#12355b", "#0b63b5", "#16a3a3", "#7fb236", "#f0a202", "#d6452b"]
)
HEAT = LinearSegmentedColormap.from_list(
    "heat", ["#eef6fb", "#a9d3ea", "#4b9fd0", "#0b63b5", "#12355b"]
)
PARTS = ["#0b63b5", "#16a3a3", "#f0a202", "#8e5bb5", "#d6452b", "#7fb236", "#2f6f8f", "#b5651d"]
CHANCE = "#c3ccd3"
# More marks make a page slow, and nobody can tell them apart.
MOST_MARKS = 3000
_MOST_LINKS = 800

_STYLE: dict[str, Any] = {
    "font.family": "DejaVu Sans",
    "font.size": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": SOFT,
    "axes.labelcolor": INK,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": LINE,
    "grid.linewidth": 0.7,
    "xtick.color": SOFT,
    "ytick.color": SOFT,
    "text.color": INK,
    "legend.frameon": False,
    "legend.fontsize": 9,
    "svg.hashsalt": "nilas",  # the same bytes each time
    "svg.fonttype": "none",
    "figure.facecolor": "none",
    "axes.facecolor": "none",
}


@contextmanager
def own_style() -> Iterator[None]:
    """The look of the figures, while they are drawn: settings of the user are not touched."""
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.style.use(_STYLE)
        yield


def figure(width: float, height: float, columns: int = 1, **more) -> tuple[Figure, list[Axes]]:
    """A figure [inches] with axes in a row."""
    fig = Figure(figsize=(width, height), layout="constrained")
    return fig, list(fig.subplots(1, columns, squeeze=False, **more)[0])


def grid_of_axes(count: int, sharey: bool = True) -> tuple[Figure, list[Axes]]:
    """Axes side by side, at most three in a row; those that are too many are removed."""
    columns = min(count, 3)
    lines = -(-count // columns)
    width = {1: 6.4, 2: 10.8, 3: 10.8}[columns]
    size = (width, 3.2 * lines + 0.2)
    fig = Figure(figsize=size, layout="constrained")
    axes = fig.subplots(lines, columns, squeeze=False, sharey=sharey)
    flat = list(axes.flat)
    for spare in flat[count:]:
        spare.remove()
    return fig, flat[:count]


def series_colours(count: int) -> list:
    return [SERIES(0.08 + 0.84 * k / max(count - 1, 1)) for k in range(count)]


def svg_of(fig: Figure, rows: Sequence[Row] = (), title: str = "") -> str:
    """The figure as SVG for a page. Marks that link to ``run:K`` get the name of the K-th row."""
    stream = io.StringIO()
    fig.savefig(
        stream,
        format="svg",
        bbox_inches="tight",
        pad_inches=0.06,
        metadata={"Date": None, "Creator": None},
    )
    text = stream.getvalue()
    text = text[text.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    # Names of clips and markers are unique within a figure only; figures share one page.
    prefix = f"f{abs(hash_of(title + text)):x}-"
    text = re.sub(r'\b(id|xlink:href|clip-path)="(#|url\(#)?', lambda m: _named(m, prefix), text)
    label = html.escape(title, quote=True)
    text = text.replace("<svg ", f'<svg role="img" aria-label="{label}" ', 1)
    # Newer releases of Matplotlib add a target.
    return re.sub(r'<a xlink:href="run:(\d+)"[^>]*>', lambda m: _link(rows[int(m[1])]), text)


def hash_of(text: str) -> int:
    """A number that follows from a text, on every machine the same."""
    import zlib

    return zlib.crc32(text.encode())


def add_runs(
    axes: Axes, x: Sequence[float], y: Sequence[float], numbers: Sequence[int], colours
) -> None:
    """A small mark for each run, with a link to it."""
    step = max(1, -(-len(x) // MOST_MARKS))
    single = not isinstance(colours, list)
    marks = axes.scatter(
        x[::step],
        y[::step],
        s=15,
        color=colours if single else colours[::step],
        alpha=0.6,
        linewidths=0,
        zorder=3,
    )
    if len(x) <= _MOST_LINKS:
        marks.set_urls([f"run:{number}" for number in numbers])


def _named(match: re.Match, prefix: str) -> str:
    kind, start = match[1], match[2] or ""
    if kind != "id" and not start:
        return match[0]
    return f'{kind}="{start}{prefix}'


def _link(row: Row) -> str:
    values = ", ".join(level.label for level in row.run.point.levels)
    name = html.escape(f"{values}; seed {row.run.seed}", quote=True)
    return (
        f'<a class="run" href="runs/{html.escape(row.run.name, quote=True)}/"><title>{name}</title>'
    )
