"""World and vessel frames, angles, loads along the course: docs/reference/conventions.md."""
import numpy as np

import icebreaker
from style import *


def rotated(points, deg, origin=(0, 0)):
    a = np.radians(deg)
    turn_by = np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])
    return np.asarray(points) @ turn_by.T + np.asarray(origin)


def plan(fig):
    ax = canvas(fig, [0.01, 0.365, 0.98, 0.63], (-0.75, 13.6), (-3.15, 3.15))
    ax.add_patch(Rectangle((0, -3), 13.6, 6, facecolor="#EEF5FA", edgecolor="none"))
    for y in (-3, 3):
        ax.plot([0, 13.6], [y, y], color=GREY, linewidth=2.5, solid_capstyle="butt")
    ax.plot([0, 0], [-3, 3], color=GREY, linewidth=2.5)
    label(ax, (13.4, -2.65), "tank, seen from above", GREY, ha="right", size=SMALL)

    # ground frame
    arrow(ax, (0, 0), (1.5, 0), AXIS, 1.8, zorder=4)
    arrow(ax, (0, 0), (0, 1.5), AXIS, 1.8, zorder=4)
    label(ax, (1.76, 0.0), "X", AXIS)
    label(ax, (0.3, 1.5), "Y", AXIS)
    out_of_page(ax, (0, 0), 0.16)
    label(ax, (0.18, -0.42), "G: Z up,\ntowards you", AXIS, ha="left", va="top", size=SMALL)
    label(ax, (0.25, 2.72), "Forces and moments: components along X, Y, Z,\n"
          "moments right-handed about them", FORCE, ha="left", va="top", size=SMALL)

    # vessel
    heading, origin = 22, np.array([3.4, -1.75])
    shape(ax, rotated(icebreaker.plan(), heading, origin), "#EBE9E4", HULL_EDGE, 1.0)
    shape(ax, rotated(icebreaker.waterline(), heading, origin), HULL, HULL_EDGE, 0.8)
    at = lambda x, y=0: rotated([[x, y]], heading, origin)[0]
    ax.plot([origin[0], origin[0] + 8.6], [origin[1]] * 2, color=GREY, linewidth=0.9, dashes=(5, 4), zorder=1)
    line = np.array([at(0), at(9.2)])
    ax.plot(line[:, 0], line[:, 1], color=GREY, linewidth=0.9, dashes=(5, 4), zorder=2)
    arrow(ax, at(0), at(1.4), AXIS, 1.8, zorder=4)
    arrow(ax, at(0), at(0, 1.3), AXIS, 1.8, zorder=4)
    label(ax, at(1.5, 0.22), "x", AXIS)
    label(ax, at(0.05, 1.52), "y, to port", AXIS, ha="right")
    out_of_page(ax, at(0), 0.16)
    note(ax, (2.6, -2.6), at(0) - (0.05, 0.17), "V: origin of the hull mesh", AXIS)
    point(ax, at(2.25))
    note(ax, (6.7, -2.5), at(2.25), "B: axes of V, origin\nat the centre of mass")
    turn(ax, origin, 7.7, 0, heading, MOTION)
    label(ax, (origin[0] + 7.8, origin[1] + 1.9), "heading, yaw:\nfrom X towards Y", MOTION, ha="left", size=SMALL)

    # the course of an oblique tow, and the ice load along and across it
    joint = at(2.9)
    ax.plot(*joint, "s", color=MOTION, markersize=5.5, zorder=5)
    arrow(ax, joint, joint + (2.6, 0), MOTION, 2.2, 13, zorder=4)
    label(ax, joint + (1.95, -0.58), "course: as the carriage\nmoves the joint", MOTION, ha="left", size=SMALL)
    place = at(4.9)
    arrow(ax, place, place + (-1.5, 0), FORCE, 2.4, 13, zorder=4)
    arrow(ax, place, place + (0, 1.5), FORCE, 2.4, 13, zorder=4)
    point(ax, place, FORCE)
    label(ax, place + (-1.6, 0.28), "ice_resistance_N,\npositive astern", FORCE, ha="right", size=SMALL)
    label(ax, place + (0.2, 1.5), "ice_side_N, positive\nto port of the course", FORCE, ha="left", size=SMALL)


def side(fig):
    ax = canvas(fig, [0.01, 0.01, 0.61, 0.345], (-0.55, 7.55), (-0.95, 1.75))
    ax.add_patch(Rectangle((-0.55, -0.95), 8.1, 1.3, facecolor=WATER, edgecolor="none", alpha=0.5))
    shape(ax, icebreaker.profile(), HULL, HULL_EDGE)
    ax.plot([-0.55, 7.55], [0.35, 0.35], color=WATER_LINE, linewidth=1.2)
    label(ax, (7.5, 0.14), "still water, Z = 0", WATER_LINE, ha="right", size=SMALL)
    arrow(ax, (0, 0), (1.25, 0), AXIS, 1.8)
    arrow(ax, (0, 0), (0, 1.2), AXIS, 1.8)
    label(ax, (1.45, 0.12), "x", AXIS)
    label(ax, (0.0, 1.38), "z", AXIS)
    into_page(ax, (0, 0), 0.13)
    label(ax, (-0.12, -0.34), "V: y away from you", AXIS, ha="left", size=SMALL)
    dimension(ax, (3.9, 0.0), (3.9, 0.35), "")
    note(ax, (4.6, -0.34), (3.9, 0.1), "draught: keel to still water")
    point(ax, (2.25, 0.33))
    turn(ax, (2.25, 0.33), 1.0, 140, 40, MOTION)
    label(ax, (2.25, 1.55), "pitch (trim): bow down", MOTION, size=SMALL)
    label(ax, (-0.45, -0.8), "seen from starboard", GREY, ha="left", size=SMALL)


def aft(fig):
    ax = canvas(fig, [0.64, 0.01, 0.35, 0.345], (-1.15, 1.15), (-0.42, 0.92))
    ax.add_patch(Rectangle((-1.15, -0.42), 2.3, 0.77, facecolor=WATER, edgecolor="none", alpha=0.5))
    body = icebreaker.section(0, 3.0)
    body[:, 0] *= -1  # port to the left
    shape(ax, body, HULL, HULL_EDGE)
    ax.plot([-1.15, 1.15], [0.35, 0.35], color=WATER_LINE, linewidth=1.2)
    arrow(ax, (0, 0), (-0.4, 0), AXIS, 1.8)
    arrow(ax, (0, 0), (0, 0.46), AXIS, 1.8)
    label(ax, (-0.45, 0.02), "y", AXIS)
    label(ax, (0.07, 0.46), "z", AXIS)
    into_page(ax, (0, 0), 0.06)
    label(ax, (0.0, -0.14), "x away from you", AXIS, size=SMALL)
    turn(ax, (0, 0.28), 0.48, 150, 30, MOTION)
    label(ax, (0, 0.86), "roll (heel): port up", MOTION, size=SMALL)
    label(ax, (-0.88, 0.43), "port", GREY, size=SMALL)
    label(ax, (0.88, 0.43), "starboard", GREY, size=SMALL)
    label(ax, (-1.11, -0.35), "seen from aft", GREY, ha="left", size=SMALL)


def draw():
    fig = figure(5.2)
    plan(fig)
    side(fig)
    aft(fig)
    return fig
