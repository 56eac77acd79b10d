"""Statistics of a column of a table that a run wrote."""

from __future__ import annotations

import csv
import math
from pathlib import Path

from nilas.study.describe.faults import nearest
from nilas.study.describe.study import Response


class ColumnMissing(ValueError):
    """A table or a column that the run did not write."""


def column_value(folder: Path, response: Response) -> float:
    """The statistic of a response over its time, from the run in ``folder``.

    Sums are exact (``math.fsum``), so that every machine finds the same bits.
    """
    times, values = _read(folder / response.table, response.column)
    start = -math.inf if response.from_s is None else response.from_s
    end = math.inf if response.to_s is None else response.to_s
    window = [value for time, value in zip(times, values, strict=True) if start <= time <= end]
    if not window:
        raise ColumnMissing(f"{response.table} has no row from {start:g} to {end:g} s.")
    return statistic(response.statistic, window)


def statistic(name: str, values: list[float]) -> float:
    """A statistic by its name; ``largest`` is that of the absolute values, and so is ``p99``.

    >>> statistic("mean", [1.0, 2.0, 6.0]), statistic("largest", [1.0, -4.0])
    (3.0, 4.0)
    """
    if name == "mean":
        return math.fsum(values) / len(values)
    if name == "std":
        mean = math.fsum(values) / len(values)
        return math.sqrt(math.fsum((value - mean) ** 2 for value in values) / len(values))
    if name == "last":
        return values[-1]
    if name == "p99":
        return _quantile(sorted(abs(value) for value in values), 0.99)
    if name == "largest":
        return max(abs(value) for value in values)
    return min(values) if name == "min" else max(values)


def _quantile(ordered: list[float], share: float) -> float:
    place = share * (len(ordered) - 1)
    low = int(place)
    high = min(low + 1, len(ordered) - 1)
    return ordered[low] + (place - low) * (ordered[high] - ordered[low])


def _read(path: Path, column: str) -> tuple[list[float], list[float]]:
    try:
        with open(path, newline="", encoding="utf-8") as stream:
            rows = csv.reader(stream)
            names = next(rows, [])
            if column not in names or "time_s" not in names:
                hint = nearest(column, names)
                raise ColumnMissing(f"{path.name} has no column {column}.{hint}")
            time, place = names.index("time_s"), names.index(column)
            pairs = [
                (float(row[time]), float(row[place])) for row in rows if len(row) == len(names)
            ]
    except OSError as error:
        raise ColumnMissing(f"{path.name} cannot be read: {error.strerror}.") from error
    return [pair[0] for pair in pairs], [pair[1] for pair in pairs]
