"""Two floes about to touch: witness points, normal, gap, frame and impulse, and the law along the normal:
docs/theory/contact.md."""
import numpy as np

from style import *


def floes(fig):
    ax = canvas(fig, [0.0, 0.02, 0.66, 0.96], (-3.0, 3.15), (-2.4, 2.4))
    gap = 0.9
    a = np.array([(-2.9, -1.35), (-0.95, -1.95), (-gap / 2, 0.0), (-1.15, 1.55), (-2.75, 1.25)])
    b = np.array([(gap / 2, -2.05), (2.75, -1.7), (3.05, 0.6), (2.2, 1.75), (gap / 2, 1.85)])
    shape(ax, a)
    shape(ax, b)
    label(ax, (-2.1, -0.95), "A", ICE_EDGE, size=15)
    label(ax, (2.45, -1.15), "B", ICE_EDGE, size=15)
    label(ax, (-1.95, -1.32), "lower id", ICE_EDGE, size=SMALL)
    wa, wb, p = np.array([-gap / 2, 0]), np.array([gap / 2, 0]), np.zeros(2)
    for w in (wa, wb):
        point(ax, w, INK, 5.5)
    note(ax, (-0.35, 2.12), wa, "witness points: where\nthe surfaces are nearest")
    ax.plot([-0.28, wb[0]], [1.86, 0.0], color=GREY, linewidth=0.8)
    for x in (-gap / 2, gap / 2):
        ax.plot([x, x], [-0.1, -1.22], color=GREY, linewidth=0.7)
    dimension(ax, (-gap / 2, -1.12), (gap / 2, -1.12), "gap > 0", (0, -0.22), size=SMALL)
    # frame of the contact, at the middle of the gap
    arrow(ax, p, (1.85, 0), AXIS, 2.2, 13, zorder=6)
    label(ax, (1.2, 0.22), "n, from A to B", AXIS, ha="left")
    arrow(ax, p, (0, -0.85), AXIS, 2.2, 13, zorder=6)
    label(ax, (-0.1, -0.65), "t2", AXIS, ha="right", size=SMALL)
    label(ax, (0.06, 0.3), "p, t1 up", AXIS, size=SMALL, halo=True)
    # impulses, of one size, on one line through p
    arrow(ax, p, (1.5, -0.48), FORCE, 2.4, 13, zorder=7)
    label(ax, (1.58, -0.55), "C r on B", FORCE, ha="left")
    arrow(ax, p, (-1.5, 0.48), FORCE, 2.4, 13, zorder=7)
    label(ax, (-1.55, 0.68), "$-$C r on A", FORCE)
    out_of_page(ax, p, 0.12)
    label(ax, (-2.9, -2.22), "both act at p, midway between the surfaces", FORCE, ha="left", size=SMALL)


def normal_law(fig):
    ax = fig.add_axes([0.73, 0.155, 0.25, 0.73])
    ax.spines["left"].set_visible(False)
    ax.spines["bottom"].set_visible(False)
    ax.set_xticks([])
    ax.set_yticks([])
    ax.set_xlim(-0.75, 2.2)
    ax.set_ylim(-0.6, 2.2)
    arrow(ax, (-0.7, 0), (2.2, 0), GREY, 1.0, 9)
    arrow(ax, (0, -0.2), (0, 2.25), GREY, 1.0, 9)
    ax.plot([0, 0], [0, 2.05], color=RED, linewidth=3.2, solid_capstyle="butt")
    ax.plot([0, 2.0], [0, 0], color=BLUE, linewidth=3.2, solid_capstyle="butt")
    label(ax, (0.12, 1.6), "touches at the\nstep's end:\n$r_N \\geq 0$", RED, ha="left", size=SMALL)
    label(ax, (0.95, 0.3), "stays open:\n$r_N = 0$", BLUE, ha="left", size=SMALL)
    label(ax, (0, 2.4), "$r_N$")
    label(ax, (2.25, -0.27), "$h\\,u_N$ = gap + $h\\,v_N$", ha="right")
    label(ax, (0.75, -0.68), "$v_N$: normal velocity\nat the step's end", GREY, size=SMALL)


def draw():
    fig = figure(3.45)
    floes(fig)
    normal_law(fig)
    return fig
