"""One output step as a flow: Simulation::step and World::part_of_step of core/sim/simulation.cpp."""
from matplotlib.patches import FancyBboxPatch

from style import *

X, W = 2.75, 3.95  # middle and width of the boxes
TALL = 0.52

BOXES = [  # what it does, what it works on
    ("Loads", "of weight and water; with moreau at the\nposes after the motion before the impulses", "#E8EEF4"),
    ("Substep", "the rest of the step, or up to\nthe first impact of a fast pair", "#E8EEF4"),
    ("Detect", "contacts that can close in the substep,\nfaces that crush ice", "#DCEBF5"),
    ("Assemble", "one contact problem: M, f, H, w, mu;\nload cells and joints as a stiff block", "#DCEBF5"),
    ("Solve", "impulses r and velocities v;\nmeasured residuals of the law", "#FBE3D2"),
    ("Advance", "new velocities, then new poses", "#DDF1EA"),
    ("Correct", "positions: penetration is taken back\nas the scene chose", "#DDF1EA"),
    ("Accounts", "energy, momentum, load cells, crushed\nice, loads that may break ice", "#F6EFD6"),
]


def box(ax, y, title, text, colour, tall=TALL):
    ax.add_patch(FancyBboxPatch((X - W / 2, y - tall / 2), W, tall, boxstyle="round,pad=0,rounding_size=0.07",
                                facecolor=colour, edgecolor=GREY, linewidth=1.0))
    label(ax, (X - W / 2 + 0.12, y), title, INK, ha="left", fontweight="bold")
    label(ax, (X - W / 2 + 1.03, y), text, INK, ha="left", size=SMALL)


def route(ax, points, colour, text=None, at=None, ha="left"):
    for a, b in zip(points[:-2], points[1:-1]):
        ax.plot(*zip(a, b), color=colour, linewidth=1.5, solid_capstyle="round", clip_on=False)
    arrow(ax, points[-2], points[-1], colour, 1.5, 11)
    if text:
        label(ax, at, text, colour, ha=ha, size=SMALL)


def draw():
    fig = figure(6.35)
    ax = canvas(fig, [0.0, 0.0, 1.0, 1.0], (0, 7.2), (0, 6.35))
    step = 0.67
    ys = [5.85 - step * k for k in range(len(BOXES))]
    left, right = X - W / 2, X + W / 2
    ax.add_patch(FancyBboxPatch((0.08, ys[-1] - 0.39), 7.04, ys[0] - ys[-1] + 0.81,
                                boxstyle="round,pad=0,rounding_size=0.1", facecolor="none", edgecolor=GREY,
                                linewidth=1.0, linestyle=(0, (5, 3))))
    label(ax, (7.0, ys[-1] - 0.24), "substep of length h", GREY, ha="right", size=SMALL)
    for y, (title, text, colour) in zip(ys, BOXES):
        box(ax, y, title, text, colour)
    for a, b in zip(ys, ys[1:]):
        arrow(ax, (X, a - TALL / 2), (X, b + TALL / 2), INK, 1.4, 9)
    last = ys[-1] - 0.83
    box(ax, last, "Break", "floes that the step's loads break; their\npieces take part from the next step", "#F6EFD6")
    arrow(ax, (X, ys[-1] - TALL / 2), (X, last + TALL / 2), INK, 1.4, 9)
    label(ax, (X + 0.1, ys[-1] - 0.48), "the step's end is reached", INK, ha="left", size=SMALL)
    arrow(ax, (right, last), (right + 0.55, last), INK, 1.4, 10)
    label(ax, (right + 0.65, last), "one row of\nthe outputs", INK, ha="left", size=SMALL)

    route(ax, [(left, ys[-1]), (0.45, ys[-1]), (0.45, ys[0]), (left, ys[0])], BLUE)
    label(ax, (0.29, (ys[0] + ys[-1]) / 2), "time is left in the step: next substep", BLUE, size=SMALL, rotation=90)

    # solve again, or take back
    solve, assemble = ys[4], ys[3]
    route(ax, [(right, solve + 0.1), (right + 0.28, solve + 0.1), (right + 0.28, assemble), (right, assemble)],
          "#9B4F7D", "v leads a fast pair\ninto each other:\nadd its contacts", (right + 0.38, assemble - 0.28))
    route(ax, [(right, solve - 0.1), (right + 2.0, solve - 0.1), (right + 2.0, ys[0]), (right, ys[0])], ORANGE)
    label(ax, (right + 0.38, solve - 0.42), "a fast pair is still not held:\ntake the motion back, halve h", "#9A6A00",
          ha="left", size=SMALL)
    return fig
