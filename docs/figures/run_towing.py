"""apps/scenes/towing.xml at 40 s, in plan: data/towing.json by take_data.py."""
from style import *
from towed_run import draw_plan


def draw():
    fig, ax, run, deck = draw_plan("towing", (7.5, 23.5), (-4.0, 4.0), 0.15)
    bow = deck[deck[:, 0].argmax()]
    arrow(ax, bow + (0.25, 0), bow + (1.45, 0), MOTION, 2.4, 13, zorder=7)
    label(ax, bow + (0.85, 0.33), "0.3 m/s", MOTION, size=SMALL, halo=True, zorder=7)
    return fig
