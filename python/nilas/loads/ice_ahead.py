"""Ice ahead of the vessel over time, and how the load follows it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy import stats

from nilas.errors import InputError
from nilas.loads.series import CHANNEL, load_series
from nilas.results.folder import NoRun
from nilas.results.replay import Frame, Shape
from nilas.results.run import Run

_MOST_FRAMES = 200
_LEAST_FRAMES = 12
# Changes by less than this share of the largest value are rounding.
_ROUNDING = 1e-9


@dataclass(frozen=True)
class FollowedIce:
    """Correlation of the load with the ice ahead at each delay of the load.

    ``table``: a row per delay [s] with ``correlation``, its interval ``low`` to ``high`` of 95 %,
    and ``independent``, the number of independent pairs that the two series are worth.

    >>> ice = pd.Series([0.1, 0.9, 0.2, 0.8] * 5, index=np.arange(20.0))
    >>> found = follow(ice, ice.shift(1).dropna(), [0.0, 1.0])
    >>> round(float(found.table.correlation.loc[1.0]), 6), found.best_delay_s
    (1.0, 1.0)
    """

    table: pd.DataFrame

    @property
    def best_delay_s(self) -> float:
        """The delay with the largest correlation [s]."""
        return float(self.table["correlation"].idxmax())


def clipped_area(corners: NDArray[np.float64], length: float, width: float) -> float:
    """Area of the part of a polygon with 0 <= x <= length and |y| <= width / 2 [m^2].

    The polygon may be hollow inward. Sides of the window cut it one after another (Sutherland and
    Hodgman 1974).

    >>> clipped_area(np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]), 4.0, 1.0)
    1.0
    """
    sides = ((0, 1.0, 0.0), (0, -1.0, length), (1, 1.0, width / 2), (1, -1.0, width / 2))
    points = corners
    for axis, sign, bound in sides:
        if len(points) < 3:
            return 0.0
        depth = sign * points[:, axis] + bound
        kept = []
        for here, there, inside, next_inside in zip(
            points, np.roll(points, -1, axis=0), depth, np.roll(depth, -1), strict=True
        ):
            if inside >= 0:
                kept.append(here)
            if (inside >= 0) != (next_inside >= 0):
                kept.append(here + (there - here) * inside / (inside - next_inside))
        points = np.array(kept).reshape(-1, 2)
    if len(points) < 3:
        return 0.0
    x, y = points[:, 0] - points[0, 0], points[:, 1] - points[0, 1]
    return abs(0.5 * float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))


def ice_ahead(run: Run, lengths: float = 1.0) -> pd.Series:
    """Share of the water ahead of the vessel that ice covers, by time [s].

    The window is one beam wide and ``lengths`` hull lengths long, from the foremost point along the
    heading. At most 200 stored frames are taken. Raises ``NoRun`` where the run stored none.

    >>> cover = ice_ahead(example_run)
    >>> bool(((cover >= 0) & (cover <= 1)).all())
    True
    """
    replay = run.replay
    times = replay.times
    stride = max(1, math.ceil(len(times) / _MOST_FRAMES))
    shapes = replay.shapes
    found = {}
    for number, frame in enumerate(replay.frames()):
        if number % stride == 0:
            found[frame.time] = _cover(frame, shapes, lengths, run)
    if not found:
        raise NoRun(f"{replay.file}: this holds no frame yet.")
    return pd.Series(found, name="ice_ahead").rename_axis("time_s")


def load_and_ice_ahead(
    run: Run, channel: str = CHANNEL, *, lengths: float = 0.25, delays: int = 13
) -> FollowedIce:
    """How the load follows the ice in a window ahead: correlation by delay.

    ``lengths``: length of the window in hull lengths. The load is averaged over the time in which
    the vessel passes the window. ``delays`` are spread evenly from 0 to twice that time. A run of
    constant speed is needed, with at least 12 stored frames in its window.

    >>> load_and_ice_ahead(example_run)  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    nilas.errors.InputError: A correlation needs 12 stored frames in the window, and there are ...
    """
    load = load_series(run, channel)
    cover = ice_ahead(run, lengths)
    cover = cover[(cover.index >= load.start) & (cover.index <= load.start + load.duration)]
    if len(cover) < _LEAST_FRAMES:
        raise InputError(
            f"A correlation needs {_LEAST_FRAMES} stored frames in the window, and there are"
            f" {len(cover)}."
        )
    passage = lengths * _hull_length(run) / _speed(run, load.start, load.start + load.duration)
    edges = load.start + load.step * np.arange(len(load.values) + 1)
    impulse = np.concatenate([[0.0], np.cumsum(load.values * load.step)])
    times = np.linspace(edges[0] + passage / 2, edges[-1] - passage / 2, 4 * len(load.values))
    if passage > load.duration / 2:
        raise InputError("The vessel does not pass the window ahead twice in this time: run longer.")
    ends = [np.interp(times + side * passage / 2, edges, impulse) for side in (-1, 1)]
    means = pd.Series((ends[1] - ends[0]) / passage, index=times)
    return follow(cover, means, np.linspace(0.0, 2 * passage, delays))


def follow(ice: pd.Series, load: pd.Series, delays) -> FollowedIce:
    """Correlation of a load with the ice at an earlier time, for each delay [s].

    Both are series by time. The load is interpolated. The interval is that of Fisher's
    transformation, with as many pairs as the memory of both series leaves independent. Raises
    ``InputError`` where one of the series does not change.

    >>> time = np.arange(0.0, 400.0)
    >>> ice = pd.Series(np.random.default_rng(1).normal(size=400), index=time)
    >>> follow(ice, ice, [0.0]).table.correlation.round(6).tolist()
    [1.0]
    """
    for series, name in ((ice, "ice ahead"), (load, "load")):
        if np.ptp(series.to_numpy()) <= _ROUNDING * np.abs(series.to_numpy()).max():
            raise InputError(f"The {name} does not change, so no correlation can be taken.")
    rows = {}
    for delay in delays:
        wanted = ice.index.to_numpy(dtype=float) + delay
        inside = (wanted >= load.index[0]) & (wanted <= load.index[-1])
        x = ice.to_numpy()[inside]
        y = np.interp(wanted[inside], load.index.to_numpy(dtype=float), load.to_numpy())
        rows[float(delay)] = correlation(x, y)
    names = ["correlation", "low", "high", "independent"]
    table = pd.DataFrame.from_dict(rows, orient="index", columns=names)
    table.index.name = "delay_s"
    return FollowedIce(table)


def correlation(
    x: NDArray[np.float64], y: NDArray[np.float64]
) -> tuple[float, float, float, float]:
    """Pearson's correlation of two series, its interval of 95 %, and the independent pairs.

    Neighbours of a series resemble each other. With r1 and r2 the correlations of neighbours, n
    pairs are worth n (1 - r1 r2) / (1 + r1 r2) (Bretherton et al. 1999).

    >>> r, low, high, pairs = correlation(np.arange(10.0) % 2, -(np.arange(10.0) % 2))
    >>> round(r, 6)
    -1.0
    """
    if len(x) < 4 or x.std() == 0 or y.std() == 0:
        return (math.nan, math.nan, math.nan, 0.0)
    r = float(np.corrcoef(x, y)[0, 1])
    memory = _neighbours(x) * _neighbours(y)
    pairs = min(float(len(x)), len(x) * (1 - memory) / (1 + memory)) if memory < 1 else 0.0
    if pairs <= 4:
        return (r, -1.0, 1.0, pairs)
    middle = math.atanh(max(-1 + 1e-15, min(1 - 1e-15, r)))
    reach = stats.norm.ppf(0.975) / math.sqrt(pairs - 3)
    return (r, math.tanh(middle - reach), math.tanh(middle + reach), pairs)


def _neighbours(x: NDArray[np.float64]) -> float:
    centred = x - x.mean()
    return float(centred[1:] @ centred[:-1] / (centred @ centred))


def _turned(points: NDArray[np.float64], q: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points turned by a unit quaternion (w, x, y, z)."""
    w, v = q[0], q[1:]
    across = 2 * np.cross(v, points)
    return points + w * across + np.cross(v, across)


def _cover(frame: Frame, shapes: dict[int, Shape], lengths: float, run: Run) -> float:
    """Covered share of the window ahead at one frame."""
    place = next((k for k, body in enumerate(frame.bodies) if body.kind == "vessel"), None)
    if place is None:
        raise NoRun(f"{run.folder}: this run has no vessel.")
    hull = shapes[frame.bodies[place].shape].points
    low, high = hull.min(axis=0), hull.max(axis=0)
    length, width = lengths * (high[0] - low[0]), high[1] - low[1]
    middle = 0.5 * (high[1] + low[1])
    forward = _turned(np.array([[1.0, 0.0, 0.0]]), frame.orientation[place])[0, :2]
    ahead = forward / np.hypot(*forward)
    foremost = _turned(np.array([[high[0], middle, 0.0]]), frame.orientation[place])[0]
    bow = frame.position[place] + foremost
    axes = np.array([ahead, [-ahead[1], ahead[0]]])
    covered = 0.0
    for k, body in enumerate(frame.bodies):
        if body.kind != "floe":
            continue
        shape = shapes[body.shape]
        points = _turned(shape.points, frame.orientation[k]) + frame.position[k]
        plan = (points[:, :2] - bow[:2]) @ axes.T
        near, far = plan.min(axis=0), plan.max(axis=0)
        if far[0] < 0 or near[0] > length or near[1] > width or far[1] < -width:
            continue
        covered += sum(
            clipped_area(plan[polygon], length, width)
            for polygon in shape.polygons
            if _faces_up(points[polygon])
        )
    return float(covered / (length * width))


def _faces_up(corners: NDArray[np.float64]) -> bool:
    """Whether a polygon is seen from above: its area in plan counts counter-clockwise."""
    x, y = corners[:, 0] - corners[0, 0], corners[:, 1] - corners[0, 1]
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) > 0


def _hull_length(run: Run) -> float:
    replay = run.replay
    body = next((one for one in replay.bodies().values() if one.kind == "vessel"), None)
    if body is None:
        raise NoRun(f"{run.folder}: this run has no vessel.")
    points = replay.shapes[body.shape].points
    return float(points[:, 0].max() - points[:, 0].min())


def _speed(run: Run, begin: float, end: float) -> float:
    """Mean speed of the vessel over ground [m/s]."""
    place = run.table("vessel", columns=["x_m", "y_m"], between=(begin, end))
    way = np.hypot(*np.diff(place.to_numpy(), axis=0).T).sum()
    speed = float(way / (place.index[-1] - place.index[0]))
    if not speed > 0:
        raise InputError("The vessel does not move, so it does not pass the ice ahead.")
    return speed
