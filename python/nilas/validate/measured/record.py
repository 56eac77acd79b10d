"""Towing records: force over time, its mean, and how well the record knows it."""

from __future__ import annotations

import csv
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from nilas.study.results.scatter import t_quantile

# As many batches as the program takes where ice remembers long (docs/theory/load-error.md).
_BATCHES = 8


class RecordError(ValueError):
    """A towing record that cannot be used as it is."""


@dataclass(frozen=True)
class TowingRecord:
    """Statistics of a towing record [N] over ``from_s`` to ``to_s``.

    ``interval_N``: half width of the interval of 95 % of the mean, from batch means.
    ``speed_m_s``: mean speed, NaN where the record has none.
    """

    from_s: float
    to_s: float
    mean_N: float
    interval_N: float
    std_N: float
    max_N: float
    speed_m_s: float


def towing_record(
    file: str | Path, from_s: float | None = None, to_s: float | None = None
) -> TowingRecord:
    """Reads a record with the columns ``time_s``, ``force_N`` and perhaps ``speed_m_s``.

    The force is what the carriage pulls with, less that in open water. Without a window the whole
    record counts. Raises ``RecordError`` with the line of what is wrong.
    """
    path = Path(file)
    times, forces, speeds = _columns(path)
    if (np.diff(times) <= 0).any():
        line = int(np.argmax(np.diff(times) <= 0)) + 3
        raise RecordError(f"{path}:{line}: time does not rise.")
    inside = np.ones(len(times), dtype=bool)
    if from_s is not None:
        inside &= times >= from_s
    if to_s is not None:
        inside &= times <= to_s
    count = int(inside.sum())
    if count < 2 * _BATCHES:
        raise RecordError(f"{path} has {count} rows in the window, and needs {2 * _BATCHES}.")
    chosen = forces[inside]
    means = np.array([batch.mean() for batch in np.array_split(chosen, _BATCHES)])
    error = float(means.std(ddof=1)) / math.sqrt(_BATCHES)
    return TowingRecord(
        float(times[inside][0]),
        float(times[inside][-1]),
        float(chosen.mean()),
        t_quantile(_BATCHES - 1) * error,
        float(chosen.std(ddof=1)),
        float(chosen.max()),
        float(speeds[inside].mean()) if speeds is not None else math.nan,
    )


def _columns(path: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray | None]:
    try:
        with open(path, newline="", encoding="utf-8") as stream:
            reader = csv.DictReader(stream)
            names = reader.fieldnames or []
            for needed in ("time_s", "force_N"):
                if needed not in names:
                    raise RecordError(f"{path}:1: there is no column {needed}.")
            wanted = [name for name in ("time_s", "force_N", "speed_m_s") if name in names]
            rows = [_numbers(path, line, row, wanted) for line, row in enumerate(reader, 2)]
    except OSError as error:
        raise RecordError(f"{path} cannot be read: {error.strerror}.") from error
    if not rows:
        raise RecordError(f"{path} has no rows.")
    table = np.array(rows)
    return table[:, 0], table[:, 1], table[:, 2] if len(wanted) == 3 else None


def _numbers(path: Path, line: int, row: dict[str, str], wanted: list[str]) -> list[float]:
    values = []
    for name in wanted:
        try:
            values.append(float(row[name]))
        except (TypeError, ValueError):
            raise RecordError(f"{path}:{line}: {name} is '{row[name]}', no number.") from None
    return values
