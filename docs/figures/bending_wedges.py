"""An ice edge that breaks in wedges: plan, section with the deflection of Nevel's wedge, and its bending stress:
docs/theory/fracture.md and fracture-breaking.md."""
import numpy as np

import icebreaker
from polygons import clip
from style import *

LOADED = 0.1  # a / l, a pressure
WEDGES = 4  # half a turn in angles of 45 degrees


def nevel(a):
    """(x w'')'' + x w = q with a free tip by Hermite elements, q a pressure over 0 < x < a of sum 1: the nodes and w there, the
    elements' middles and w'' there."""
    nodes = np.concatenate([np.linspace(0, a, 25), np.linspace(a, 4, 220)[1:], np.linspace(4, 20, 120)[1:]])
    gauss, weights = np.polynomial.legendre.leggauss(6)
    size = 2 * len(nodes)
    K, f = np.zeros((size, size)), np.zeros(size)
    for e, (x0, x1) in enumerate(zip(nodes, nodes[1:])):
        L, at = x1 - x0, slice(2 * e, 2 * e + 4)
        for g, weight in zip(gauss, weights):
            s = (g + 1) / 2
            x, dx = x0 + s * L, weight * L / 2
            N = np.array([1 - 3 * s**2 + 2 * s**3, L * (s - 2 * s**2 + s**3), 3 * s**2 - 2 * s**3, L * (s**3 - s**2)])
            B = np.array([12 * s - 6, L * (6 * s - 4), 6 - 12 * s, L * (6 * s - 2)]) / L**2
            K[at, at] += dx * x * (np.outer(B, B) + np.outer(N, N))
            if x < a:
                f[at] += dx * N * 2 * x / a**2
    w = np.linalg.solve(K[:-2, :-2], f[:-2])
    deflection = np.append(w[0::2], 0)
    slope = np.append(w[1::2], 0)
    middle = (nodes[1:] + nodes[:-1]) / 2
    curvature = np.diff(slope) / np.diff(nodes)
    return nodes, deflection, middle, curvature


def plan(fig):
    ax = canvas(fig, [0.0, 0.0, 0.43, 1.0], (-1.5, 2.05), (-2.3, 2.3))
    ax.add_patch(Rectangle((-1.5, -2.3), 1.5, 4.6, facecolor=WATER, edgecolor="none", alpha=0.5))
    ax.add_patch(Rectangle((0, -2.3), 2.05, 4.6, facecolor=ICE, edgecolor="none"))
    ax.plot([0, 0], [-2.3, 2.3], color=ICE_EDGE, linewidth=1.2)
    R = 1.15
    angles = np.radians(np.linspace(-90, 90, WEDGES + 1))
    rim = R * np.array([np.cos(angles), np.sin(angles)]).T
    for k in range(WEDGES):
        shape(ax, [(0, 0), rim[k], rim[k + 1]], YELLOW, "none", alpha=0.35)
    bow = icebreaker.plan() * 0.55
    bow -= (bow[:, 0].max() - 0.16, 0)
    shape(ax, clip(bow, np.array([-1.0, 0]), 1.5), HULL, HULL_EDGE, alpha=0.9)
    for k in range(1, WEDGES):
        ax.plot([0, rim[k][0]], [0, rim[k][1]], color=RED, linewidth=1.8)
    ax.plot(*rim.T, color=BLUE, linewidth=2.0)
    # pressed ice: 2 b along the edge, a into it
    b, a = 0.17, 0.2
    ax.add_patch(Rectangle((0, -b), a, 2 * b, facecolor=ORANGE, edgecolor=ORANGE, alpha=0.8, zorder=4))
    note(ax, (-1.45, -1.1), (0.06, -0.12), "load: 2 b along\nthe edge, a deep", "#8A6100", ha="left")
    label(ax, (-0.85, -0.02), "hull", HULL_EDGE)
    note(ax, (0.95, -1.75), (0.5, -0.5), "1  radial cracks", RED)
    note(ax, (1.03, 2.0), (0.62, 0.93), "2  circumferential crack", BLUE)
    dimension(ax, (-0.24, 0), (-0.24, R), "")
    ax.plot([-0.3, 0], [R, R], color=GREY, linewidth=0.7)
    label(ax, (-0.34, 0.68), "$R_{bending}$", INK, ha="right", size=SMALL)
    turn(ax, (0, 0), 0.72, -45, 0, GREY, 1.0, 7)
    label(ax, (0.97, -0.3), "wedge\nangle", INK, size=SMALL, halo=True)
    label(ax, (-1.45, -2.15), "seen from above", GREY, ha="left", size=SMALL)


def section(fig, x, w, x_max):
    ax = canvas(fig, [0.44, 0.47, 0.56, 0.53], (-0.72, 2.6), (-0.92, 1.02))
    ax.add_patch(Rectangle((-0.72, -0.92), 3.32, 0.87, facecolor=WATER, edgecolor="none", alpha=0.5))
    ax.plot([-0.72, 2.6], [-0.05, -0.05], color=WATER_LINE, linewidth=1.0, dashes=(5, 3))
    h = 0.15
    keep = x <= 2.6
    sag = -0.2 * w[keep]
    top, low = sag, sag - h
    outline = np.concatenate([np.array([x[keep], top]).T, np.array([x[keep], low]).T[::-1]])
    shape(ax, outline, ICE, ICE_EDGE)
    crack = np.interp(x_max, x, -0.2 * w)
    ax.plot([x_max, x_max - 0.015, x_max + 0.012, x_max], [crack, crack - 0.05, crack - 0.1, crack - h], color=BLUE,
            linewidth=2.2)
    # hull with a flared side
    tip = -0.2 * w[0]
    tan = 0.75
    at = lambda z: 0.04 + tan * (z - tip)
    shape(ax, [(-0.72, -0.88), (at(-0.88), -0.88), (at(0.42), 0.42), (-0.72, 0.42)], HULL, HULL_EDGE, zorder=3)
    label(ax, (-0.5, 0.1), "hull", HULL_EDGE, zorder=4)
    arrow(ax, (0.07, tip + 0.62), (0.07, tip + 0.05), FORCE, 2.4, 13, zorder=6)
    label(ax, (-0.05, tip + 0.5), "P", FORCE, ha="right", zorder=6)
    for place in np.linspace(0.25, 1.9, 8):
        lift = np.interp(place, x, w)
        base = -0.2 * lift - h
        arrow(ax, (place, base - 0.05 - 0.17 * lift), (place, base - 0.01), WATER_LINE, 1.2, 7)
    label(ax, (1.3, -0.72), "water: $\\rho_w g\\,w$ per area", WATER_LINE, ha="left", size=SMALL)
    z = 0.58
    ax.plot([0, 0], [tip + 0.02, 0.91], color=GREY, linewidth=0.7, zorder=6)
    ax.plot([x_max, x_max], [crack + 0.02, z + 0.06], color=GREY, linewidth=0.7)
    dimension(ax, (0.0, z), (x_max, z), "", zorder=7)
    label(ax, (x_max + 0.08, z), "$R_{bending} = x_{max}$", INK, ha="left", size=SMALL, halo=True)
    dimension(ax, (0.0, 0.85), (1.0, 0.85), "", zorder=7)
    label(ax, (1.08, 0.85), "$\\ell = (E h^3 / 12\\,\\rho_w g)^{1/4}$", INK, ha="left", size=SMALL)
    ax.plot([1, 1], [-0.1, 0.91], color=GREY, linewidth=0.7, linestyle=(0, (2, 2)))
    dimension(ax, (2.48, -0.04), (2.48, -0.19), "", zorder=7)
    label(ax, (2.38, -0.11), "h", size=SMALL)


def stress(fig, middle, curvature, x_max):
    ax = fig.add_axes([0.5, 0.135, 0.47, 0.31])
    top = curvature.max()
    ax.plot(middle, curvature / top, color=BLUE)
    ax.plot([x_max, x_max], [0, 1], color=GREY, linewidth=0.8, linestyle=(0, (2, 2)))
    ax.plot([x_max], [1], "o", color=BLUE, markersize=5)
    ax.axhline(0, color=GREY, linewidth=0.8)
    ax.set_xlim(-0.28, 2.6)
    ax.set_ylim(-0.15, 1.25)
    ax.set_xticks([0, x_max, 1, 2])
    ax.set_xticklabels(["0", f"{x_max:.2f}", "1", "2"])
    ax.set_yticks([0, 1])
    ax.set_xlabel("distance from the tip / $\\ell$")
    ax.set_ylabel("bending stress\n/ largest")
    ax.text(1.25, 0.93, f"wedge under a pressure\nover a = {LOADED} $\\ell$", fontsize=SMALL)


def draw():
    x, w, middle, curvature = nevel(LOADED)
    best = curvature.argmax()
    # a parabola through the three largest finds the place between the elements' middles
    p = np.polyfit(middle[best - 1:best + 2], curvature[best - 1:best + 2], 2)
    x_max = -p[1] / (2 * p[0])
    assert abs(x_max - 0.5115) < 2e-3 and abs(w[0] - 2.0673) < 2e-3  # the table of docs/theory/fracture.md
    fig = figure(3.85)
    plan(fig)
    section(fig, x, w, x_max)
    stress(fig, middle, curvature, x_max)
    return fig
