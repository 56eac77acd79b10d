"""Several runs together: in what they differ, and their figures, in one table."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any, overload

import pandas as pd

from nilas.arguments import several
from nilas.names import unknown
from nilas.results.folder import NoRun, is_run
from nilas.results.run import Run
from nilas.results.statistics import figures_of, has_figure

# Figures of the summary that the table of runs has unless others are asked for.
_FIGURES = [
    "time_end_s",
    "ice_load.along.mean_N",
    "ice_load.along.estimate_N",
    "ice_load.along.std_N",
    "ice_load.along.p99_N",
    "ice_load.along.filtered_peak_N",
    "ice_load.across.mean_N",
    "tow_force.mean_N",
    "shortfalls.unconverged_steps",
    "wall_s",
]
_SEED = "seed/@value"
_WITHOUT_SUMMARY = ("running", "killed")


def runs(
    folders: str | os.PathLike[str] | Iterable[str | os.PathLike[str] | Run],
) -> Runs:
    """Several runs as one list.

    ``folders``: run folders, or one folder that has run folders at any depth.

    >>> together = runs([example_folder, example_folder])
    >>> len(together)
    2
    >>> together.table("vessel", columns=["x_m"]).index.names
    FrozenList(['run', 'time_s'])
    """
    if isinstance(folders, (str, os.PathLike)):
        top = Path(folders)
        found = sorted({file.parent for file in top.rglob("scene.xml") if is_run(file.parent)})
        if not found:
            raise NoRun(f"{top}: there is no run folder here.")
        return Runs([Run(folder) for folder in found])
    return Runs([run if isinstance(run, Run) else Run(run) for run in folders])


class Runs(Sequence[Run]):
    """A list of runs with tables over all of them.

    >>> together = Runs([example_run, example_run])
    >>> len(together), together[0].status, together.names
    (2, 'done', ['small (1)', 'small (2)'])
    """

    def __init__(self, members: Sequence[Run]) -> None:
        if not members:
            raise NoRun("There is no run to compare.")
        self._members = list(members)
        self.names = _names([run.folder for run in members])

    @overload
    def __getitem__(self, place: int) -> Run: ...

    @overload
    def __getitem__(self, place: slice) -> Runs: ...

    def __getitem__(self, place: int | slice) -> Run | Runs:
        return Runs(self._members[place]) if isinstance(place, slice) else self._members[place]

    def __len__(self) -> int:
        return len(self._members)

    def __iter__(self) -> Iterator[Run]:
        return iter(self._members)

    @property
    def frame(self) -> pd.DataFrame:
        """A row per run: its status, where its scene differs, its seed and its main figures.

        Figures that a run does not have are nan, as all are of runs that still go on.

        >>> bool(runs([example_folder]).frame["ice_load.along.mean_N"].notna().all())
        True
        """
        return self._table_of(_FIGURES)

    def figures(self, names: Sequence[str]) -> pd.DataFrame:
        """The same with figures of summary.json of your choice, as in ``ice_load.along.mean_N``.

        Raises ``UnknownName`` for a figure that no run has, once a run has ended.

        >>> list(runs([example_folder]).figures(["steps"]).columns)
        ['status', 'seed/@value', 'steps']
        >>> runs([example_folder]).figures(["ice_load.along.maen_N"])  # doctest: +ELLIPSIS
        Traceback (most recent call last):
        nilas.errors.UnknownName: No run has a figure 'ice_load.along.maen_N'; did you mean ice_load.along.mean_N, ...
        """
        names = several("names", names)
        summaries = [run.summary for run in self if run.status not in _WITHOUT_SUMMARY]
        for name in names if summaries else []:
            if not any(has_figure(summary, name) for summary in summaries):
                known = dict.fromkeys(one for summary in summaries for one in figures_of(summary))
                raise unknown(f"No run has a figure '{name}'", name, known, what="figures")
        return self._table_of(names)

    def _table_of(self, names: Sequence[str]) -> pd.DataFrame:
        """Status, settings and figures, a row per run; nan where a run has no such figure."""
        rows = []
        for run, settings in zip(self, self.settings.to_dict("records")):
            row: dict[Any, Any] = {"status": run.status, **settings}
            figures = run.figures if run.status not in _WITHOUT_SUMMARY else {}
            row.update({name: figures.get(name) for name in names})
            rows.append(row)
        frame = pd.DataFrame(rows, index=pd.Index(self.names, name="run"))
        for name in names:
            if frame[name].isna().all():
                frame[name] = frame[name].astype(float)
        return frame

    @property
    def settings(self) -> pd.DataFrame:
        """The seed, and the attributes in which the scenes differ, a row per run.

        Attributes that are numbers in all runs are numbers here.

        >>> list(runs([example_folder, example_folder]).settings.columns)
        ['seed/@value']
        """
        table = pd.DataFrame(
            [run.settings for run in self], index=pd.Index(self.names, name="run"), dtype=object
        )
        differing = [
            path
            for path in table.columns
            if path == _SEED or table[path].fillna("").nunique(dropna=False) > 1
        ]
        return table[differing].apply(_as_numbers)

    def table(
        self,
        name: str,
        columns: Sequence[str] | None = None,
        between: tuple[float, float] | None = None,
    ) -> pd.DataFrame:
        """One table of all runs below each other, with the name of the run as first index.

        >>> runs([example_folder]).table("vessel", columns=["x_m"], between=(0.2, 0.3)).shape[1]
        1
        """
        parts = [run.table(name, columns, between) for run in self]
        frame = pd.concat(parts, keys=self.names, names=["run"])
        frame.attrs["units"] = parts[0].attrs["units"]
        return frame

    @property
    def loads(self) -> pd.DataFrame:
        """Statistics of the load channels of all runs, by run and channel.

        >>> runs([example_folder]).loads.index.names
        FrozenList(['run', 'channel'])
        """
        return pd.concat([run.loads for run in self], keys=self.names, names=["run"])


def _names(folders: list[Path]) -> list[str]:
    """Short names of the runs: what their paths do not share; with a number where they are one."""
    absolute = [folder.absolute() for folder in folders]
    shared = Path(os.path.commonpath([folder.parent for folder in absolute]))
    names = [folder.relative_to(shared).as_posix() for folder in absolute]
    return [
        name if names.count(name) == 1 else f"{name} ({1 + names[:place].count(name)})"
        for place, name in enumerate(names)
    ]


def _as_numbers(column: pd.Series) -> pd.Series:
    try:
        return pd.to_numeric(column)
    except (ValueError, TypeError):
        return column
