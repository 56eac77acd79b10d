"""A floe with weak seams, the crack that runs through it, and its pieces: docs/theory/fracture-cutting.md, and "Curved
cracks" of fracture-breaking.md, whose rule the crack follows here."""
import numpy as np
from scipy.spatial import Voronoi

from polygons import moments
from style import *

KAPPA = 0.5  # share of strength and toughness on a seam
FLOE = np.array([(0.3, 0.35), (2.2, 0.0), (4.1, 0.3), (4.9, 1.7), (4.3, 3.2), (2.4, 3.7), (0.6, 3.1), (0.0, 1.7)])
SITES = np.array([(0.75, 0.95), (2.0, 0.75), (3.4, 0.85), (0.7, 2.3), (1.75, 2.0), (2.9, 1.95), (4.25, 1.9), (1.55, 3.15),
                  (2.75, 3.0), (3.75, 2.95)])


def seams():
    """Edges between the cells of the sites, cut to the floe."""
    far = np.array([(-50, 0), (50, 0), (0, 50), (0, -50)])
    diagram = Voronoi(np.vstack([SITES, far]))
    found = []
    for (i, j), (a, b) in zip(diagram.ridge_points, diagram.ridge_vertices):
        if min(a, b) < 0 or max(i, j) >= len(SITES):
            continue
        cut = clip_segment(diagram.vertices[a], diagram.vertices[b])
        if cut is not None:
            found.append(cut)
    return found


def clip_segment(a, b):
    low, high = 0.0, 1.0
    for p, q in zip(FLOE, np.roll(FLOE, -1, axis=0)):
        n = np.array([q[1] - p[1], p[0] - q[0]])  # outwards
        da, db = n @ (a - p), n @ (b - p)
        if da > 0 and db > 0:
            return None
        if da > 0:
            low = max(low, da / (da - db))
        elif db > 0:
            high = min(high, da / (da - db))
    return None if low >= high else (a + low * (b - a), a + high * (b - a))


def hit(p, d, a, b):
    """Distance along d from p to the segment a b; nothing where it is missed."""
    e = b - a
    cross = d[0] * e[1] - d[1] * e[0]
    if abs(cross) < 1e-9:
        return None
    t = ((a - p)[0] * e[1] - (a - p)[1] * e[0]) / cross
    s = ((a - p)[0] * d[1] - (a - p)[1] * d[0]) / cross
    return t if t > 1e-6 and -1e-9 <= s <= 1 + 1e-9 else None


def turn_angle(load, direction):
    return np.arccos(np.clip(load @ direction, -1, 1))


def crack_path(start, load):
    """From seam to seam: ahead, or along a seam where cos^4(omega/2) / K_IC^2 is larger; omega from the load's direction
    [Cotterell, Rice 1980]."""
    lines = seams()
    edges = list(zip(FLOE, np.roll(FLOE, -1, axis=0)))
    path, at = [start], start
    for _ in range(40):
        ways = [(1.0, load, None)]
        for a, b in lines:
            for p, q in ((a, b), (b, a)):
                if np.linalg.norm(p - at) < 1e-6:
                    ways.append(way(load, q - at, q))
                elif on_line(at, a, b):
                    ways.append(way(load, q - at, q))
        best = max(ways, key=lambda item: item[0])
        if best[2] is not None:
            at = best[2]
        else:
            distances = [t for a, b in lines + edges if (t := hit(at, load, a, b)) is not None]
            at = at + min(distances) * load
        path.append(at)
        if any(on_line(at, a, b) or min(np.linalg.norm(at - a), np.linalg.norm(at - b)) < 1e-6 for a, b in edges):
            break
    return np.array(path)


def on_line(p, a, b):
    e = b - a
    s = (p - a) @ e / (e @ e)
    return 1e-9 < s < 1 - 1e-9 and abs((p - a)[0] * e[1] - (p - a)[1] * e[0]) < 1e-7


def way(load, along, end):
    length = np.linalg.norm(along)
    if length < 1e-9:
        return (0.0, load, None)
    omega = turn_angle(load, along / length)
    return (np.cos(omega / 2) ** 4 / KAPPA**2 if omega < np.pi / 2 else 0.0, along / length, end)


def walk(outline, path):
    """Both sides of a polyline that goes from edge to edge of a counter-clockwise outline."""
    places = []
    for p in (path[0], path[-1]):
        for k, (a, b) in enumerate(zip(outline, np.roll(outline, -1, axis=0))):
            e = b - a
            s = (p - a) @ e / (e @ e)
            if -1e-9 <= s <= 1 + 1e-9 and abs((p - a)[0] * e[1] - (p - a)[1] * e[0]) < 1e-6:
                places.append(k + s)
                break

    def corners(start, end):
        count = len(outline)
        if end <= start:
            end += count
        return [outline[k % count] for k in range(int(np.floor(start)) + 1, int(np.ceil(end)))]

    first = np.array(list(path) + corners(places[1], places[0]))
    second = np.array(list(path[::-1]) + corners(places[0], places[1]))
    return first, second


def draw():
    fig = figure(3.15)
    load_at, load = np.array([0.0, 1.7]), np.array([np.cos(np.radians(-4)), np.sin(np.radians(-4))])
    load_at = 0.55 * FLOE[7] + 0.45 * FLOE[0]
    path = crack_path(load_at, load)
    chord = np.array([0.42 * FLOE[4] + 0.58 * FLOE[3], 0.12 * FLOE[5] + 0.88 * FLOE[4]])  # cuts a corner off
    tongue = np.array([0.5 * (FLOE[5] + FLOE[6]), (1.2, 2.75)])  # ends in the ice

    ax = canvas(fig, [0.0, 0.0, 0.485, 1.0], (-1.05, 5.0), (-0.85, 4.45))
    shape(ax, FLOE)
    for a, b in seams():
        ax.plot(*zip(a, b), color=PURPLE, linewidth=1.3, linestyle=(0, (4, 2)))
    ax.plot(*path.T, color=RED, linewidth=2.4, solid_joinstyle="round")
    for p in path:
        point(ax, p, RED, 3.5)
    ax.plot(*chord.T, color=BLUE, linewidth=2.2)
    ax.plot(*tongue.T, color=GREY, linewidth=2.0, linestyle=(0, (1, 1)))
    arrow(ax, load_at - 0.95 * load, load_at - 0.05 * load, FORCE, 2.4, 13)
    label(ax, load_at - 0.5 * load + (0, 0.22), "load", FORCE)
    note(ax, (0.85, 4.15), tongue[0] + 0.4 * (tongue[1] - tongue[0]), "separates nothing: dropped")
    note(ax, (3.95, 4.15), chord.mean(axis=0), "a second crack", BLUE)
    note(ax, (2.55, -0.62), path[len(path) // 2], "crack: ahead through whole ice, or along a seam", RED)
    note(ax, (-0.35, 3.3), (0.86, 2.9), "weak seams", "#9B4F7D")

    ax = canvas(fig, [0.515, 0.0, 0.485, 1.0], (-0.55, 5.5), (-0.85, 4.45))
    first, second = walk(FLOE, path)
    upper, lower = sorted((first, second), key=lambda piece: -moments(piece)[1][1])
    one, two = walk(upper, chord)
    small, large = sorted((one, two), key=lambda piece: moments(piece)[0])
    centre = moments(FLOE)[1]
    velocity, spin = np.array([0.55, 0.0]), 0.28
    for piece, name, shift, colour in ((large, "1", (0.0, 0.22), ICE), (lower, "2", (0.0, -0.2), "#D5EBDF"),
                                       (small, "3", (0.35, 0.38), "#F6E3D0")):
        moved = piece + shift
        shape(ax, moved, colour, ICE_EDGE, 1.2)
        c = moments(piece)[1]
        c = c + shift
        if name != "3":
            point(ax, c, INK, 4)
            r = c - np.array(shift) - centre
            v = velocity + spin * np.array([-r[1], r[0]])
            arrow(ax, c, c + 1.5 * v, MOTION, 1.8, 11, zorder=6)
            label(ax, c + (-0.28, 0.02), name, INK, ha="right", size=12)
            label(ax, c + 1.5 * v + (0.1, 0.0), f"$v_{name}$", MOTION, ha="left", va="center")
    ax.plot(*centre, "+", color=GREY, markersize=9, markeredgewidth=1.4, zorder=5)
    label(ax, centre + (-0.15, 0.0), "centre of the floe", GREY, ha="right", size=SMALL)
    note(ax, (3.9, 4.15), moments(small)[1] + (0.35, 0.38), "below min_area: brash,\nor the cut is refused")
    label(ax, (2.5, -0.62), "$v_i = v + \\omega \\times r_i$,   $\\omega_i = \\omega$", MOTION)
    return fig
