"""The kinds of ice field, as `nilas field` made them: data/fields.json by take_data.py; docs/theory/ice-field.md."""
import json
import pathlib

import numpy as np

import icebreaker
from style import *

FILE = pathlib.Path(__file__).resolve().parent / "data/fields.json"
KINDS = [("packed", "floes pushed apart"), ("voronoi", "cells that share edges"),
         ("grid", "pre-sawn pieces, slanted"), ("level", "one sheet, with a bay for the hull"),
         ("channel", "floes between fixed sheets"), ("file", "outlines from a file")]
FIXED = "#C9D3DA"


def draw():
    fields = json.loads(FILE.read_text())
    fig = figure(4.05)
    for k, (kind, words) in enumerate(KINDS):
        column, row = k % 3, k // 3
        ax = canvas(fig, [0.006 + 0.333 * column, 0.51 - 0.5 * row, 0.322, 0.485], (-0.15, 12.15), (-0.15, 10.3))
        ax.add_patch(Rectangle((0, 0), 12, 8, facecolor=WATER, edgecolor=GREY, linewidth=0.8, alpha=0.75))
        for floe in fields[kind]:
            ring = np.array(floe["ring_mm"]).reshape(-1, 2) / 1000
            shape(ax, ring, FIXED if floe["fixed"] else ICE, ICE_EDGE, 0.7)
        if kind == "level":
            shape(ax, icebreaker.waterline() + (0.3, 4), HULL, HULL_EDGE, 0.9)
            label(ax, (9.3, 4), "fixed", "#52636F", size=SMALL)
        if kind == "channel":
            for y in (1.1, 6.9):
                label(ax, (6, y), "fixed", "#52636F", size=SMALL)
        label(ax, (0, 9.5), kind, INK, ha="left", fontweight="bold")
        label(ax, (0, 8.6), words, INK, ha="left", size=SMALL)
    return fig
