"""Plan of a run's last frame: floes by speed, the hull at its waterline and deck. Data: take_data.py."""
import json
import pathlib

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.ticker import MultipleLocator

import icebreaker
from style import *

DATA = pathlib.Path(__file__).resolve().parent / "data"
SPEEDS = LinearSegmentedColormap.from_list("speeds", ["#F7FAFC", "#F6E3A1", ORANGE, RED, "#7A2E00"])


def draw_plan(name, xlim, ylim, fastest, opacity=0.82):
    run = json.loads((DATA / f"{name}.json").read_text())
    wide, tall = xlim[1] - xlim[0], ylim[1] - ylim[0]
    scale = (WIDTH - 0.62) / wide  # inches per metre
    height = scale * tall + 1.0
    fig = figure(height)
    ax = fig.add_axes([0.5 / WIDTH, 0.9 / height, scale * wide / WIDTH, scale * tall / height])
    ax.set_facecolor("#A9CBE0")
    ax.set_aspect("equal")
    for side in ax.spines.values():
        side.set_visible(True)
    norm = Normalize(0, fastest)
    for floe in sorted(run["floes"], key=lambda item: item["z_mm"]):
        ring = np.array(floe["ring_mm"]).reshape(-1, 2) / 1000
        shape(ax, ring, SPEEDS(norm(floe["speed_mm_s"] / 1000)), ICE_EDGE, 0.45, zorder=2)
    yaw, com = np.radians(run["yaw_deg"]), np.array(run["vessel_com_m"])
    turn_by = np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
    placed = lambda outline: (outline - np.array(run["cog_m"][:2])) @ turn_by.T + com
    deck, water = placed(icebreaker.plan()), placed(icebreaker.waterline())
    shape(ax, water, "#F3EFE6", HULL_EDGE, 1.2, zorder=4, alpha=opacity)
    ax.plot(*np.vstack([water, water[:1]]).T, color=HULL_WATERLINE, linewidth=1.3, zorder=5)
    ax.plot(*np.vstack([deck, deck[:1]]).T, color=HULL_EDGE, linewidth=1.0, zorder=5)
    ax.set_xlim(*xlim)
    ax.set_ylim(*ylim)
    ax.yaxis.set_major_locator(MultipleLocator(1))
    ax.yaxis.set_major_formatter("{x:g}")
    ax.set_xlabel("X [m]", labelpad=1)
    ax.set_ylabel("Y [m]", labelpad=2)
    bar = fig.add_axes([0.63, 0.33 / height, 0.33, 0.11 / height])
    fig.colorbar(ScalarMappable(norm, SPEEDS), cax=bar, orientation="horizontal", extend="max")
    bar.set_xticks([0, fastest / 3, 2 * fastest / 3, fastest])
    bar.set_xticklabels(["0", f"{fastest / 3:g}", f"{2 * fastest / 3:g}", f"{fastest:g}"])
    bar.tick_params(length=2, pad=2)
    fig.text(0.615, 0.385 / height, "speed of the ice [m/s]", fontsize=SMALL, ha="right", va="center")
    return fig, ax, run, deck
