"""All bodies of a run with their shapes, and their poses at one time or over time."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nilas.results.bodies import Bodies
from nilas.results.folder import NoRun
from nilas.results.replay import Body, Shape

if TYPE_CHECKING:
    from nilas.results.run import Run


class Motion(NamedTuple):
    """``bodies``: what each body is, by its id. ``shapes``: by their numbers.

    ``poses``: positions and attitudes over time, exact where the run has bodies.csv.

    >>> motion = motion_of(example_run)
    >>> {body.shape in motion.shapes for body in motion.bodies.values()}
    {True}
    """

    bodies: dict[int, Body]
    shapes: dict[int, Shape]
    poses: Bodies


def motion_of(run: Run, between: tuple[float, float] | None = None) -> Motion:
    """Bodies, shapes and poses from one time to another [s], or of the whole run.

    >>> len(motion_of(example_run, between=(0.2, 0.3)).poses.times)
    2
    """
    poses = run.read_bodies(between)
    if not len(poses.times):
        times = run.replay.times
        known = f"The frames are from {times[0]:g} s to {times[-1]:g} s." if len(times) else ""
        raise NoRun(f"{run.folder}: there is no frame from {between} s. {known}".strip())
    replay = run.replay
    return Motion(replay.bodies(), replay.shapes, poses)


def moment_of(run: Run, time: float | None) -> Motion:
    """The same at the stored time nearest to ``time`` [s]; at the last one where it is None.

    >>> moment_of(example_run, time=0.22).poses.times.tolist()
    [0.2]
    """
    times = run.replay.times
    if not len(times):
        raise NoRun(f"{run.folder}: this run has no frame yet.")
    nearest = float(times[-1] if time is None else times[np.argmin(np.abs(times - time))])
    # The replay and bodies.csv have the same times, in other digits.
    margin = 1e-6 * max(1.0, abs(nearest))
    return motion_of(run, (nearest - margin, nearest + margin))


def with_steady_signs(quaternion: NDArray[np.float64]) -> NDArray[np.float64]:
    """Attitudes over time, shape (times, 4), each with the sign that is nearer to the one before.

    q and -q are one attitude, but what lies between two of them depends on the sign.

    >>> with_steady_signs(np.array([[1.0, 0, 0, 0], [-1, 0, 0, 0]])).tolist()
    [[1.0, 0.0, 0.0, 0.0], [1.0, -0.0, -0.0, -0.0]]
    """
    along = np.einsum("ij,ij->i", quaternion[1:], quaternion[:-1])
    signs = np.cumprod(np.where(along < 0, -1.0, 1.0))
    steady = quaternion.copy()
    steady[1:] *= signs[:, None]
    return steady
