"""Carriage, force balance of six load cells, joint and vessel: docs/theory/vessel.md. The cells stand as
default_cells() of core/vessel/cells.cpp puts them, with an arm of a quarter of the hull's length."""
import numpy as np

import icebreaker
from style import *

JOINT = np.array([2.9, 0.0, 0.35])  # of apps/scenes/towing.xml, in V
ARM = icebreaker.LENGTH / 4
CELLS = [((0, 0), "x"), ((ARM, 0), "y"), ((-ARM, 0), "y"), ((ARM, 0), "z"), ((-ARM / 2, ARM / 2), "z"),
         ((-ARM / 2, -ARM / 2), "z")]
COLOUR = {"x": RED, "y": GREEN, "z": BLUE}
LIFT = 1.55  # the balance is drawn so far above the joint [m]


def seen(point):
    """Oblique view from starboard: y, to port, goes up and to the right."""
    x, y, z = point
    return np.array([x + 0.55 * y, 1.25 * z + 0.5 * y])


def cell(ax, start, end, colour, zorder=6):
    """A load cell: a bar with its body in the middle."""
    start, end = np.asarray(start), np.asarray(end)
    ax.plot(*np.array([start, end]).T, color=INK, linewidth=1.2, zorder=zorder)
    body = start + np.outer([0.28, 0.78], end - start)
    ax.plot(*body.T, color=colour, linewidth=6, solid_capstyle="butt", zorder=zorder)
    ax.plot(*start, "o", color=INK, markersize=2.8, zorder=zorder)
    ax.plot(*end, "o", color=INK, markersize=2.8, zorder=zorder)


def rig(fig):
    ax = canvas(fig, [0.005, 0.375, 0.99, 0.62], (-1.2, 9.6), (-0.45, 4.45))
    # hull: deck and waterline, still water
    plane = [seen((x, y, 0.35)) for x, y in ((-0.6, -1.05), (7.1, -1.05), (7.6, 1.25), (-0.1, 1.25))]
    shape(ax, plane, WATER, "none", alpha=0.45)
    deck = np.array([seen((x, y, 0.6)) for x, y in icebreaker.plan()])
    water = np.array([seen((x, y, 0.35)) for x, y in icebreaker.waterline()])
    keel = np.array([seen((x, y, 0.0)) for x, y in icebreaker.section(2, 0.004)])
    from scipy.spatial import ConvexHull
    both = np.vstack([deck, keel])
    shape(ax, both[ConvexHull(both).vertices], "#B8B4AB", HULL_EDGE)
    shape(ax, deck, HULL, HULL_EDGE)
    ax.plot(*np.vstack([water, water[:1]]).T, color=WATER_LINE, linewidth=1.0, linestyle=(0, (4, 2)), zorder=4)
    label(ax, seen((1.0, 0, 0.6)), "vessel", HULL_EDGE)

    # joint and its post
    joint, plate_z = JOINT + (0, 0, 0.25), JOINT[2] + LIFT
    ax.plot(*np.array([seen(joint), seen((JOINT[0], 0, plate_z))]).T, color=HULL_EDGE, linewidth=3.5, zorder=5)
    foot = seen(joint)
    ax.plot(*foot, "o", color="white", markeredgecolor=INK, markeredgewidth=1.6, markersize=9, zorder=7)
    arrow(ax, foot + (-0.32, -0.28), foot + (-0.32, 0.42), MOTION, 1.6, 9, "<|-|>", zorder=7)
    note(ax, (5.35, 1.42), foot + (0.12, 0.05), "joint, here free in heave", ha="left")

    # platform, massless: from it every cell leads to the carriage
    corners = [(ARM, -0.16), (ARM, 0.16), (-ARM / 2 - 0.1, ARM / 2 + 0.16), (-ARM - 0.1, 0.16), (-ARM - 0.1, -0.16),
               (-ARM / 2 - 0.1, -ARM / 2 - 0.16)]
    shape(ax, [seen((JOINT[0] + x, y, plate_z)) for x, y in corners], "#F3E6C8", "#8A6D1F", 1.1, zorder=5)
    frame_z = plate_z + 1.02
    along = {"x": (0.62, 0, 0), "y": (0, 0.95, 0), "z": (0, 0, 0.7)}
    for k, ((x, y), axis) in enumerate(CELLS):
        start = np.array([JOINT[0] + x, y, plate_z])
        end = start + along[axis]
        cell(ax, seen(start), seen(end), COLOUR[axis], 8 if axis != "y" else 7)
        if axis != "z":  # a bracket of the carriage
            top = np.array([end[0], end[1], frame_z])
            ax.plot(*np.array([seen(end), seen(top)]).T, color=GREY, linewidth=4, solid_capstyle="butt", zorder=4)
        else:
            ax.plot(*np.array([seen(end), seen((end[0], end[1], frame_z))]).T, color=GREY, linewidth=4,
                    solid_capstyle="butt", zorder=4)
        where = {"x": seen(start + 0.5 * np.array(along[axis])) + (0.02, -0.23),
                 "y": seen(end) + (0.26, -0.12), "z": seen(end) + (-0.24, -0.2)}[axis]
        label(ax, where, str(k + 1), COLOUR[axis], size=10.5, fontweight="bold", halo=True, zorder=9)
    note(ax, (6.35, 1.86), seen((JOINT[0] + ARM - 0.15, -0.12, plate_z)) , "massless platform", ha="left")

    # carriage frame on rails
    slab = [(0.6, -1.15), (5.9, -1.15), (5.9, 1.25), (0.6, 1.25)]
    shape(ax, [seen((x, y, frame_z)) for x, y in slab], "#DDDDDD", GREY, 1.2, zorder=3, alpha=0.55)
    shape(ax, [seen((x, y, z)) for x, y, z in ((0.6, -1.15, frame_z), (5.9, -1.15, frame_z),
                                               (5.9, -1.15, frame_z + 0.14), (0.6, -1.15, frame_z + 0.14))],
          "#BBBBBB", GREY, 1.0, zorder=3)
    label(ax, seen((1.9, 0.85, frame_z)) + (0, 0.1), "carriage", INK, zorder=9)
    arrow(ax, (6.75, 3.62), (8.35, 3.62), MOTION, 2.4, 14)
    label(ax, (6.75, 3.93), "prescribed motion", MOTION, ha="left")
    label(ax, (6.75, 3.3), "frame C: origin at the joint,\nturns with the carriage's yaw", AXIS, ha="left", va="top",
          size=SMALL)

    # ice load and where it goes
    bow = seen((5.75, 0, 0.42))
    arrow(ax, bow + (1.5, 0.0), bow + (0.12, 0.0), FORCE, 2.4, 14, zorder=8)
    label(ax, bow + (0.55, 0.27), "ice load", FORCE, ha="left")
    label(ax, (-1.1, 3.95), "force path", FORCE, ha="left", fontweight="bold")
    for k, text in enumerate(("carriage", "six cells", "platform", "joint", "hull", "ice, water")):
        y = 3.62 - 0.36 * k
        label(ax, (-0.95, y), text, INK, ha="left", size=SMALL)
        if k:
            ax.annotate("", xy=(-1.08, y + 0.26), xytext=(-1.08, y), annotation_clip=False,
                        arrowprops={"arrowstyle": "-|>", "color": FORCE, "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0})


def layout(fig):
    ax = canvas(fig, [0.07, 0.0, 0.58, 0.37], (-2.75, 2.75), (-1.28, 1.28))
    outline = icebreaker.plan() - JOINT[:2]
    keep = outline[np.abs(outline[:, 0]) < 3.3]
    shape(ax, keep, "#F4F2EE", HULL_EDGE, 0.9)
    ax.set_clip_on(True)
    b = ARM
    ax.plot([0, 0], [-1.15, 1.15], color=GREY, linewidth=0.6, dashes=(5, 4))
    ax.plot([-2.7, 2.7], [0, 0], color=GREY, linewidth=0.6, dashes=(5, 4))
    for k, ((x, y), axis) in enumerate(CELLS):
        if axis == "x":
            arrow(ax, (x, y), (x + 0.75, y), COLOUR[axis], 2.4, 12, zorder=6)
            label(ax, (x + 0.45, y - 0.2), f"{k + 1}: X", COLOUR[axis], size=SMALL, fontweight="bold")
        elif axis == "y":
            arrow(ax, (x, y), (x, y + 0.62), COLOUR[axis], 2.4, 12, zorder=6)
            label(ax, (x + 0.34, y + 0.4), f"{k + 1}: Y", COLOUR[axis], size=SMALL, fontweight="bold")
        else:
            out_of_page(ax, (x, y), 0.12, COLOUR[axis])
            label(ax, (x + (0.4 if x > 0 else -0.4), y - (0.18 if x > 0 else 0)), f"{k + 1}: Z", COLOUR[axis],
                  size=SMALL, fontweight="bold")
    point(ax, (0, 0), INK, 5)
    label(ax, (0.12, 0.2), "joint", INK, ha="left", size=SMALL)
    for x0, x1, text in ((0, b, "b"), (-b, 0, "b")):
        dimension(ax, (x0, -1.0), (x1, -1.0), text, (0, -0.17), size=SMALL)
    dimension(ax, (-b / 2, 1.0), (0, 1.0), "b/2", (0, 0.16), size=SMALL)
    dimension(ax, (-0.28, 0), (-0.28, b / 2), "b/2", (0.02, 0), size=SMALL, halo=True)
    for x in (-b, b, -b / 2):
        ax.plot([x, x], [0 if abs(x) == b else b / 2, -1.08 if abs(x) == b else 1.08], color=GREY, linewidth=0.6)


def words(fig):
    ax = canvas(fig, [0.67, 0.0, 0.33, 0.37], (0, 3.1), (0, 3.5))
    rows = (("Plan of the default layout", None), ("b: a quarter of the hull's length", None),
            ("all six at the joint's height", None), ("arrows: from vessel to carriage;", None),
            ("tension reads positive", None), ("1 takes surge", RED), ("2, 3 take sway and yaw", GREEN),
            ("4, 5, 6 take heave, roll, pitch", BLUE))
    for k, (text, colour) in enumerate(rows):
        label(ax, (0.02, 3.2 - 0.4 * k), text, colour or INK, ha="left", size=SMALL,
              fontweight="bold" if k == 0 else "normal")


def draw():
    fig = figure(5.3)
    rig(fig)
    layout(fig)
    words(fig)
    return fig
