"""A floe that tilts in water: wetted faces, buoyancy, weight, form and skin drag: docs/theory/water.md."""
import numpy as np

from polygons import clip, moments
from style import *


def draw():
    fig = figure(3.55)
    ax = canvas(fig, [0.0, 0.0, 1.0, 1.0], (-4.6, 4.75), (-2.35, 2.3))
    ax.add_patch(Rectangle((-4.6, -2.35), 9.35, 2.35, facecolor=WATER, edgecolor="none", alpha=0.5))
    ax.plot([-4.6, 4.75], [0, 0], color=WATER_LINE, linewidth=1.2)
    label(ax, (-4.5, 0.18), "free surface, z = level", WATER_LINE, ha="left", size=SMALL)

    tilt, com = np.radians(-14), np.array([0.1, -0.12])
    turned = np.array([[np.cos(tilt), -np.sin(tilt)], [np.sin(tilt), np.cos(tilt)]])
    corners = np.array([(-2.4, -0.62), (2.4, -0.62), (2.4, 0.62), (-2.4, 0.62)]) @ turned.T + com
    shape(ax, corners, ICE, ICE_EDGE, 1.2)
    wet = clip(corners, np.array([0.0, 1.0]), 0.0)
    shape(ax, wet, SKY, "none", alpha=0.35)
    flow = np.array([-1.0, 0.0])  # water past the floe: v_r
    for a, b in zip(wet, np.roll(wet, -1, axis=0)):
        if abs(a[1]) < 1e-9 and abs(b[1]) < 1e-9:
            continue  # the cut itself is no face
        e = (b - a) / np.linalg.norm(b - a)
        n = np.array([e[1], -e[0]])
        middle = (a + b) / 2
        ax.plot(*zip(a, b), color=BLUE, linewidth=3.2, solid_capstyle="butt", zorder=4)
        v_n = flow @ n
        v_t = flow - v_n * n
        if v_n < 0:
            if v_n < -0.5:  # F = -1/2 rho C_f A v_n^2 n, so against the normal
                arrow(ax, middle + 1.35 * n, middle + 0.06 * n, FORCE, 2.4, 13, zorder=6)
        if np.linalg.norm(v_t) > 0.5 and np.linalg.norm(b - a) > 1:
            off = middle + 0.13 * n
            along = v_t / np.linalg.norm(v_t)
            arrow(ax, off - 0.55 * along, off + 0.55 * along, PURPLE, 2.2, 12, zorder=6)
    label(ax, (4.65, -1.45), "form drag, where the flow meets\na face ($v_n < 0$), along its normal", FORCE, ha="right",
          size=SMALL, va="top")
    label(ax, (-0.1, -1.2), "skin drag, along\nevery wet face", "#9B4F7D", ha="right", size=SMALL, va="top")
    for y in (-0.35, -0.8, -1.25):
        arrow(ax, (4.6, y), (3.9, y), MOTION, 1.5, 9)
    label(ax, (4.65, 0.2), "$v_r$: water past the face", MOTION, ha="right", size=SMALL)

    buoyancy = moments(wet)[1]
    point(ax, com, INK, 5.5)
    point(ax, buoyancy, BLUE, 5.5)
    arrow(ax, com, com + (0, -1.75), INK, 2.2, 13, zorder=6)
    arrow(ax, buoyancy, buoyancy + (0, 1.95), BLUE, 2.2, 13, zorder=6)
    label(ax, com + (0.12, -1.7), "m g", INK, ha="left", size=SMALL)
    label(ax, buoyancy + (0.14, 1.85), "$\\rho g V$ at $c_B$, the centre of the wet volume", BLUE, ha="left", size=SMALL)
    note(ax, (-1.2, 1.75), com, "centre of mass")
    note(ax, (-3.3, -1.6), corners[0] + 0.25 * (corners[1] - corners[0]),
         "wetted faces, cut exactly\nat the free surface", BLUE)
    return fig
