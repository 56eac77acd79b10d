"""The ice load of apps/scenes/towing.xml, the window, batch means, and the +- of the mean: data/towing-load.json by
take_data.py; docs/theory/load-error.md, "Chaos"."""
import json
import pathlib

import numpy as np
from scipy.stats import t as student

from style import *

FILE = pathlib.Path(__file__).resolve().parent / "data/towing-load.json"


def batches(series, count):
    edges = np.round(np.linspace(0, len(series), count + 1)).astype(int)
    return np.array([series[a:b].mean() for a, b in zip(edges, edges[1:])])


def half_width(means):
    """Student's t times the standard error by second differences of neighbouring batches."""
    b = len(means)
    second = means[2:] - 2 * means[1:-1] + means[:-2]
    error = np.sqrt((second**2).sum() / (6 * (b - 2) * b))
    return error * student.ppf(0.975, 18 / 35 * (b - 2))


def draw():
    kept = json.loads(FILE.read_text())
    load = np.array(kept["ice_resistance_cN"]) / 100
    time = kept["step_s"] * np.arange(1, len(load) + 1)
    window = kept["window"]
    inside = load[time > window["from_s"] + 1e-9]
    count = min((16, 32, 64), key=lambda b: half_width(batches(inside, b)))
    means = batches(inside, count)
    mean, chaos = inside.mean(), half_width(means)
    stated = kept["load_error"]
    assert abs(mean - stated["mean_N"]) < 0.01 and abs(chaos - stated["chaos_N"]) < 0.02 * stated["chaos_N"], (
        mean, chaos, stated)

    fig = figure(3.3)
    ax = fig.add_axes([0.075, 0.145, 0.61, 0.75])
    ax.axvspan(window["from_s"], window["to_s"], color="#EEF5FA", zorder=0)
    ax.plot(time, load, color="#9A9A9A", linewidth=0.45, zorder=1)
    edges = np.linspace(window["from_s"], window["to_s"], count + 1)
    ax.stairs(means, edges, baseline=None, color=BLUE, linewidth=1.6, zorder=3)
    ax.axhline(mean, xmin=0, color=RED, linewidth=1.6, zorder=4)
    ax.axvline(window["from_s"], color=GREEN, linewidth=1.4, linestyle=(0, (4, 2)))
    ax.set_xlim(0, window["to_s"])
    ax.set_ylim(0, 48)
    ax.set_xlabel("time [s]")
    ax.set_ylabel("ice_resistance_N [N]")
    ax.text(window["from_s"] + 0.4, 46.8, "window: from the end of the ramp", color="#00795A", fontsize=SMALL, va="top")
    label(ax, (2.6, 4.2), f"load in every step, peaks to {load.max():.0f} N", "#6E6E6E", ha="left", size=SMALL, halo=True)
    label(ax, (2.6, 1.6), f"means of {count} batches", BLUE, ha="left", size=SMALL, halo=True)
    ax.text(0.2, 48.8, f"mean ice load: {mean:.2f} \u00b1 {stated['estimate_N']:.2f} N", color=RED, fontsize=SMALL,
            va="bottom")

    zoom = fig.add_axes([0.775, 0.145, 0.215, 0.75])
    index = np.arange(1, count + 1)
    zoom.axhspan(mean - chaos, mean + chaos, color=RED, alpha=0.25, linewidth=0)
    zoom.axhline(mean, color=RED, linewidth=1.6)
    zoom.plot(index, means, "o-", color=BLUE, markersize=2.8, linewidth=0.7)
    zoom.set_xlim(0, count + 1)
    zoom.set_ylim(*np.array([means.min() - 0.6, means.max() + 0.6]))
    zoom.set_xlabel("batch")
    zoom.set_xticks([1, count // 2, count])
    zoom.set_ylabel("batch mean [N]", labelpad=2)
    zoom.set_title(f"chance: \u00b1 {chaos:.2f} N, from\nneighbours' differences", fontsize=SMALL, color=RED, loc="left",
                   pad=4, linespacing=1.1)
    return fig
