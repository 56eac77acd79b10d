"""One run folder: everything in it, read when it is asked for."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pandas as pd

from nilas.results.bodies import Bodies, read_bodies
from nilas.results.contacts import Contacts
from nilas.results.folder import NoRun, UnfinishedRun, demand_run, read_summary, state_of
from nilas.results.replay import Replay
from nilas.results.scene_text import attributes_of
from nilas.results.statistics import figures_of, load_table, structure_table
from nilas.results.tables import TABLES, column_names, read_table, table_file, to_dataset
from nilas.results.trajectory import Trajectory
from nilas.results.units import units_of

if TYPE_CHECKING:
    import xarray as xr


class Run:
    """A run folder. Nothing but the end of the run is read before it is asked for.

    ``folder``: the folder that ``nilas run`` wrote. Raises ``NoRun`` where it is none. Warns
    (``UnfinishedRun``) of a run that failed, was interrupted or was killed. A run that still goes
    on can be read too: each answer has the whole rows that are there now.

    >>> run = Run(example_folder)
    >>> run  # doctest: +ELLIPSIS
    <Run small: done, 0.5 s, ...>
    >>> float(run.vessel.ice_resistance_N.loc[0.2:0.3].mean()) >= 0
    True
    """

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = Path(folder)
        demand_run(self.folder)
        self._kept: dict[str, tuple[tuple[int, int], pd.DataFrame]] = {}
        if trouble := self.trouble:
            warnings.warn(f"{self.folder}: {trouble}", UnfinishedRun, stacklevel=2)

    def __repr__(self) -> str:
        summary = read_summary(self.folder) or {}
        name = summary.get("scene") or self.folder.name
        end = summary.get("time_end_s")
        time = f", {end:g} s" if isinstance(end, (int, float)) else ""
        return f"<Run {name}: {self.status}{time}, {self.folder}>"

    # How it ended

    @property
    def status(self) -> str:
        """``done``, ``failed``, ``interrupted``, ``running`` or ``killed``.

        >>> example_run.status
        'done'
        """
        return state_of(self.folder, read_summary(self.folder)).status

    @property
    def trouble(self) -> str:
        """Why the run did not reach its end, in a sentence. Empty where it did or goes on.

        >>> example_run.trouble
        ''
        """
        return state_of(self.folder, read_summary(self.folder)).trouble

    @property
    def summary(self) -> dict[str, Any]:
        """The content of summary.json, with names as in the reference of outputs.

        >>> example_run.summary["status"]
        'done'
        """
        summary = read_summary(self.folder)
        if summary is None:
            raise NoRun(
                f"{self.folder}: this run has no summary.json, since it is {self.status}. Its"
                " tables can be read."
            )
        return summary

    # Tables

    @property
    def tables(self) -> list[str]:
        """Names of the tables that the run has.

        >>> example_run.tables
        ['vessel', 'steps', 'bodies']
        """
        return [name for name, kind in TABLES.items() if (self.folder / kind.file).is_file()]

    def table(
        self,
        name: str,
        columns: Sequence[str] | None = None,
        between: tuple[float, float] | None = None,
    ) -> pd.DataFrame:
        """One table: ``vessel``, ``steps``, ``structures``, ``parts``, ``bodies``, ``events``.

        ``columns``: those to read, all if None. ``between``: first and last time [s]. Tables with
        a row per step have the index ``time_s``. ``attrs["units"]`` has the units.

        >>> some = example_run.table("vessel", columns=["x_m"], between=(0.2, 0.4))
        >>> list(some.columns), some.attrs["units"]["x_m"]
        (['x_m'], 'm')
        """
        return read_table(self.folder, name, columns=columns, between=between)

    @property
    def vessel(self) -> pd.DataFrame:
        """Loads on the vessel and its motion, a row per step.

        >>> example_run.vessel.index.name
        'time_s'
        """
        return self._whole("vessel")

    @property
    def steps(self) -> pd.DataFrame:
        """Contacts, residuals, energy, momentum and times, a row per step.

        >>> bool((example_run.steps.status == "converged").any())
        True
        """
        return self._whole("steps")

    @property
    def structures(self) -> pd.DataFrame:
        """Loads on bodies that the scene holds fixed, a row per step.

        >>> "pier_contact_fx_N" in breaking_run.structures.columns
        True
        """
        return self._whole("structures")

    @property
    def parts(self) -> pd.DataFrame:
        """Joints and loads of the vessel's parts, a row per step.

        >>> breaking_run.parts  # doctest: +ELLIPSIS
        Traceback (most recent call last):
        nilas.results.folder.NoRun: ...: this run has no parts.csv; runs with <part> or <rod> have it.
        """
        return self._whole("parts")

    @property
    def events(self) -> pd.DataFrame:
        """Floes that broke, a row per floe.

        >>> bool((breaking_run.events.time_s <= 1.0).all()) and len(breaking_run.events) > 0
        True
        """
        return self._whole("events")

    def units(self, table: str) -> dict[str, str]:
        """The unit of each column of a table; ``"1"`` for pure numbers, empty for texts.

        >>> example_run.units("vessel")["contact_mz_Nm"]
        'N m'
        """
        if table == "contacts":
            return self.contacts.units
        return units_of(column_names(table_file(self.folder, table)))

    def dataset(
        self,
        name: str,
        columns: Sequence[str] | None = None,
        between: tuple[float, float] | None = None,
    ) -> xr.Dataset:
        """One table as an xarray Dataset along ``time_s``, with units as attributes.

        >>> example_run.dataset("vessel").contact_fx_N.attrs["units"]
        'N'
        """
        return to_dataset(self.table(name, columns, between))

    # Bodies, contacts, frames, problems

    @property
    def bodies(self) -> Bodies:
        """Poses of all bodies over time, as numpy arrays.

        >>> example_run.bodies.one("ship").position.shape[1:]
        (1, 3)
        """
        return self.read_bodies()

    def read_bodies(self, between: tuple[float, float] | None = None) -> Bodies:
        """Poses of all bodies from one time to another [s], or of the whole run.

        >>> bool(example_run.read_bodies(between=(0.2, 0.3)).times.max() <= 0.3)
        True
        """
        return read_bodies(self.folder, between)

    @property
    def contacts(self) -> Contacts:
        """Contacts of each step, without reading the whole file.

        >>> example_run.contacts.steps
        50
        """
        return Contacts(self.folder / "contacts.h5")

    @property
    def trajectory(self) -> Trajectory:
        """Surfaces of ice, vessel and bodies over time, as ParaView shows them.

        >>> len(example_run.trajectory.times)
        6
        """
        return Trajectory(self.folder)

    @property
    def replay(self) -> Replay:
        """Shapes and motion of all bodies from replay.bin.

        >>> example_run.replay.head["scene"]
        'small'
        """
        return Replay(self.folder / "replay.bin")

    @property
    def problems(self) -> list[Path]:
        """Files of the stored contact problems, in FCLIB form.

        >>> [file.name for file in example_run.problems]
        ['worst.hdf5']
        """
        return sorted((self.folder / "problems").glob("*.hdf5"))

    # Statistics

    @property
    def window(self) -> tuple[float, float]:
        """Time over which the program took means and peaks: from, to [s].

        >>> start, end = example_run.window
        """
        window = self.summary.get("window")
        if not window:
            raise NoRun(
                f"{self.folder}: this run has no window of statistics, as without a vessel."
            )
        return float(window["from_s"]), float(window["to_s"])

    @property
    def loads(self) -> pd.DataFrame:
        """Statistics of each load channel of the vessel over the window, a row per channel.

        >>> example_run.loads.loc["ice_resistance_N", "unit"]
        'N'
        """
        return load_table(self.summary)

    @property
    def structure_loads(self) -> pd.DataFrame:
        """Statistics of the loads on fixed bodies, a row per body and channel.

        >>> breaking_run.structure_loads.loc[("pier", "contact_fx_N"), "unit"]
        'N'
        """
        return structure_table(self.summary)

    @property
    def figures(self) -> dict[str, float | str | bool]:
        """All single values of the summary, as in ``ice_load.along.mean_N``.

        >>> example_run.figures["steps"]
        50
        """
        return figures_of(self.summary)

    @property
    def settings(self) -> dict[str, str]:
        """Attributes of the scene as run, by the paths that ``--set`` takes.

        >>> example_run.settings["vessel/carriage/@speed"]
        '0.3'
        """
        return attributes_of(self.folder / "scene.xml")

    @property
    def log(self) -> str:
        """The log of the run.

        >>> isinstance(example_run.log, str)
        True
        """
        file = self.folder / "nilas.log"
        return file.read_text(encoding="utf-8", errors="replace") if file.is_file() else ""

    # Exports

    def to_mujoco(self, path: str | os.PathLike[str], time: float | None = None) -> Path:
        """Writes all bodies at a time [s] (default: the last frame) as a MuJoCo model.

        ``path``: the XML file. Meshes go into a folder of its name beside it. Returns the path.

        >>> run_file = example_run.to_mujoco("small.xml", time=0.2)
        >>> run_file.name
        'small.xml'
        """
        from nilas.exchange.mujoco import write_mujoco

        return write_mujoco(self, Path(path), time)

    def to_gltf(
        self,
        path: str | os.PathLike[str],
        between: tuple[float, float] | None = None,
    ) -> Path:
        """Writes the motion of all bodies as an animation for Blender and browsers (glTF 2.0).

        ``path``: the file, with the ending ``.glb``. ``between``: first and last time [s].

        >>> example_run.to_gltf("small.glb").name
        'small.glb'
        """
        from nilas.exchange.gltf import write_gltf

        return write_gltf(self, Path(path), between)

    def _whole(self, name: str) -> pd.DataFrame:
        """A whole table, kept until its file changes."""
        file = self.folder / TABLES[name].file
        state = file.stat() if file.is_file() else None
        stamp = (state.st_size, state.st_mtime_ns) if state else (0, 0)
        if name not in self._kept or self._kept[name][0] != stamp:
            self._kept[name] = (stamp, self.table(name))
        return self._kept[name][1]
