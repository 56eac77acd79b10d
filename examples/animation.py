# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
# ---

# %% [markdown]
# # An animation
#
# We draw a run in plan with matplotlib, floes coloured by their speed, and write it as a GIF. The
# program has films of its own in 3-D: `nilas view RUN --mp4`. For Blender there is a glTF file.
# Run this from the top of the source tree.

# %%
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.collections import PolyCollection

import nilas

SCENE = "apps/scenes/towing.xml"
SECONDS = 6
FOLDER = Path("runs/examples/animation")

# %%
if not FOLDER.exists():
    nilas.run(SCENE, out=FOLDER, until=SECONDS)
run = nilas.Run(FOLDER)

# %% [markdown]
# ## Frames
# `trajectory` has the surfaces at each stored time. The upper face of a floe is its outline in
# plan. The hull is drawn by all of its polygons, from below to above.

# %%
times = run.trajectory.times
frames = [run.trajectory.surface("ice floes", time) for time in times]
hulls = [run.trajectory.surface("vessel", time) for time in times]


def outlines(surface):
    return [face[:, :2] for face in surface.upper_faces().values()]


def speeds(surface):
    _, first = np.unique(surface.cells["id"], return_index=True)
    return surface.cells["speed_m_s"][np.sort(first)]


def hull_outline(surface):
    return [surface.polygon(k)[:, :2] for k in range(len(surface))]


# %% [markdown]
# ## The animation
# The picture shows the bow and the ice around it.

# %%
hull = hulls[-1].points
x0, x1 = hull[:, 0].max() - 2.5, hull[:, 0].max() + 1.5
y = 0.5 * (hull[:, 1].min() + hull[:, 1].max())
figure, axes = plt.subplots(figsize=(7, 5.2), layout="constrained")
axes.set(xlim=(x0, x1), ylim=(y - 1.4, y + 1.4), aspect="equal", xlabel="x [m]", ylabel="y [m]")
axes.set_facecolor("#123a5c")
fastest = max(np.percentile(speeds(frame), 99) for frame in frames) or 1.0
ice = PolyCollection([], cmap="YlOrRd", edgecolors="#203040", linewidths=0.5)
ice.set_clim(0, fastest)
ship = PolyCollection([], facecolors="#45525c", edgecolors="#45525c")
axes.add_collection(ice)
axes.add_collection(ship)
figure.colorbar(ice, ax=axes, label="speed of the floes [m/s]", shrink=0.8)


def draw(number):
    ice.set_verts(outlines(frames[number]))
    ice.set_array(speeds(frames[number]))
    ship.set_verts(hull_outline(hulls[number]))
    axes.set_title(f"{run.summary['scene']} at {times[number]:.1f} s")
    return ice, ship


animation = FuncAnimation(figure, draw, frames=len(frames))
animation.save(FOLDER / "plan.gif", writer=PillowWriter(fps=10), dpi=80)
draw(len(frames) - 1)
figure.savefig(FOLDER / "plan.png", dpi=120)
print("The film is", FOLDER / "plan.gif")

# %% [markdown]
# ## For Blender
# File, Import, glTF 2.0 opens this file with all bodies and their motion.

# %%
run.to_gltf(FOLDER / "run.glb")
print("The file for Blender is", FOLDER / "run.glb")
