"""Coulomb's cone and the pyramids in its place: docs/theory/contact.md, "Laws that are built"."""
import numpy as np

from style import *

SQUARE = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)])
OCTAGON = np.array([(np.cos(a), np.sin(a)) for a in np.arange(8) * np.pi / 4])  # a corner on t1
OCT_COLOUR = GREEN


def solid(fig):
    ax = canvas(fig, [0.0, 0.0, 0.345, 1.0], (-1.75, 1.75), (-0.3, 3.15))
    height = 1.9
    seen = lambda x, y, z: np.array([x - 0.42 * y, 0.92 * z + 0.13 * x + 0.30 * y])
    tip = seen(0, 0, 0)
    top = np.array([seen(x, y, height) for x, y in SQUARE])
    # pyramid: its far faces, the cone within, its near edges
    for k in range(4):
        shape(ax, [tip, top[k], top[(k + 1) % 4]], RED, "none", alpha=0.10)
    shape(ax, top, RED, RED, 1.4, alpha=0.16)
    t = np.linspace(0, 2 * np.pi, 400)
    rim = np.array([seen(np.cos(a), np.sin(a), height) for a in t])
    angles = np.arctan2(rim[:, 0] - tip[0], rim[:, 1] - tip[1])
    sides = rim[angles.argmin()], rim[angles.argmax()]
    from scipy.spatial import ConvexHull
    body = np.vstack([rim, [tip]])
    shape(ax, body[ConvexHull(body).vertices], SKY, "none", alpha=0.45)
    shape(ax, rim, SKY, BLUE, 1.6, alpha=0.55)
    for side in sides:
        ax.plot(*zip(tip, side), color=BLUE, linewidth=1.6)
    ax.plot(*np.vstack([top, top[:1]]).T, color=RED, linewidth=1.6)
    ax.plot(*zip(tip, top[0]), color=RED, linewidth=1.1, linestyle=(0, (3, 2)))  # behind the cone
    for corner in top[1:]:
        ax.plot(*zip(tip, corner), color=RED, linewidth=1.6)
    arrow(ax, tip, seen(0, 0, 2.75), INK, 1.4, zorder=6)
    label(ax, seen(0, 0, 2.75) + (0.13, 0.05), "$r_N$", ha="left")
    for end, name, off in (((1.75, 0, 0), "$r_{T1}$", (0.02, -0.2)), ((0, 1.75, 0), "$r_{T2}$", (-0.12, 0.2))):
        arrow(ax, tip, seen(*end), INK, 1.2, 10, zorder=1)
        label(ax, seen(*end) + off, name)
    label(ax, (1.02, 0.55), "cone", BLUE, ha="left")
    ax.plot([1.0, 0.5], [0.58, 0.98], color=GREY, linewidth=0.8)
    label(ax, (-1.72, 0.52), "pyramid", RED, ha="left")
    ax.plot([-1.1, -0.78], [0.66, 1.02], color=GREY, linewidth=0.8)


def above(fig):
    ax = canvas(fig, [0.345, 0.0, 0.315, 1.0], (-1.62, 1.62), (-1.72, 1.62))
    shape(ax, SQUARE, RED, RED, 1.8, alpha=0.12)
    ax.plot(*np.vstack([SQUARE, SQUARE[:1]]).T, color=RED, linewidth=1.8)
    t = np.linspace(0, 2 * np.pi, 300)
    shape(ax, np.array([np.cos(t), np.sin(t)]).T, SKY, BLUE, 1.8, alpha=0.35)
    ax.plot(np.cos(t), np.sin(t), color=BLUE, linewidth=1.8)
    ax.plot(*np.vstack([OCTAGON, OCTAGON[:1]]).T, color=OCT_COLOUR, linewidth=1.4, linestyle=(0, (4, 2)))
    for end, name, off in (((1.5, 0), "$r_{T1}$", (0.03, -0.2)), ((0, 1.4), "$r_{T2}$", (0.25, 0.05))):
        arrow(ax, (0, 0), end, INK, 1.1, 9)
        label(ax, np.add(end, off), name)
    arrow(ax, (0, 0), (1, 1), RED, 1.8, 11, zorder=4)
    label(ax, (1.06, 1.17), r"$\sqrt{2}\,\mu r_N$", RED, halo=True)
    a = np.radians(205)
    arrow(ax, (0, 0), (np.cos(a), np.sin(a)), BLUE, 1.8, 11, zorder=4)
    label(ax, (-0.62, -0.06), r"$\mu r_N$", BLUE, halo=True)
    label(ax, (0, -1.22), "pyramid: both clamps full", RED, size=SMALL)
    label(ax, (0, -1.42), "coulomb: circle of radius $\\mu r_N$", BLUE, size=SMALL)
    label(ax, (0, -1.62), "pyramid-8: corners on the circle", OCT_COLOUR, size=SMALL)


def errors(fig):
    ax = fig.add_axes([0.745, 0.21, 0.238, 0.75])
    phi = np.linspace(0, 90, 721)
    a = np.radians(phi)
    ax.plot(phi, np.cos(a) + np.sin(a), color=RED)
    ax.plot(phi, np.ones_like(phi), color=BLUE)
    off = np.abs((phi + 22.5) % 45 - 22.5)
    ax.plot(phi, np.cos(np.radians(off)), color=OCT_COLOUR, linestyle=(0, (4, 2)))
    ax.axhline(np.sqrt(2), color=GREY, linewidth=0.8, linestyle=(0, (2, 3)), zorder=0)
    ax.set_xlim(0, 90)
    ax.set_ylim(0.85, 1.5)
    ax.set_xticks([0, 45, 90])
    ax.set_yticks([0.9, 1.0, 1.1, 1.2, 1.3, np.sqrt(2)])
    ax.set_yticklabels(["0.9", "1", "1.1", "1.2", "1.3", r"$\sqrt{2}$"])
    ax.set_xlabel("slip from t1 [deg]")
    ax.set_ylabel(r"friction against the slip / $\mu r_N$")
    ax.text(45, 1.33, "pyramid", color=RED, fontsize=SMALL, ha="center")
    ax.text(45, 1.025, "coulomb", color=BLUE, fontsize=SMALL, ha="center")
    ax.text(45, 0.885, "pyramid-8", color=OCT_COLOUR, fontsize=SMALL, ha="center")


def draw():
    fig = figure(2.55)
    solid(fig)
    above(fig)
    errors(fig)
    return fig
