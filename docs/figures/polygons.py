"""Plane polygons, as arrays of corners in counter-clockwise order."""
import numpy as np


def clip(points, normal, offset):
    """The part of a convex polygon where normal . x <= offset."""
    kept = []
    for a, b in zip(points, np.roll(points, -1, axis=0)):
        da, db = np.dot(normal, a) - offset, np.dot(normal, b) - offset
        if da <= 0:
            kept.append(a)
        if da * db < 0:
            kept.append(a + da / (da - db) * (b - a))
    return np.array(kept)


def moments(points):
    """Area, centroid, and the second moments about it as a 2 x 2 matrix of the integrals of x x, x y, y y."""
    x, y = points.T
    x1, y1 = np.roll(points, -1, axis=0).T
    cross = x * y1 - x1 * y
    area = cross.sum() / 2
    c = np.array([((x + x1) * cross).sum(), ((y + y1) * cross).sum()]) / (6 * area)
    x, y, x1, y1 = x - c[0], y - c[1], x1 - c[0], y1 - c[1]
    cross = x * y1 - x1 * y
    xx = ((x * x + x * x1 + x1 * x1) * cross).sum() / 12
    yy = ((y * y + y * y1 + y1 * y1) * cross).sum() / 12
    xy = ((x * y1 + 2 * x * y + 2 * x1 * y1 + x1 * y) * cross).sum() / 24
    return area, c, np.array([[xx, xy], [xy, yy]])
