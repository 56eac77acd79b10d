"""Colours, sizes and marks that all pictures share. Colours: Okabe and Ito, which colour-blind people can tell apart."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.patheffects as effects
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle, FancyArrowPatch, Polygon, Rectangle

INK = "#222222"
GREY = "#777777"
ORANGE = "#E69F00"
SKY = "#56B4E9"
GREEN = "#009E73"
YELLOW = "#F0E442"
BLUE = "#0072B2"
RED = "#D55E00"
PURPLE = "#CC79A7"

FORCE = RED  # arrows of forces and impulses
MOTION = GREEN  # arrows of velocities and turns
AXIS = BLUE  # axes of frames, normals
HULL = "#D0CDC6"
HULL_EDGE = "#4A4741"
ICE = "#E4F0F8"
ICE_EDGE = "#5F86A3"
WATER = "#B9D7EA"
WATER_LINE = "#3D85B0"
HULL_WATERLINE = "#0040FF"  # as in apps/report/templates/contacts.gnuplot and apps/nilas/templates/hull.gnuplot

WIDTH = 7.2  # inches: 700 px at 97 dots per inch, so that 10 points are 13 px
SMALL = 8.5  # points: no text is smaller

plt.rcParams.update({
    "font.family": "DejaVu Sans",
    "font.size": 9.5,
    "axes.labelsize": 9.5,
    "xtick.labelsize": SMALL,
    "ytick.labelsize": SMALL,
    "legend.fontsize": SMALL,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": GREY,
    "axes.labelcolor": INK,
    "xtick.color": GREY,
    "ytick.color": GREY,
    "text.color": INK,
    "lines.linewidth": 1.5,
    "patch.linewidth": 1.0,
    "mathtext.fontset": "dejavusans",
    "svg.hashsalt": "nilas",  # the same bytes each time
    "svg.fonttype": "path",  # the same look everywhere
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
})


def figure(height, width=WIDTH):
    """An empty figure [inches]."""
    return plt.figure(figsize=(width, height))


def canvas(fig, rect, xlim, ylim):
    """Axes without frame, the same scale along x and y; rect: left, bottom, width, height in shares of the figure."""
    ax = fig.add_axes(rect)
    ax.set_aspect("equal")
    ax.set_xlim(*xlim)
    ax.set_ylim(*ylim)
    ax.axis("off")
    return ax


def arrow(ax, start, end, colour=INK, width=1.6, head=11, style="-|>", **more):
    patch = FancyArrowPatch(start, end, arrowstyle=style, mutation_scale=head, color=colour, linewidth=width,
                            shrinkA=0, shrinkB=0, joinstyle="miter", capstyle="butt", **more)
    patch.set_clip_on(False)
    ax.add_patch(patch)
    return patch


def turn(ax, centre, radius, start_deg, end_deg, colour=MOTION, width=1.6, head=11, squeeze=1.0):
    """An arc with a head at its end, counter-clockwise where end_deg > start_deg."""
    angle = np.radians(np.linspace(start_deg, end_deg, 60))
    x = centre[0] + radius * np.cos(angle)
    y = centre[1] + squeeze * radius * np.sin(angle)
    ax.plot(x[:-3], y[:-3], color=colour, linewidth=width, solid_capstyle="butt", clip_on=False, zorder=3)
    arrow(ax, (x[-6], y[-6]), (x[-1], y[-1]), colour, width, head, zorder=3)


def dimension(ax, start, end, text, offset=(0, 0), colour=GREY, **more):
    """A line with a head at both ends and a text at its middle."""
    arrow(ax, start, end, colour, 0.9, 8, "<|-|>")
    label(ax, ((start[0] + end[0]) / 2 + offset[0], (start[1] + end[1]) / 2 + offset[1]), text, INK, **more)


def label(ax, place, text, colour=INK, ha="center", va="center", size=9.5, halo=False, **more):
    item = ax.text(place[0], place[1], text, color=colour, ha=ha, va=va, fontsize=size, clip_on=False, **more)
    if halo:
        item.set_path_effects([effects.withStroke(linewidth=3, foreground="white")])
    return item


def note(ax, place, at, text, colour=INK, **more):
    """A text with a thin line to what it names."""
    ax.annotate(text, xy=at, xytext=place, color=colour, fontsize=more.pop("size", SMALL), annotation_clip=False,
                ha=more.pop("ha", "center"), va=more.pop("va", "center"),
                arrowprops={"arrowstyle": "-", "color": GREY, "linewidth": 0.8, "shrinkA": 1, "shrinkB": 0}, **more)


def shape(ax, points, face=ICE, edge=ICE_EDGE, width=1.0, **more):
    patch = Polygon(points, closed=True, facecolor=face, edgecolor=edge, linewidth=width, joinstyle="round", **more)
    ax.add_patch(patch)
    return patch


def point(ax, place, colour=INK, size=4.5, **more):
    ax.plot([place[0]], [place[1]], "o", color=colour, markersize=size, clip_on=False, zorder=more.pop("zorder", 5),
            **more)


def out_of_page(ax, centre, radius, colour=AXIS):
    """An axis towards the reader."""
    ax.add_patch(Circle(centre, radius, facecolor="white", edgecolor=colour, linewidth=1.4, zorder=5))
    ax.add_patch(Circle(centre, 0.3 * radius, facecolor=colour, edgecolor=colour, zorder=6))


def into_page(ax, centre, radius, colour=AXIS):
    """An axis away from the reader."""
    ax.add_patch(Circle(centre, radius, facecolor="white", edgecolor=colour, linewidth=1.4, zorder=5))
    d = 0.7 * radius
    for sign in (-1, 1):
        ax.plot([centre[0] - d, centre[0] + d], [centre[1] - sign * d, centre[1] + sign * d], color=colour,
                linewidth=1.4, zorder=6, solid_capstyle="butt")

