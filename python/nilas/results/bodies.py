"""Motion of bodies over time as numpy arrays, from bodies.csv or else from replay.bin."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from nilas.errors import UnknownName
from nilas.names import unknown
from nilas.results.folder import NoRun
from nilas.results.replay import Frame, Replay
from nilas.results.tables import read_table

_POSITION = ["x_m", "y_m", "z_m"]
_TURN = ["qw", "qx", "qy", "qz"]
_VELOCITY = ["vx_m_s", "vy_m_s", "vz_m_s"]
_TURNING = ["wx_rad_s", "wy_rad_s", "wz_rad_s"]
_PLACES = len(_POSITION) + len(_TURN)
_EVERYWHERE = (-np.inf, np.inf)


@dataclass
class Bodies:
    """Poses of all bodies over time, in the ground frame G.

    ``times``: shape (times,) [s]. ``ids``: shape (bodies,), as in contacts and events. ``names``:
    one per body; floes of a replay have none. ``position``: shape (times, bodies, 3) [m], of the
    centres of mass. ``orientation``: shape (times, bodies, 4), unit quaternions in the
    order (w, x, y, z), from body axes to G, as in a simulation.
    Numbers are nan where a body does not exist, as floes that broke and pieces of floes.
    ``source``: ``bodies.csv``, which has all bits, or ``replay.bin``, which rounds.

    >>> bodies = example_run.bodies
    >>> bodies.position.shape == (len(bodies.times), len(bodies.ids), 3)
    True
    >>> bodies.orientation[0, bodies.place("ship")].tolist(), bodies.source
    ([1.0, 0.0, 0.0, 0.0], 'bodies.csv')
    """

    times: NDArray[np.float64]
    ids: NDArray[np.int64]
    names: list[str]
    position: NDArray[np.float64]
    orientation: NDArray[np.float64]
    source: str
    _velocity: NDArray[np.float64] | None = None
    _angular_velocity: NDArray[np.float64] | None = None

    def __len__(self) -> int:
        return len(self.ids)

    @property
    def velocity(self) -> NDArray[np.float64]:
        """Velocities of the centres of mass, shape (times, bodies, 3) [m/s]. Not of a replay.

        >>> example_run.bodies.velocity.shape[2]
        3
        """
        return self._exact(self._velocity, "velocities")

    @property
    def angular_velocity(self) -> NDArray[np.float64]:
        """Angular velocities in G, shape (times, bodies, 3) [rad/s]. Not of a replay.

        >>> example_run.bodies.angular_velocity.shape[2]
        3
        """
        return self._exact(self._angular_velocity, "angular velocities")

    def place(self, body: int | str) -> int:
        """Where a body stands along the second axis, by its id or its name.

        >>> example_run.bodies.place("ship") == example_run.bodies.place(
        ...     int(example_run.bodies.ids[example_run.bodies.place("ship")])
        ... )
        True
        """
        if isinstance(body, str):
            if body not in self.names:
                raise unknown(f"There is no body '{body}'", body, self.names, what="bodies")
            return self.names.index(body)
        found = np.flatnonzero(self.ids == body)
        if not len(found):
            known = f"ids from {self.ids.min()} to {self.ids.max()}" if len(self.ids) else "none"
            raise UnknownName(f"There is no body of the id {body!r}; allowed: {known}.")
        return int(found[0])

    def one(self, body: int | str) -> Bodies:
        """The motion of one body: the same arrays with one body along the second axis.

        >>> example_run.bodies.one("ship").position[:, 0].shape[1]
        3
        """
        at = slice(self.place(body), self.place(body) + 1)
        return Bodies(
            self.times,
            self.ids[at],
            self.names[at],
            self.position[:, at],
            self.orientation[:, at],
            self.source,
            None if self._velocity is None else self._velocity[:, at],
            None if self._angular_velocity is None else self._angular_velocity[:, at],
        )

    def _exact(self, values: NDArray[np.float64] | None, what: str) -> NDArray[np.float64]:
        if values is None:
            raise NoRun(
                f"replay.bin has no {what}. Set <output bodies='true'> in the scene to have them"
                " in bodies.csv."
            )
        return values


def read_bodies(folder: Path, between: tuple[float, float] | None = None) -> Bodies:
    """The motion of all bodies, of the whole run or from one time to another [s].

    >>> read_bodies(example_run.folder, between=(0, 0.1)).times.tolist()
    [0.0, 0.1]
    """
    if (folder / "bodies.csv").is_file():
        return _from_table(read_table(folder, "bodies", between=between))
    if (folder / "replay.bin").is_file():
        frames = list(Replay(folder / "replay.bin").frames(*(between or _EVERYWHERE)))
        return _from_frames(frames)
    raise NoRun(
        f"{folder}: this run stored no motion of bodies; <output trajectory_every> asks for it."
    )


def _from_table(table: pd.DataFrame) -> Bodies:
    times, row = np.unique(table["time_s"].to_numpy(dtype=float), return_inverse=True)
    ids, column = np.unique(table["id"].to_numpy(dtype=np.int64), return_inverse=True)
    names = [""] * len(ids)
    for place, name in zip(column, table["name"]):
        names[place] = name

    def spread(columns: list[str]) -> NDArray[np.float64]:
        values = np.full((len(times), len(ids), len(columns)), np.nan)
        values[row, column] = table[columns].to_numpy(dtype=float)
        return values

    return Bodies(
        times,
        ids,
        names,
        spread(_POSITION),
        spread(_TURN),
        "bodies.csv",
        spread(_VELOCITY),
        spread(_TURNING),
    )


def _from_frames(frames: list[Frame]) -> Bodies:
    names = {body.id: body.name for frame in frames for body in frame.bodies}
    ids = np.array(sorted(names), dtype=np.int64)
    poses = np.full((len(frames), len(ids), _PLACES), np.nan)
    for row, frame in enumerate(frames):
        columns = np.searchsorted(ids, [body.id for body in frame.bodies])
        poses[row, columns] = np.concatenate([frame.position, frame.orientation], axis=1)
    return Bodies(
        np.array([frame.time for frame in frames]),
        ids,
        [names[int(number)] for number in ids],
        poses[:, :, : len(_POSITION)],
        poses[:, :, len(_POSITION) :],
        "replay.bin",
    )
