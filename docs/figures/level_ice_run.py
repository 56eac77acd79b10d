"""apps/scenes/level-ice.xml at 12 s, in plan: data/level-ice.json by take_data.py."""
from style import *
from towed_run import draw_plan


def draw():
    fig, ax, run, deck = draw_plan("level-ice", (3.5, 11.5), (-1.75, 1.75), 0.3, opacity=0.25)
    bow = deck[deck[:, 0].argmax()]
    arrow(ax, bow + (0.3, 0), bow + (1.1, 0), MOTION, 2.4, 13, zorder=7)
    label(ax, bow + (0.7, 0.2), "0.3 m/s", MOTION, size=SMALL, halo=True, zorder=7)
    return fig
