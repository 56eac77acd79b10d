"""Contacts of a run from contacts.h5, without reading the whole file."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from nilas.arguments import several
from nilas.names import unknown
from nilas.results.folder import NoRun

if TYPE_CHECKING:
    import h5py

_GROUP, _STEPS, _TIME = "contacts", "steps", "time_s"
STATUS = ("open", "stick", "slip", "crush")


class Contacts:
    """Contacts of a run: a row per contact and step, as ``docs/reference/outputs.md`` says.

    The file is opened for each answer only, so a run may go on writing it.

    >>> contacts = example_run.contacts
    >>> contacts.units["fx_N"]
    'N'
    >>> step = contacts.step(contacts.steps)
    >>> bool((step.step == contacts.steps).all())
    True
    """

    def __init__(self, file: Path) -> None:
        if not file.is_file():
            raise NoRun(
                f"{file}: this run stored no contacts. <output contacts> in the scene asks for"
                " them; the integrator reference has none."
            )
        self.file = file

    @property
    def steps(self) -> int:
        """Number of steps that the file holds whole.

        >>> example_run.contacts.steps
        50
        """
        with self._open() as file:
            return len(_complete(file))

    @property
    def rows(self) -> int:
        """Number of contacts of all steps.

        >>> example_run.contacts.rows == len(example_run.contacts.all(columns=["fx_N"]))
        True
        """
        with self._open() as file:
            bounds = _complete(file)
            return int(bounds[-1, 1]) if len(bounds) else 0

    @property
    def columns(self) -> list[str]:
        """Names of the columns, in the order of the reference.

        >>> example_run.contacts.columns[:4]
        ['time_s', 'step', 'body', 'other']
        """
        with self._open() as file:
            return _names(file)

    @property
    def units(self) -> dict[str, str]:
        """Unit of each column.

        >>> example_run.contacts.units["impulse_x_Ns"]
        'N s'
        """
        return self._attributes("unit")

    @property
    def meanings(self) -> dict[str, str]:
        """What each column means, in words.

        >>> "normal" in example_run.contacts.meanings["nx"]
        True
        """
        return self._attributes("meaning")

    def step(self, number: int, columns: Sequence[str] | None = None) -> pd.DataFrame:
        """Contacts of one step; steps count from 1.

        >>> list(example_run.contacts.step(1, columns=["body", "fx_N"]).columns)
        ['body', 'fx_N']
        """
        with self._open() as file:
            bounds = _complete(file)
            if not 1 <= number <= len(bounds):
                raise IndexError(f"{self.file}: there is no step {number}, but 1 to {len(bounds)}.")
            first, last = bounds[number - 1]
            return self._read(file, int(first), int(last), columns)

    def between(
        self, start: float, end: float, columns: Sequence[str] | None = None
    ) -> pd.DataFrame:
        """Contacts of all steps that end from ``start`` to ``end`` [s], both included.

        >>> some = example_run.contacts.between(0.2, 0.3)
        >>> bool(some.time_s.between(0.2, 0.3).all())
        True
        """
        with self._open() as file:
            bounds = _complete(file)
            rows = int(bounds[-1, 1]) if len(bounds) else 0
            times = file[_GROUP][_TIME]
            first = _first_row(times, rows, start, or_equal=True)
            last = _first_row(times, rows, end, or_equal=False)
            return self._read(file, first, last, columns)

    def all(self, columns: Sequence[str] | None = None) -> pd.DataFrame:
        """Contacts of the whole run. Name the columns of a long run, to save memory.

        >>> len(example_run.contacts.all(columns=["fx_N"])) == example_run.contacts.rows
        True
        """
        with self._open() as file:
            bounds = _complete(file)
            return self._read(file, 0, int(bounds[-1, 1]) if len(bounds) else 0, columns)

    def array(self, name: str, start: float = -np.inf, end: float = np.inf) -> NDArray[np.float64]:
        """A vector column as an array of shape (contacts, 3), over a window of time [s].

        ``name``: ``point`` [m, G], ``hull_point`` [m, V], ``normal``, ``impulse`` [N s],
        ``force`` [N] or ``couple`` [N m].

        >>> example_run.contacts.array("force").shape[1]
        3
        """
        if name not in _VECTORS:
            raise unknown(f"There is no vector '{name}'", name, _VECTORS)
        columns = [_VECTORS[name].format(axis) for axis in "xyz"]
        return self.between(start, end, columns).to_numpy(dtype=float)

    @contextmanager
    def _open(self) -> Iterator[h5py.File]:
        import h5py

        try:
            file = h5py.File(self.file, "r", locking=False)
        except OSError:
            # A mark of its writer remains where the run writes now or was killed while it did.
            try:
                file = h5py.File(self.file, "r", swmr=True, locking=False)
            except OSError as fault:
                raise NoRun(f"{self.file}: this cannot be read as HDF5: {fault}") from None
        with file:
            if _GROUP not in file or _STEPS not in file:
                raise NoRun(f"{self.file}: this holds no contacts of a run.")
            yield file

    def _attributes(self, key: str) -> dict[str, str]:
        with self._open() as file:
            return {name: _text(file[_GROUP][name].attrs.get(key, "")) for name in _names(file)}

    def _read(
        self, file: h5py.File, first: int, last: int, columns: Sequence[str] | None
    ) -> pd.DataFrame:
        names = _names(file)
        for column in several("columns", columns or ()):
            if column not in names:
                raise unknown(f"{self.file}: there is no column '{column}'", column, names)
        chosen = names if columns is None else list(columns)
        group = file[_GROUP]
        frame = pd.DataFrame({name: group[name][first:last] for name in chosen}, columns=chosen)
        frame.attrs["units"] = {name: _text(group[name].attrs.get("unit", "")) for name in chosen}
        return frame


_VECTORS = {
    "point": "{}_m",
    "hull_point": "hull_{}_m",
    "normal": "n{}",
    "impulse": "impulse_{}_Ns",
    "force": "f{}_N",
    "couple": "couple_{}_Nm",
}
_ORDER = [
    "time_s",
    "step",
    "body",
    "other",
    *(name.format(axis) for name in ("{}_m", "hull_{}_m", "n{}") for axis in "xyz"),
    "gap_m",
    *(name.format(axis) for name in ("impulse_{}_Ns", "f{}_N", "couple_{}_Nm") for axis in "xyz"),
    "status",
    "part",
    "other_part",
    "key",
]


def _complete(file: h5py.File) -> NDArray[np.int64]:
    """First row and end of each step that is whole, as an array of shape (steps, 2).

    After a full disk, entries that do not continue from the one before are no steps.
    """
    bounds = np.asarray(file[_STEPS][:], dtype=np.int64).reshape(-1, 2)
    stored = min((len(column) for column in file[_GROUP].values()), default=0)
    begins = np.concatenate([[0], bounds[:-1, 1]]) if len(bounds) else np.empty(0, dtype=np.int64)
    good = (bounds[:, 0] == begins) & (bounds[:, 1] >= bounds[:, 0]) & (bounds[:, 1] <= stored)
    bad = np.flatnonzero(~good)
    return bounds[: bad[0]] if len(bad) else bounds


def _first_row(times: h5py.Dataset, rows: int, time: float, or_equal: bool) -> int:
    """The first row with a time above ``time``, or equal to it, by halving; rows rise in time."""
    low, high = 0, rows
    while low < high:
        middle = (low + high) // 2
        at = float(times[middle])
        if at > time or (or_equal and at == time):
            high = middle
        else:
            low = middle + 1
    return low


def _names(file: h5py.File) -> list[str]:
    """Columns in the order of the reference; HDF5 lists them by the alphabet."""
    places = {name: place for place, name in enumerate(_ORDER)}
    return sorted(file[_GROUP], key=lambda name: places.get(name, len(places)))


def _text(value: Any) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)
