"""Independent peaks of a load over one run or several, and the load that returns in a given time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy import stats

from nilas.errors import InputError
from nilas.loads.events import events_above
from nilas.loads.series import CHANNEL, LoadSeries, filtered, load_series, same_filter
from nilas.loads.tail import LEAST_FOR_SHAPE, ReturnLevel, Tail, fit_tail
from nilas.results.run import Run

# The threshold is the highest of these shares of the filtered load that leaves enough events.
_SHARES = (0.95, 0.9, 0.85, 0.8)
_SIGNIFICANT = 0.01
_EVENTS_TO_COMPARE = 5


@dataclass(frozen=True)
class LoadPeaks:
    """Independent peaks of the filtered load above a threshold, over all runs together.

    ``events``: a row per peak with ``run`` (number from 0), ``time_s`` and ``peak`` [N], positive
    towards ``side``, the sign of the mean load. ``exposure_s``: time over all runs [s].
    ``remarks``: sentences on what makes the levels doubtful.

    >>> peaks = peaks_of_series([example_load], 0.1)
    >>> peaks.exposure_s, bool(len(peaks.events) >= 30)
    (2000.0, True)
    >>> level = peaks.return_level(4000.0)
    >>> level.low < level.level < level.high
    True
    """

    events: pd.DataFrame
    threshold: float
    share: float
    filter_s: float
    side: int
    exposure_s: float
    tail: Tail
    remarks: tuple[str, ...]

    def return_level(self, period_s: float) -> ReturnLevel:
        """The load that is exceeded once in this time on average, with its interval of 95 % [N]."""
        return self.tail.return_level(period_s)


def load_peaks(
    runs: Run | Sequence[Run],
    channel: str = CHANNEL,
    *,
    filter_s: float | None = None,
    threshold: float | None = None,
    between: tuple[float, float] | None = None,
) -> LoadPeaks:
    """Independent peaks of the load of a run, or of several with other ice of the same kind.

    ``filter_s``: averaging time of the load [s], as of the runs' filtered peaks if None.
    ``threshold``: that of the peaks [N]; if None the highest of four shares of the load is taken
    that leaves 30 events. ``between``: from, to [s], the runs' own windows if None.

    >>> peaks = load_peaks(example_run)
    >>> peaks.return_level(10.0).reason
    'There are too few events: 2 peaks above the threshold, and 10 are the least. Run longer, or more seeds.'
    """
    members = [runs] if isinstance(runs, Run) else list(runs)
    return peaks_of_series(
        [load_series(run, channel, between) for run in members], filter_s, threshold
    )


def peaks_of_series(
    loads: Sequence[LoadSeries], filter_s: float | None = None, threshold: float | None = None
) -> LoadPeaks:
    """The same from series of a load.

    >>> peaks_of_series([example_load], 0.1, threshold=5.0).threshold
    5.0
    """
    if not loads:
        raise InputError("There is no load whose peaks could be found.")
    width = same_filter(loads, filter_s)
    mean = sum(float(one.values.sum()) * one.step for one in loads)
    side = -1 if mean < 0 else 1
    means = [filtered(one, width) for one in loads]
    means = [(times, side * values) for times, values in means]
    exposure = sum(one.duration for one in loads)
    together = np.concatenate([values for _, values in means])
    share = math.nan
    if threshold is None:
        for share in _SHARES:
            threshold = float(np.quantile(together, share))
            events = _events(means, threshold, width)
            if len(events) >= LEAST_FOR_SHAPE:
                break
    else:
        events = _events(means, threshold, width)
    durations = [one.duration for one in loads]
    dispersion, remarks = _between_runs(events, durations)
    tail = fit_tail(events["peak"].to_numpy() - threshold, exposure, threshold, dispersion)
    return LoadPeaks(events, threshold, share, width, side, exposure, tail, tuple(remarks))


def _events(
    means: Sequence[tuple[NDArray[np.float64], NDArray[np.float64]]], threshold: float, width: float
) -> pd.DataFrame:
    parts = []
    for number, (times, values) in enumerate(means):
        found = events_above(times, values, threshold, width)
        parts.append(pd.DataFrame({"run": number, "time_s": found.time, "peak": found.peak}))
    return pd.concat(parts, ignore_index=True)


def _between_runs(events: pd.DataFrame, durations: Sequence[float]) -> tuple[float, list[str]]:
    """By how much counts scatter between runs beyond chance, and sentences on what differs."""
    runs = len(durations)
    if events.empty:
        return 1.0, []
    if runs < 2:
        return 1.0, ["All peaks are of one run, so the interval does not hold for other ice."]
    counts = np.bincount(events["run"], minlength=runs)
    expected = len(events) * np.array(durations) / sum(durations)
    chi = float(((counts - expected) ** 2 / expected).sum())
    remarks = []
    if stats.chi2.sf(chi, runs - 1) < _SIGNIFICANT:
        remarks.append("The runs differ in how often peaks come; the interval is widened for it.")
    groups = [part["peak"].to_numpy() for _, part in events.groupby("run")]
    groups = [group for group in groups if len(group) >= _EVENTS_TO_COMPARE]
    differ = len(groups) > 1 and np.ptp(np.concatenate(groups)) > 0
    if differ and stats.kruskal(*groups).pvalue < _SIGNIFICANT:
        remarks.append(
            "The runs differ in how large their peaks are, so the interval is too narrow."
        )
    return max(1.0, chi / (runs - 1)), remarks
