"""The load of a run over its window, step by step, and its means over a filter time."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nilas.errors import InputError
from nilas.results.folder import NoRun
from nilas.results.run import Run

CHANNEL = "ice_resistance_N"


@dataclass(frozen=True)
class LoadSeries:
    """A load as means over steps of ``step`` [s], the first of which begins at ``start`` [s].

    ``filter_s``: the time over which the run takes its filtered peaks.

    >>> load = LoadSeries(np.array([1.0, 3.0]), 10.0, 0.5, 1.0)
    >>> load.duration, load.times.tolist()
    (1.0, [10.5, 11.0])
    """

    values: NDArray[np.float64]
    start: float
    step: float
    filter_s: float

    @property
    def duration(self) -> float:
        """Length of the series [s]."""
        return len(self.values) * self.step

    @property
    def times(self) -> NDArray[np.float64]:
        """Ends of the steps [s]."""
        return self.start + self.step * np.arange(1, len(self.values) + 1)


def load_series(
    run: Run, channel: str = CHANNEL, between: tuple[float, float] | None = None
) -> LoadSeries:
    """The load of a run in a column of ``vessel.csv`` or ``structures.csv``.

    ``between``: from, to [s]; the default is the window of the run's own statistics. Raises
    ``NoRun`` where the run has no such column or no steps in that time.

    >>> load = load_series(example_run)
    >>> bool(len(load.values) > 10 and load.filter_s >= load.step)
    True
    """
    table, window, filter_s = _place_of(run, channel)
    begin, end = between or window
    frame = run.table(table, columns=[channel])
    times = frame.index.to_numpy()
    if len(times) < 2:
        raise NoRun(f"{run.folder}: this run has fewer than two steps.")
    step = (times[-1] - times[0]) / (len(times) - 1)
    slack = 1e-6 * step
    inside = (times > begin + slack) & (times <= end + slack)
    values = frame[channel].to_numpy()[inside]
    if len(values) == 0:
        raise NoRun(f"{run.folder}: this run has no step between {begin:g} and {end:g} s.")
    start = float(times[inside][0] - step)
    return LoadSeries(values, start, float(step), max(filter_s, float(step)))


def _place_of(run: Run, channel: str) -> tuple[str, tuple[float, float], float]:
    """Table, window and filter time of a channel."""
    summary = run.summary
    if "vessel" in run.tables and channel in run.units("vessel"):
        peaks = (summary.get("ice_load") or {}).get("peaks") or {}
        return "vessel", run.window, float(peaks.get("filter_s", 0.0))
    for structure in summary.get("structures") or []:
        name = structure["name"]
        if channel.startswith(f"{name}_") and channel in run.units("structures"):
            window = structure["window"]
            filter_s = float(structure["peaks"]["filter_s"])
            return "structures", (float(window["from_s"]), float(window["to_s"])), filter_s
    raise NoRun(f"{run.folder}: no load of this run is named '{channel}'.")


def filtered(load: LoadSeries, width: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Means over the last ``width`` [s]: times [s] at the ends of the means, and the means.

    A load is constant within a step, so a mean is exact, and its largest value is at a time where
    it begins or ends with a step. The times are both kinds, in order.

    >>> times, means = filtered(LoadSeries(np.array([0.0, 4.0, 0.0]), 0.0, 1.0, 1.0), 2.0)
    >>> times.tolist(), means.tolist()
    ([2.0, 3.0], [2.0, 2.0])
    """
    duration = load.duration
    if not load.step * (1 - 1e-9) <= width <= duration * (1 + 1e-9):
        raise InputError(f"A filter of {width:g} s does not lie between a step and the window.")
    edges = load.step * np.arange(len(load.values) + 1)
    impulse = np.concatenate([[0.0], np.cumsum(load.values * load.step)])
    ends = np.unique(np.round(np.concatenate([edges, edges + width]) / load.step, 9)) * load.step
    ends = ends[(ends >= width * (1 - 1e-9)) & (ends <= duration * (1 + 1e-9))]
    means = (np.interp(ends, edges, impulse) - np.interp(ends - width, edges, impulse)) / width
    return load.start + ends, means


def same_filter(loads: Iterable[LoadSeries], width: float | None) -> float:
    """The filter time that is asked for, else the one that all series share [s].

    >>> same_filter([LoadSeries(np.zeros(3), 0.0, 0.1, 0.2)], None)
    0.2
    """
    if width is not None:
        return width
    widths = {round(load.filter_s, 9) for load in loads}
    if len(widths) > 1:
        raise InputError("The runs have different filter times, so name one: filter_s.")
    return widths.pop()
