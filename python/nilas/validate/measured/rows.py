"""Measured loads as a table: conditions, load, how well it is known, and source."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from nilas.study.describe.faults import listed
from nilas.validate.measured.record import RecordError, towing_record

# Columns that are neither a condition nor a quantity.
_WORDS = ("test", "source", "remark", "record", "from_s", "to_s")
_INTERVAL = "_interval_95"


class MeasuredError(ValueError):
    """A measured table that cannot be used as it is."""


@dataclass(frozen=True)
class Measured:
    """A measured mean and the half width of its interval of 95 %, NaN where nobody states it."""

    value: float
    interval: float = math.nan


@dataclass(frozen=True)
class MeasuredRow:
    """One measured run. ``conditions``: values of the factors, as they are written."""

    test: str
    conditions: Mapping[str, str]
    quantities: Mapping[str, Measured]
    source: str
    remark: str = ""
    line: int = field(default=0, compare=False)


def read_measured(
    file: Path, factors: Iterable[str], quantities: Iterable[str]
) -> tuple[MeasuredRow, ...]:
    """The rows of a measured table in CSV. Lines that begin with # are comments.

    ``factors``: the columns of conditions, all of which are needed. ``quantities``: the columns of
    measured numbers, of which a row has those that it knows. The interval of a quantity stands in
    the column ``NAME_interval_95``. In place of the column ``load`` a row may name a towing
    record, from which it is taken. Raises ``MeasuredError`` with line and column.
    """
    factors, quantities = list(factors), list(quantities)
    try:
        text = file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise MeasuredError(f"{file} cannot be read: {error}.") from error
    numbered = [
        (number, line)
        for number, line in enumerate(text.splitlines(), 1)
        if line.strip() and not line.lstrip().startswith("#")
    ]
    if not numbered:
        raise MeasuredError(f"{file} has no rows.")
    reader = csv.DictReader([line for _, line in numbered], restkey="")
    _check_columns(file, numbered[0][0], reader.fieldnames or [], factors, quantities)
    rows = [
        _row(file, line, cells, factors, quantities)
        for (line, _), cells in zip(numbered[1:], reader, strict=True)
    ]
    if not rows:
        raise MeasuredError(f"{file} has a heading and no rows.")
    return tuple(rows)


def _check_columns(
    file: Path, line: int, columns: Iterable[str], factors: list[str], quantities: list[str]
) -> None:
    known = {*_WORDS, *factors, *quantities, *(name + _INTERVAL for name in quantities)}
    columns = list(columns)
    for name in columns:
        if name not in known:
            raise MeasuredError(
                f"{file}:{line}: there is no factor and no response '{name}' in the case. "
                f"Columns may be {listed(sorted(known))}."
            )
    missing = [name for name in (*factors, "source") if name not in columns]
    if missing:
        raise MeasuredError(f"{file}:{line}: the columns {listed(missing)} are missing.")


def _row(
    file: Path, line: int, cells: Mapping[str, str], factors: list[str], quantities: list[str]
) -> MeasuredRow:
    place = f"{file}:{line}"
    if "" in cells or None in cells.values():
        raise MeasuredError(f"{place}: the row has not as many cells as the heading.")
    cells = {name: text.strip() for name, text in cells.items()}
    for name in (*factors, "source"):
        if not cells[name]:
            raise MeasuredError(f"{place}: {name} is empty.")
    found = {}
    for name in quantities:
        if cells.get(name):
            interval = cells.get(name + _INTERVAL, "")
            found[name] = Measured(
                _number(place, name, cells[name]),
                _number(place, name + _INTERVAL, interval) if interval else math.nan,
            )
    if cells.get("record"):
        found |= _from_record(file, place, cells)
    if not found:
        raise MeasuredError(f"{place}: the row has no measured number.")
    conditions = {name: cells[name] for name in factors}
    test = cells.get("test") or f"row {line}"
    return MeasuredRow(test, conditions, found, cells["source"], cells.get("remark", ""), line)


def _from_record(file: Path, place: str, cells: Mapping[str, str]) -> dict[str, Measured]:
    start, end = (
        _number(place, name, cells[name]) if cells.get(name) else None
        for name in ("from_s", "to_s")
    )
    try:
        record = towing_record(file.parent / cells["record"], start, end)
    except RecordError as error:
        raise MeasuredError(f"{place}: {error}") from error
    return {"load": Measured(record.mean_N, record.interval_N)}


def _number(place: str, name: str, text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise MeasuredError(f"{place}: {name} is '{text}', and a number should stand there.")
    return value
