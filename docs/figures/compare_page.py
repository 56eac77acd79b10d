"""The main picture of a page of `nilas compare`: error of the mean ice load against computing time, for
apps/scenes/presawn-c.xml with a budget of 280 s. Data: data/compare-settings.csv by take_data.py; docs/theory/compare.md."""
import csv
import pathlib

import numpy as np

from style import *

FILE = pathlib.Path(__file__).resolve().parent / "data/compare-settings.csv"
# where the name of a setting stands: shift in points, alignment
BESIDE = {"pgs + pyramid": (8, 0, "left"), "tolerance 0.0001 m/s": (-10, -14, "center"), "split-impulse": (22, 17, "right"),
          "step 0.01 s": (6, -16, "left"), "own setting": (9, 3, "left"), "step 0.0025 s": (-12, -9, "right"),
          "auto": (0, 10, "center"), "nsgs": (0, 10, "center")}


def draw():
    with open(FILE, newline="") as text:
        rows = [row for row in csv.DictReader(text) if row["error_N"]]
    whole = [row for row in rows if row["partial"] == "0"]
    mean = float(whole[0]["load_N"]) - float(whole[0]["load_difference_N"])  # of the reference
    floor = float(whole[0]["floor_N"])
    fig = figure(3.9)
    ax = fig.add_axes([0.085, 0.125, 0.655, 0.85])
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlim(0.18, 0.8)
    ax.set_ylim(0.1, 0.4)
    ax.axhspan(0.01, floor, color="#ECECEC", linewidth=0, zorder=0)
    ax.text(0.185, floor * 0.965, "below this level chance explains the difference", color="#666666", fontsize=SMALL, va="top")
    ax.axhline(0.02 * mean, color=GREEN, linewidth=1.2, linestyle=(0, (5, 3)), zorder=1)
    ax.text(0.185, 0.02 * mean * 0.975, "2 % of the mean load", color="#00795A", fontsize=SMALL, va="top", ha="left")
    for row in whole:
        x, error, name = float(row["compute_s_per_s"]), float(row["error_N"]), row["label"]
        significant, dominated = row["told_from_chaos"] == "1", row["dominated"] == "1"
        colour = BLUE if not significant else "#8A8A8A" if dominated else INK
        y = error if significant else floor
        if significant:
            ax.errorbar(x, y, yerr=float(row["load_difference_se_N"]), color=colour, marker="o", markersize=5.5,
                        elinewidth=1.1, capsize=3, zorder=4)
        else:
            ax.plot(x, y, marker="v", markersize=8, markerfacecolor="white", markeredgecolor=colour, markeredgewidth=1.5,
                    zorder=4)
        if row["chosen"] == "1":
            ax.plot(x, y, marker="o", markersize=15, markerfacecolor="none", markeredgecolor=RED, markeredgewidth=2.2,
                    zorder=5)
        dx, dy, align = BESIDE.get(name, (8, 0, "left"))
        ax.annotate(f"{row['number']}  {name}", (x, y), (dx, dy), textcoords="offset points", color=colour, ha=align,
                    va="center", fontsize=SMALL, zorder=6,
                    path_effects=[effects.withStroke(linewidth=2.5, foreground="white")] if significant else None)
    for axis, ticks in ((ax.xaxis, [0.2, 0.3, 0.4, 0.5, 0.6, 0.7]), (ax.yaxis, [0.1, 0.15, 0.2, 0.25, 0.3, 0.4])):
        axis.set_ticks(ticks, [f"{tick:g}" for tick in ticks])
        axis.set_ticks([], minor=True)
    ax.set_xlabel("computing time per simulated second [s/s]")
    ax.set_ylabel("error of the mean ice load [N]")

    legend(fig, mean, {row["number"]: row["label"] for row in rows})
    return fig


def legend(fig, mean, labels):
    ax = canvas(fig, [0.755, 0.125, 0.245, 0.85], (0, 1.76), (0, 3.31))
    at = lambda k: 3.1 - 0.44 * k
    entries = (("nothing is faster\nand better", INK, "o"), ("another is faster\nand better", "#8A8A8A", "o"),
               ("error hidden by\nchance", BLUE, "v"), ("chosen: within 2 %,\nbodies at most twice\nas deep as with 1", RED, "ring"))
    for k, (text, colour, mark) in enumerate(entries):
        if mark == "ring":
            ax.plot(0.1, at(k), "o", markersize=12, markerfacecolor="none", markeredgecolor=colour, markeredgewidth=2.2)
        elif mark == "v":
            ax.plot(0.1, at(k), "v", markersize=8, markerfacecolor="white", markeredgecolor=colour, markeredgewidth=1.5)
        else:
            ax.plot(0.1, at(k), "o", markersize=5.5, color=colour)
        label(ax, (0.27, at(k)), text, INK, ha="left", size=SMALL)
    label(ax, (0.02, 1.12), f"mean load {mean:.2f} N\nbars: standard errors\nover two realisations", INK, ha="left", va="top",
          size=SMALL)
