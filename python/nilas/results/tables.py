"""The CSV tables of a run folder as pandas DataFrames and xarray Datasets.

A table of a run that goes on may end within a row. Only whole rows are read.
"""

from __future__ import annotations

import io
import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import pandas as pd

from nilas.arguments import several
from nilas.names import unknown
from nilas.results.folder import NoRun
from nilas.results.units import units_of

if TYPE_CHECKING:
    import xarray as xr

TIME = "time_s"


def _version(text: str) -> tuple[int, ...]:
    """The first two numbers of a version."""
    return tuple(int(number) for number in re.findall(r"\d+", text)[:2])



class _Kind(NamedTuple):
    file: str
    per_step: bool  # one row per step, so that time names a row
    when: str  # in which runs the file exists


TABLES = {
    "vessel": _Kind("vessel.csv", True, "runs with a vessel have it"),
    "steps": _Kind("steps.csv", True, "every run has it"),
    "structures": _Kind("structures.csv", True, "runs with fixed bodies have it"),
    "parts": _Kind("parts.csv", True, "runs with <part> or <rod> have it"),
    "bodies": _Kind("bodies.csv", False, "runs of up to 200 bodies have it, or <output bodies>"),
    "events": _Kind("events.csv", False, "runs where floes can break have it"),
}
# Texts that could be taken for numbers: hashes, lists of ids, names such as "12".
_TEXTS = ("status", "state_hash", "kind", "pieces", "name")
# What makes pandas read numbers to the last bit; from 3.1 on it does so by itself.
_EXACT: dict[str, Any] = (
    {} if _version(pd.__version__) >= (3, 1) else {"float_precision": "round_trip"}
)
_BLOCK = 1 << 16  # bytes that are searched at a time for the end of the last row


def read_table(
    folder: Path,
    name: str,
    *,
    columns: Sequence[str] | None = None,
    between: tuple[float, float] | None = None,
) -> pd.DataFrame:
    """One table. Its index is ``time_s`` where the table has one row per step.

    ``columns``: those to read, all if None; others cost no memory. ``between``: only rows from
    the first to the second time [s], both included. ``attrs["units"]`` has the unit of each
    column.

    >>> read_table(example_folder, "vessel", columns=["x_m"], between=(0.2, 0.3)).attrs["units"]
    {'time_s': 's', 'x_m': 'm'}
    """
    file = table_file(folder, name)
    header = column_names(file)
    wanted = _with_time(columns, header, file)
    frame = pd.read_csv(
        _whole_rows(file),
        usecols=wanted,
        dtype={text: str for text in _TEXTS if text in header},
        **_EXACT,
        keep_default_na=False,
        na_values={column: ["nan", "-nan"] for column in header if column not in _TEXTS},
    )
    if between is not None:
        frame = frame[frame[TIME].between(*between)].reset_index(drop=True)
    per_step = TABLES[name].per_step
    if per_step:
        frame = frame.set_index(TIME)
    if columns is not None:
        frame = frame[[column for column in columns if column in frame.columns]]
    names = [TIME, *frame.columns] if per_step else list(frame.columns)
    frame.attrs["units"] = units_of(names)
    return frame


def table_file(folder: Path, name: str) -> Path:
    """The file of a table. Raises ``NoRun`` where the run does not have it.

    >>> table_file(example_folder, "vessel").name
    'vessel.csv'
    """
    if name not in TABLES:
        raise unknown(f"There is no table '{name}'", name, TABLES)
    kind = TABLES[name]
    if not (folder / kind.file).is_file():
        raise NoRun(f"{folder}: this run has no {kind.file}; {kind.when}.")
    return folder / kind.file


def column_names(file: Path) -> list[str]:
    """The names in the first row of a CSV file.

    >>> column_names(example_folder / "steps.csv")[0]
    'time_s'
    """
    with file.open("rb") as stream:
        head = stream.readline()
    if not head.endswith(b"\n"):
        raise NoRun(f"{file}: this has no whole row yet.")
    return list(pd.read_csv(io.BytesIO(head), nrows=0).columns)


def to_dataset(frame: pd.DataFrame) -> xr.Dataset:
    """A table as an xarray Dataset. Each variable has its unit as the attribute ``units``.

    >>> frame = pd.DataFrame({"x_m": [1.0, 2.0]}, index=pd.Index([0.1, 0.2], name="time_s"))
    >>> frame.attrs["units"] = {"time_s": "s", "x_m": "m"}
    >>> to_dataset(frame).x_m.attrs["units"]
    'm'
    """
    try:
        import xarray
    except ModuleNotFoundError:
        raise ModuleNotFoundError(
            "Datasets need the package xarray, python3-xarray of Debian. DataFrames do not."
        ) from None
    units = frame.attrs.get("units", {})
    data = xarray.Dataset.from_dataframe(frame)
    for variable in data.variables:
        if unit := units.get(str(variable)):
            data[variable].attrs["units"] = unit
    return data


def _with_time(columns: Sequence[str] | None, header: list[str], file: Path) -> list[str] | None:
    """The columns to read, with the time; None for all."""
    if columns is None:
        return None
    for column in several("columns", columns):
        if column not in header:
            raise unknown(f"{file}: there is no column '{column}'", column, header, what="columns")
    return [TIME, *(column for column in columns if column != TIME)]


def _whole_rows(file: Path) -> io.BytesIO | Path:
    """The file, or its whole rows where it ends within one."""
    size = file.stat().st_size
    with file.open("rb") as stream:
        stream.seek(max(0, size - 1))
        if stream.read(1) == b"\n":
            return _first_bytes(file, size)
        end = size
        while end > 0:
            begin = max(0, end - _BLOCK)
            stream.seek(begin)
            last = stream.read(end - begin).rfind(b"\n")
            if last >= 0:
                return _first_bytes(file, begin + last + 1)
            end = begin
    raise NoRun(f"{file}: this has no whole row yet.")


def _first_bytes(file: Path, size: int) -> io.BytesIO:
    """The first bytes of a file: rows that a run adds meanwhile are left out."""
    with file.open("rb") as stream:
        return io.BytesIO(stream.read(size))
