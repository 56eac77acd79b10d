"""Polygons of a surface as triangles, and the mass properties of what the surface encloses."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

_Point = tuple[float, float]


class Solid(NamedTuple):
    """Of a closed surface: volume [m^3], centre, and inertia about the centre for density 1.

    ``centre``: shape (3,) [m]. ``inertia``: shape (3, 3) [m^5].

    >>> Solid(2.0, np.zeros(3), np.eye(3)).inertia.shape
    (3, 3)
    """

    volume: float
    centre: NDArray[np.float64]
    inertia: NDArray[np.float64]


def triangles_of(points: NDArray[np.float64], polygons: Iterable[list[int]]) -> NDArray[np.int64]:
    """Corners of triangles that cover flat polygons, convex or not, in their sense of rotation.

    ``points``: shape (points, 3). Returns shape (triangles, 3).

    >>> square = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    >>> triangles_of(square, [[0, 1, 2, 3]]).tolist()
    [[0, 1, 2], [0, 2, 3]]
    """
    triangles: list[tuple[int, int, int]] = []
    for polygon in polygons:
        triangles += _cut(points, list(polygon))
    return np.array(triangles, dtype=np.int64).reshape(-1, 3)


def solid_of(points: NDArray[np.float64], triangles: NDArray[np.int64]) -> Solid:
    """Volume, centre and inertia of a closed surface of triangles, by sums over tetrahedra.

    >>> box = np.array([[x, y, z] for x in (0, 2.0) for y in (0, 1.0) for z in (0, 1.0)])
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> solid = solid_of(box, triangles_of(box, faces))
    >>> round(solid.volume, 12), [round(x, 12) for x in solid.centre.tolist()]
    (2.0, [1.0, 0.5, 0.5])
    """
    middle = points.mean(axis=0)  # near the solid, for the sake of rounding
    a, b, c = (points[triangles[:, k]] - middle for k in range(3))
    sixths = np.einsum("ij,ij->i", a, np.cross(b, c))
    volume = float(sixths.sum() / 6)
    total = a + b + c
    centre = (sixths[:, None] * total).sum(axis=0) / 24 / volume
    # The integral of x x^T over a tetrahedron with one corner at the origin.
    corners = sum(np.einsum("t,ti,tj->ij", sixths, x, x) for x in (a, b, c, total))
    second = corners / 120 - volume * np.outer(centre, centre)
    return Solid(volume, centre + middle, np.trace(second) * np.eye(3) - second)


def _cut(points: NDArray[np.float64], polygon: list[int]) -> list[tuple[int, int, int]]:
    """Triangles of one flat polygon: a fan where it is convex, else ears are cut off in turn."""
    flat = [] if len(polygon) == 3 else _flattened(points[polygon])
    count = len(polygon)
    if all(_turn(flat[k - 2], flat[k - 1], flat[k]) >= 0 for k in range(len(flat))):
        return [(polygon[0], polygon[k], polygon[k + 1]) for k in range(1, count - 1)]
    ring = list(range(count))
    triangles = []
    while len(ring) > 3:
        place = next((k for k in range(len(ring)) if _is_ear(flat, ring, k)), 0)
        before, at, after = ring[place - 1], ring[place], ring[(place + 1) % len(ring)]
        triangles.append((polygon[before], polygon[at], polygon[after]))
        del ring[place]
    triangles.append((polygon[ring[0]], polygon[ring[1]], polygon[ring[2]]))
    return triangles


def _flattened(corners: NDArray[np.float64]) -> list[_Point]:
    """Corners in the plane of the polygon, counter-clockwise."""
    normal = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    normal /= np.linalg.norm(normal) or 1.0
    first = np.cross(np.eye(3)[int(np.argmin(np.abs(normal)))], normal)
    first /= np.linalg.norm(first) or 1.0
    flat = corners @ np.stack([first, np.cross(normal, first)], axis=1)
    return [(float(x), float(y)) for x, y in flat]


def _is_ear(flat: list[_Point], ring: list[int], place: int) -> bool:
    """Whether a corner sticks out and the triangle with its neighbours holds no other corner."""
    corners = (ring[place - 1], ring[place], ring[(place + 1) % len(ring)])
    a, b, c = (flat[corner] for corner in corners)
    if _turn(a, b, c) <= 0:
        return False
    return not any(
        min(_turn(a, b, flat[other]), _turn(b, c, flat[other]), _turn(c, a, flat[other])) >= 0
        for other in ring
        if other not in corners
    )


def _turn(a: _Point, b: _Point, c: _Point) -> float:
    """Twice the area of a triangle, above 0 where it turns counter-clockwise."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
