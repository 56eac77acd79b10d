"""Independent peaks of a correlated series: clusters of exceedances, by Ferro and Segers (2003)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Events(NamedTuple):
    """The largest value of each cluster above a threshold, and its time [s]."""

    time: NDArray[np.float64]
    peak: NDArray[np.float64]
    extremal_index: float


def extremal_index(gaps: NDArray[np.int_]) -> float:
    """The share of exceedances that begin a cluster, from the gaps between exceedances in samples.

    It is the intervals estimator of Ferro and Segers (2003); 1 for exceedances that do not
    depend on each other.

    >>> round(extremal_index(np.array([1, 1, 1, 97, 1, 1, 1, 97])), 2)
    0.51
    """
    if len(gaps) == 0:
        return 1.0
    wide = gaps.astype(float)
    if wide.max() <= 2:
        top, below = 2 * wide.sum() ** 2, len(wide) * (wide**2).sum()
    else:
        top = 2 * (wide - 1).sum() ** 2
        below = len(wide) * ((wide - 1) * (wide - 2)).sum()
    return float(min(1.0, top / below))


def clusters(
    values: NDArray[np.float64], threshold: float, least_gap: int
) -> list[NDArray[np.int_]]:
    """Places of the values above a threshold, in clusters.

    The number of clusters is the extremal index times the number of exceedances, and the widest
    gaps part them. Gaps of fewer samples than ``least_gap`` part nothing.

    >>> series = np.zeros(100)
    >>> series[[10, 11, 12, 50, 51, 90]] = 1.0
    >>> [found.tolist() for found in clusters(series, 0.5, 2)]
    [[10, 11, 12], [50, 51], [90]]
    """
    above = np.flatnonzero(values > threshold)
    if len(above) == 0:
        return []
    gaps = np.diff(above)
    wanted = int(np.floor(extremal_index(gaps) * len(above)))
    widest = np.sort(gaps)[::-1]
    parting = max(least_gap, int(widest[wanted - 1]) if 0 < wanted <= len(widest) else 1, 2)
    return np.split(above, np.flatnonzero(gaps >= parting) + 1)


def events_above(
    times: NDArray[np.float64], values: NDArray[np.float64], threshold: float, apart: float
) -> Events:
    """The independent peaks of a series above a threshold.

    ``times`` [s] rise. Peaks are at least ``apart`` [s] from the next cluster: within a filter
    time two means share some of the same load.

    >>> found = events_above(np.arange(6.0), np.array([0.0, 5, 7, 0, 0, 6]), 1.0, 2.0)
    >>> found.time.tolist(), found.peak.tolist()
    ([2.0, 5.0], [7.0, 6.0])
    """
    sample = (times[-1] - times[0]) / max(len(times) - 1, 1)
    least_gap = int(np.ceil(apart / sample)) if sample > 0 else 1
    found = clusters(values, threshold, least_gap)
    tops = np.array([group[np.argmax(values[group])] for group in found], dtype=int)
    count = int((values > threshold).sum())
    return Events(times[tops], values[tops], len(tops) / count if count else 1.0)
