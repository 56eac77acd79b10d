"""Runs of a scene within Python, step by step."""

import math
import numbers
import os
import pathlib
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from nilas import _core
from nilas.arguments import number, whole
from nilas.errors import InputError
from nilas.names import unknown
from nilas.scene.scene import Scene, Settings, checked

if TYPE_CHECKING:
    import pandas

Callback = Callable[["Simulation"], Any]


class Simulation:
    """A scene that is simulated in this process. Its states have the same bits as a run of the program.

    `scene` is a `nilas.Scene` or the path of a scene file, and `settings` are those of `--set`. With `folder` every
    step is also written to a run folder, like that of `nilas run`; `force` replaces an earlier run there. The folder is
    finished at the scene's end, by `close`, or at the end of a `with`. With `applied_loads` the method `apply` may load
    bodies. Without `keep_table` no table of the steps is kept, so that memory stays the same over any number of steps;
    `last` then has the numbers of one step. Other threads of Python run while a step is taken. One thread at a time may use a simulation, and a process
    that was forked must build its own.

    >>> simulation = Simulation(small_scene)
    >>> step = simulation.step()
    >>> step.number, round(step.time, 6)
    (1, 0.01)
    >>> simulation.bodies.position.shape[1]
    3
    """

    def __init__(
        self,
        scene: Scene | str | os.PathLike[str],
        *,
        settings: Settings | None = None,
        scale: float = 1.0,
        threads: int = 1,
        applied_loads: bool = False,
        folder: str | os.PathLike[str] | None = None,
        force: bool = False,
        keep_table: bool = True,
    ) -> None:
        self.scene = checked(scene, settings, scale)
        self.folder = pathlib.Path(folder) if folder is not None else None
        self.keep_table = keep_table
        self._core = _core.Simulation(
            self.scene,
            threads=whole("threads", threads),
            applied_loads=bool(applied_loads),
            folder=self.folder,
            force=bool(force),
            keep_rows=bool(keep_table),
        )

    # Time

    @property
    def time(self) -> float:
        """The present time [s].

        >>> Simulation(small_scene).time
        0.0
        """
        return self._core.time

    @property
    def steps(self) -> int:
        """The number of steps since the start.

        >>> Simulation(small_scene).run(until=0.03).steps
        3
        """
        return self._core.steps

    @property
    def is_done(self) -> bool:
        """Whether the scene's end is reached, or the carriage's course has ended.

        >>> Simulation(small_scene, settings={"time/@end": 0.02}).run().is_done
        True
        """
        return self._core.is_done

    def step(self) -> _core.Step:
        """Advances by the scene's step and returns what it did: contacts, residual, loads on the vessel.

        Raises `nilas.SimulationError` where the numerics fail; a run folder then ends as failed. Ctrl-C is raised
        after the step, when it is written and kept.

        >>> Simulation(small_scene).step().number
        1
        """
        return self._core.step()

    @property
    def last(self) -> _core.Step | None:
        """What the last step did; None before the first, and after `restore`.

        >>> simulation = Simulation(small_scene)
        >>> simulation.last is None and simulation.step().number == simulation.last.number
        True
        """
        return self._core.last

    def run(self, until: float | None = None, callback: Callback | None = None) -> "Simulation":
        """Takes steps until the time `until` [s], or to the scene's end, and returns the simulation.

        Before each step `callback(simulation)` is called. It may look at the simulation, load bodies (`apply`) and set
        commands, and it ends this call by returning True. `run` may be called again to go on. At the scene's end the
        run folder is finished. Ctrl-C ends the run between two steps; the folder is complete up to there.

        >>> simulation = Simulation(small_scene)
        >>> simulation.run(until=0.05).steps
        5
        >>> simulation.run(callback=lambda s: s.steps >= 7).steps
        7
        """
        end = math.inf if until is None else number("until", until) - 0.5 * self.scene.step
        try:
            while not self.is_done and self.time < end:
                if callback is not None and callback(self):
                    break
                self.step()
        except KeyboardInterrupt:
            self.close("interrupted")
            raise
        except BaseException as error:
            self.close("failed", str(error))
            raise
        if self.is_done:
            self.close()
        return self

    def close(self, status: str = "done", message: str = "") -> None:
        """Finishes the run folder, if there is one: writes its summary. Nothing more can be written to it.

        `status` is done, interrupted or failed, and `message` says why in its log.

        >>> with Simulation(small_scene, folder="short") as simulation:
        ...     step = simulation.step()
        >>> import nilas
        >>> nilas.Run("short").status
        'done'
        """
        self._core.finish(status, message)

    def __enter__(self) -> "Simulation":
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: object) -> None:
        if kind is None:
            self.close()
        else:
            self.close("interrupted" if kind is KeyboardInterrupt else "failed", str(error))

    # State

    @property
    def bodies(self) -> _core.BodyStates:
        """All n bodies now, a row per body, in the ground frame.

        `id`, `name` and `kind` are lists. `mass`: (n,) [kg]. `position`: (n, 3) [m], of the centres of mass.
        `orientation`: (n, 4), unit quaternions in the order (w, x, y, z), from body axes to the ground frame.
        `velocity`: (n, 3) [m/s]. `angular_velocity`: (n, 3) [rad/s]. The arrays are copies that cannot be changed.

        >>> Simulation(small_scene).bodies.orientation[0].tolist()  # the vessel is upright
        [1.0, 0.0, 0.0, 0.0]
        """
        return self._core.bodies

    @property
    def vessel(self) -> int | None:
        """The index of the vessel among the bodies; None without one.

        >>> simulation = Simulation(small_scene)
        >>> simulation.bodies.name[simulation.vessel]
        'ship'
        """
        return None if self._core.vessel < 0 else self._core.vessel

    @property
    def modules(self) -> dict[str, str]:
        """The models that were built, each with what asks for it.

        >>> Simulation(small_scene).modules["buoyancy"]
        '<hydro><buoyancy>'
        """
        return dict(self._core.modules)

    @property
    def warnings(self) -> dict[str, int]:
        """Warnings since the start, by kind, with their numbers.

        >>> Simulation(small_scene).run(until=0.05).warnings
        {}
        """
        return dict(self._core.warnings)

    def table(self) -> "pandas.DataFrame":
        """The steps taken here, as `steps.csv` has them, indexed by time in s. A row per step.

        >>> simulation = Simulation(small_scene)
        >>> simulation.run(until=0.05).table()["kinetic_J"].size
        5
        """
        self._demand_table()
        return _table(self._core.step_columns, self._core.rows, None)

    def vessel_table(self) -> "pandas.DataFrame":
        """Loads on the vessel and its motion in the steps taken here, as `vessel.csv` has them, indexed by time in s.

        A row per step. The names of the columns end in their units.

        >>> simulation = Simulation(small_scene)
        >>> loads = simulation.run(until=0.05).vessel_table()
        >>> len(loads), loads.index.name, "ice_resistance_N" in loads.columns
        (5, 'time_s', True)
        """
        if self.vessel is None:
            raise InputError("The scene has no vessel.")
        self._demand_table()
        return _table(self._core.vessel_columns, self._core.vessel_rows, self._core.rows[:, 0])

    def _demand_table(self) -> None:
        if not self.keep_table:
            raise InputError(
                "This simulation keeps no table, as keep_table=False asks; allowed: `last`, and the tables of a run folder."
            )

    # Control

    def apply(
        self,
        body: int | str,
        force: Sequence[float] = (0, 0, 0),
        *,
        torque: Sequence[float] = (0, 0, 0),
        point: Sequence[float] | None = None,
    ) -> None:
        """Loads a body, by its index or name, during the next step.

        `force` in N and `torque` in N m are in the ground frame. The force acts at `point` (m, ground frame), or at
        the centre of mass. Several loads add up.

        >>> simulation = Simulation(small_scene, applied_loads=True)
        >>> simulation.apply(0, force=[1, 0, 0])
        >>> step = simulation.step()
        """
        self._core.apply(
            self._index_of(body),
            _three("force", force),
            _three("torque", torque),
            None if point is None else _three("point", point),
        )

    def _index_of(self, body: int | str) -> int:
        if isinstance(body, str):
            names = self.bodies.name
            if body not in names:
                raise unknown(f"There is no body '{body}'", body, names, what="bodies")
            return names.index(body)
        if isinstance(body, bool) or not isinstance(body, numbers.Integral):
            raise InputError(f"A body is named by its index or its name; found {body!r}.")
        return int(body)

    @property
    def commands(self) -> dict[str, float]:
        """What rudders, propellers and thrusters are asked for, by name, in SI units.

        >>> Simulation(steered_scene).commands
        {'bow.thrust': 0.0}
        """
        return dict(self._core.commands)

    def command(self, values: Mapping[str, float] | None = None, **more: float) -> None:
        """Sets commands by name, from the next step on, in SI units with angles in rad.

        Names are those of `commands`. One that is no word of Python, such as `bow.thrust`, stands in `values`; others
        may be keywords, as `command(rudder=0.1)`.

        >>> simulation = Simulation(steered_scene)
        >>> simulation.command({"bow.thrust": 20.0})  # [N]
        >>> simulation.commands
        {'bow.thrust': 20.0}
        """
        for name, value in {**(values or {}), **more}.items():
            if isinstance(value, (str, bytes)) or not hasattr(value, "__float__"):
                raise InputError(f"The command {name} is a number; found {value!r}.")
            self._core.set_command(name, float(value))

    @property
    def problem(self) -> _core.Problem:
        """The contact problem of the last step, with its first guess and its solution, (nc, 3) [N s].

        >>> import nilas
        >>> simulation = Simulation(small_scene)
        >>> while simulation.step().contacts == 0:
        ...     pass
        >>> nilas.measure(simulation.problem, simulation.problem.solution)["law_map_m_s"] <= 1e-6
        True
        """
        return self._core.last_problem

    def snapshot(self) -> _core.Snapshot:
        """The present state, for `restore`.

        >>> simulation = Simulation(small_scene)
        >>> start = simulation.snapshot()
        >>> first = simulation.step().state_hash
        >>> simulation.restore(start)
        >>> simulation.step().state_hash == first
        True
        """
        return self._core.snapshot()

    def restore(self, snapshot: _core.Snapshot) -> None:
        """Returns to a state of this scene. The next steps have the same bits as they had from there.

        The scene is built anew for it, which takes as long as at the start. A simulation that writes a run folder
        cannot go back.

        >>> simulation = Simulation(small_scene)
        >>> simulation.run(until=0.05).restore(simulation.snapshot())
        >>> start = Simulation(small_scene).snapshot()
        >>> simulation.restore(start)
        >>> simulation.steps
        0
        """
        self._core.restore(snapshot)


def _three(what: str, values: Sequence[float]) -> list[float]:
    try:
        array = np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        raise InputError(f"{what} is three numbers; found {values!r}.") from None
    if array.shape != (3,):
        raise InputError(f"{what} has the shape {array.shape}; allowed: (3,).")
    return array.tolist()


def _table(columns: list[str], rows: np.ndarray, times: np.ndarray | None) -> "pandas.DataFrame":
    import pandas

    frame = pandas.DataFrame(rows.reshape(-1, len(columns)), columns=columns)
    if times is not None:
        frame.insert(0, "time_s", times)
    return frame.set_index("time_s")
