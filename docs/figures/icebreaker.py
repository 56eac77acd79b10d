"""Lines of the shipped hull, apps/scenes/hulls/icebreaker, in its own frame V: x forward, y to port, z up [m]."""
import pathlib
import struct

import numpy as np
from scipy.spatial import ConvexHull

FILE = pathlib.Path(__file__).resolve().parents[2] / "apps/scenes/hulls/icebreaker/fluid.stl"
LENGTH, BEAM, DEPTH, DRAUGHT = 6.0, 1.2, 0.6, 0.35


def triangles(file=FILE):
    """Corners of a binary STL file: count x 3 x 3."""
    data = pathlib.Path(file).read_bytes()
    count = struct.unpack("<I", data[80:84])[0]
    row = np.dtype([("normal", "<3f4"), ("corners", "<(3,3)f4"), ("spare", "<u2")])
    return np.frombuffer(data, dtype=row, offset=84, count=count)["corners"].astype(float)


def _outline(points):
    return points[ConvexHull(points).vertices]


def section(axis, at):
    """Where the plane `axis` = `at` cuts the hull: the outline over the other two axes. The hull is convex."""
    points = []
    for corners in triangles():
        height = corners[:, axis] - at
        for i, j in ((0, 1), (1, 2), (2, 0)):
            if height[i] * height[j] < 0:
                share = height[i] / (height[i] - height[j])
                points.append(corners[i] + share * (corners[j] - corners[i]))
            elif height[i] == 0:
                points.append(corners[i])
    return _outline(np.delete(np.array(points), axis, axis=1))


def waterline(draught=DRAUGHT):
    return section(2, draught)


def plan():
    """The whole hull seen from above."""
    return _outline(triangles().reshape(-1, 3)[:, :2])


def profile():
    """The hull seen from starboard: x, z."""
    return _outline(triangles().reshape(-1, 3)[:, [0, 2]])


def below(outline, level):
    """The part of a convex outline below the height `level` of its second coordinate."""
    kept = []
    for a, b in zip(outline, np.roll(outline, -1, axis=0)):
        if a[1] <= level:
            kept.append(a)
        if (a[1] - level) * (b[1] - level) < 0:
            kept.append(a + (level - a[1]) / (b[1] - a[1]) * (b - a))
    return np.array(kept)
