"""A face of an indenter in the ice: contact area, the points that carry the pressure, and the pressure's law:
docs/theory/fracture-crushing.md."""
import numpy as np

from polygons import clip, moments
from style import *


def side(fig):
    ax = canvas(fig, [0.0, 0.47, 0.56, 0.53], (-2.2, 3.6), (-1.75, 1.95))
    flare, tall = np.radians(35), 1.2  # from the upright; thickness T
    ax.add_patch(Rectangle((-2.2, -1.75), 5.8, 2.25, facecolor=WATER, edgecolor="none", alpha=0.45))
    low = -tall / 2
    ice = np.array([(0.0, low), (3.6, low), (3.6, -low), (0.0, -low)])
    shape(ax, ice)
    # the face passes through (0.75, top) and leans: outwards with height
    tan = np.tan(flare)
    foot = (0.95 - tan * (0.6 + 1.45), -1.45)
    head = (0.95 + tan * (1.9 - 0.6), 1.9)
    hull = np.array([(-2.2, -1.45), foot, head, (-2.2, 1.9)])
    out = np.array([np.cos(flare), -np.sin(flare)])  # normal of the face, into the ice
    inside = clip(ice, out, np.dot(out, foot))
    shape(ax, hull, HULL, HULL_EDGE, alpha=0.8)
    shape(ax, inside, ORANGE, ORANGE, 1.0, alpha=0.35)
    on = lambda z: np.array([foot[0] + tan * (z + 1.45), z])
    bottom_z = max(low, -1.45 + (0 - foot[0]) / tan)
    ends = on(max(bottom_z, low)), on(0.6)
    ax.plot(*zip(*ends), color=RED, linewidth=4, solid_capstyle="butt", zorder=5)
    mid = (ends[0] + ends[1]) / 2
    for share in np.linspace(0.06, 0.94, 6):
        at = ends[0] + share * (ends[1] - ends[0])
        arrow(ax, at + 0.42 * out, at + 0.03 * out, RED, 1.2, 8, zorder=6)
    arrow(ax, mid, mid - 1.35 * out, FORCE, 2.6, 14, zorder=6)
    label(ax, (-2.05, 0.52), "$F_n = p\\,A_f$\non the hull", FORCE, ha="left", size=SMALL)
    label(ax, (-1.55, -0.75), "indenter", HULL_EDGE)
    label(ax, (2.9, 0.0), "ice", ICE_EDGE)
    note(ax, (0.15, -1.2), (0.3, 0.1), "crushed: ice that the\nindenter has reached", ha="left", va="top")
    dimension(ax, (3.35, low), (3.35, -low), "T", (0.0, 0), halo=True)
    # flare
    top = on(1.05)
    ax.plot([top[0], top[0]], [top[1], top[1] + 0.75], color=GREY, linewidth=0.9, dashes=(4, 3))
    turn(ax, top, 0.62, 90, 90 - np.degrees(flare), GREY, 0.9, 7)
    label(ax, (top[0] - 0.1, top[1] + 0.55), "flare g", INK, ha="right", size=SMALL)
    arrow(ax, (-2.0, 1.2), (-1.0, 1.2), MOTION, 2.0, 12)
    label(ax, (-2.0, 1.5), "$-u_N > 0$: closing", MOTION, ha="left", size=SMALL)
    label(ax, (1.75, 0.82), "face, uniform\npressure p", RED, ha="left", va="bottom", size=SMALL)


def face(fig):
    ax = canvas(fig, [0.57, 0.47, 0.43, 0.53], (-2.3, 2.35), (-1.75, 1.95))
    # the face's own polygon, and what of it lies in the ice: between lower and upper cap, and inside the edge
    whole = np.array([(-2.2, -1.2), (1.7, -1.6), (2.2, 1.75), (-1.9, 1.6)])
    wet = np.array([(-1.55, -0.55), (0.2, -0.85), (1.55, -0.15), (1.62, 0.85), (-1.5, 0.85)])
    shape(ax, whole, "#EDEBE6", HULL_EDGE)
    shape(ax, wet, ORANGE, RED, 1.6, alpha=0.35)
    ax.plot(*np.vstack([wet, wet[:1]]).T, color=RED, linewidth=1.6)
    area, c, second = moments(wet)
    principal, vectors = np.linalg.eigh(second)
    point(ax, c, INK, 4)
    label(ax, c + (0.0, -0.2), "c", INK, size=SMALL)
    for moment, e in zip(principal, vectors.T):
        reach = np.sqrt(2 * moment / area)
        ax.plot(*zip(c - 1.25 * reach * e, c + 1.25 * reach * e), color=GREY, linewidth=0.9, dashes=(4, 3))
        for sign in (-1, 1):
            point(ax, c + sign * reach * e, RED, 7, zorder=6)
    label(ax, (0.0, 1.27), "the indenter's face,\nseen along its normal", HULL_EDGE, size=SMALL)
    label(ax, (-1.45, 0.63), "$A_f$", RED, ha="left")
    label(ax, (0.0, -1.17), "four points  $c \\pm \\sqrt{2 I_k/A_f}\\;e_k$", RED, size=SMALL)


def laws(fig):
    ax = fig.add_axes([0.09, 0.095, 0.36, 0.305])
    ax.plot([-1, 0], [1, 1], color=RED, linewidth=2.4)
    ax.plot([0, 0], [0, 1], color=RED, linewidth=2.4)
    ax.plot([0, 0.6], [0, 0], color=RED, linewidth=2.4)
    ax.set_xlim(-1, 0.65)
    ax.set_ylim(0, 1.3)
    ax.set_xticks([0])
    ax.set_yticks([0, 1])
    ax.set_yticklabels(["0", "$p A_f$"])
    ax.set_xlabel("$u_N$, rate of separation")
    ax.set_ylabel("$F_n$")
    ax.text(-0.95, 1.1, "closes: the ice yields", fontsize=SMALL, color=RED)
    ax.text(-0.05, 0.45, "rests: as much\nas it must bear", fontsize=SMALL, color=INK, ha="right", va="center")
    ax.text(0.3, 0.1, "parts: none", fontsize=SMALL, color=INK, ha="center")

    ax = fig.add_axes([0.6, 0.095, 0.385, 0.305])
    area = np.logspace(-2, 1, 200)
    ax.loglog(area, np.ones_like(area), color=BLUE)
    ax.loglog(area, area ** -0.1, color=GREEN)
    ax.loglog(area, area ** -0.7, color=RED)
    ax.set_xlim(1e-2, 10)
    ax.set_ylim(0.1, 40)
    ax.set_xticks([0.01, 0.1, 1, 10])
    ax.set_xticklabels(["0.01", "0.1", "1", "10"])
    ax.set_yticks([0.1, 1, 10])
    ax.set_yticklabels(["0.1", "1", "10"])
    ax.minorticks_off()
    ax.set_xlabel("A, sum of the faces that press [m$^2$]")
    ax.set_ylabel("p over its value at 1 m$^2$")
    ax.text(0.035, 17, "$C A^{-0.7}$", color=RED, fontsize=SMALL)
    ax.text(0.0125, 1.95, "$C A^{-0.1}$", color="#00795A", fontsize=SMALL)
    ax.text(0.0125, 0.53, "$\\sigma_c$: strength alone", color=BLUE, fontsize=SMALL)


def draw():
    fig = figure(4.9)
    side(fig)
    face(fig)
    laws(fig)
    return fig
