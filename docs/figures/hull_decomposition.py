"""A hull with hollow bow and bulb as `nilas hull` cuts it into convex parts: data/hull-parts.json by take_data.py;
docs/theory/hull.md."""
import json
import pathlib

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_rgb
from scipy.spatial import ConvexHull

from style import *
from take_data import ship_with_bulb

FILE = pathlib.Path(__file__).resolve().parent / "data/hull-parts.json"
COLOURS = [SKY, ORANGE, GREEN, YELLOW, PURPLE, RED, BLUE, "#999999"]
EXTRA = {2: (0.3, 0, -0.5), 4: (0.75, 0, 0.1), 6: (0.75, 0, -0.25)}  # so that no part hides another [m]
LIGHT = np.array([0.35, -0.65, 0.75]) / np.linalg.norm([0.35, -0.65, 0.75])


def view(azimuth, elevation):
    """Right, up and towards the reader, as rows."""
    a, e = np.radians(azimuth), np.radians(elevation)
    towards = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.cross([0, 0, 1], towards)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(towards, right), towards])


def facets(points):
    """Outward triangles of a convex part, and its sharp edges with the normals on both sides."""
    hull = ConvexHull(points)
    corners, normals = points[hull.simplices], hull.equations[:, :3]
    edges = {}
    for k, simplex in enumerate(hull.simplices):
        for i, j in ((0, 1), (1, 2), (2, 0)):
            edges.setdefault(tuple(sorted((simplex[i], simplex[j]))), []).append(k)
    sharp = [(points[list(edge)], normals[sides[0]], normals[sides[1]]) for edge, sides in edges.items()
             if len(sides) == 2 and normals[sides[0]] @ normals[sides[1]] < np.cos(np.radians(24))]
    smooth = [(points[list(edge)], normals[sides[0]], normals[sides[1]]) for edge, sides in edges.items()
              if len(sides) == 2 and normals[sides[0]] @ normals[sides[1]] >= np.cos(np.radians(24))]
    return corners, normals, sharp, smooth


def paint(ax, parts, seen, offsets):
    order = sorted(range(len(parts)), key=lambda k: (parts[k].mean(axis=0) + offsets[k]) @ seen[2])
    for k in order:
        corners, normals, sharp, smooth = facets(parts[k])
        front = normals @ seen[2] > 1e-6
        flat = (corners[front] + offsets[k]) @ seen.T
        depth = flat[:, :, 2].mean(axis=1).argsort()
        base = np.array(to_rgb(COLOURS[k % len(COLOURS)]))
        shade = 0.62 + 0.38 * np.clip(normals[front] @ LIGHT, 0, 1)
        colours = np.clip(base * shade[:, None] + 0.08, 0, 1)
        ax.add_collection(PolyCollection(flat[depth][:, :, :2], facecolors=colours[depth], edgecolors=colours[depth],
                                         linewidths=0.4, zorder=2, rasterized=True))
        lines = [(edge + offsets[k]) @ seen.T for edge, m, n in sharp if m @ seen[2] > 0 or n @ seen[2] > 0]
        lines += [(edge + offsets[k]) @ seen.T for edge, m, n in smooth if (m @ seen[2] > 0) != (n @ seen[2] > 0)]
        ax.add_collection(LineCollection([line[:, :2] for line in lines], colors=INK, linewidths=0.7, zorder=2,
                                         capstyle="round", rasterized=True))


def paint_mesh(ax, triangles, seen):
    """A closed surface, from behind to front."""
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    front = normals @ seen[2] > 1e-6
    flat = triangles[front] @ seen.T
    depth = flat[:, :, 2].mean(axis=1).argsort()
    colours = np.array(to_rgb(HULL)) * (0.5 + 0.5 * np.clip(normals[front] @ LIGHT, 0, 1))[:, None]
    ax.add_collection(PolyCollection(flat[depth][:, :, :2], facecolors=colours[depth], edgecolors=HULL_EDGE,
                                     linewidths=0.12, rasterized=True))


def draw():
    kept = json.loads(FILE.read_text())
    parts = [np.array(part).reshape(-1, 3) * kept["unit_m"] for part in kept["parts"]]
    centre = np.vstack(parts).mean(axis=0)
    seen = view(-58, 27)
    fig = figure(4.6)
    ax = canvas(fig, [0.0, 0.60, 0.86, 0.40], (0, 1), (0, 1))
    paint_mesh(ax, ship_with_bulb(), seen)
    fit(ax, parts, seen, np.zeros((len(parts), 3)))
    offsets = np.array([(part.mean(axis=0) - centre) * (0.35, 2.1, 0) + (0, 0, 2.0 * (part[:, 2].mean() - 0.34))
                        for part in parts])
    for k, extra in EXTRA.items():
        offsets[k] += extra
    ax = canvas(fig, [0.02, 0.0, 0.98, 0.66], (0, 1), (0, 1))
    paint(ax, parts, seen, offsets)
    fit(ax, parts, seen, offsets)
    fig.text(0.985, 0.96, f"the mesh: {kept['mesh_triangles']} triangles,\nhollow and flared bow, bulb", fontsize=SMALL,
             va="top", ha="right")
    fig.text(0.02, 0.03, f"its {len(parts)} convex parts, drawn apart:\ntheir union is within {1000 * kept['deviation_m']:.0f}"
             " mm of the mesh,\nof a length of 6.4 m", fontsize=SMALL, va="bottom")
    return fig


def fit(ax, parts, seen, offsets):
    flat = np.vstack([(part + offset) @ seen.T for part, offset in zip(parts, offsets)])
    low, high = flat.min(axis=0), flat.max(axis=0)
    ax.set_xlim(low[0] - 0.1, high[0] + 0.1)
    ax.set_ylim(low[1] - 0.1, high[1] + 0.25)
