# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
# ---

# %% [markdown]
# # Reading a run into pandas
#
# Any run folder can be read, also one that still goes on. Nothing is read before it is asked for.
# Run this from the top of the source tree.

# %%
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

import nilas

SCENE = "apps/scenes/towing.xml"
SECONDS = 10
FOLDER = Path("runs/examples/pandas")

# %%
if not FOLDER.exists():
    nilas.run(SCENE, out=FOLDER, until=SECONDS)
run = nilas.Run(FOLDER)
print(run, "has the tables", run.tables)

# %% [markdown]
# ## Tables and units
# Read the columns and the time that you need: a long run has hundreds of megabytes.

# %%
half = run.summary["time_end_s"] / 2
some = run.table("vessel", columns=["ice_resistance_N", "x_m", "yaw_deg"], between=(half, np.inf))
print(some.describe().round(3))
print(some.attrs["units"])

# %% [markdown]
# ## Contacts
# `contacts.h5` has a row per contact and step. A window of time is read without the rest. Here are
# the impulses on the hull in the second half of the run, in the frame of the hull.

# %%
columns = ["hull_x_m", "hull_y_m", "hull_z_m", "fx_N", "fy_N", "fz_N", "status"]
contacts = run.contacts.between(half, np.inf, columns)
size = np.linalg.norm(contacts[["fx_N", "fy_N", "fz_N"]], axis=1)
pressed = contacts.assign(size_N=size)[contacts.status > 0]  # 0: open
print(f"{len(pressed)} of {len(contacts)} contacts carried a force.")
print(pressed.groupby("status").size_N.describe().round(2))

# %% [markdown]
# ## Bodies
# Poses are numpy arrays over times and bodies. The way of each floe over the run:

# %%
bodies = run.bodies
way = np.linalg.norm(bodies.position[-1] - bodies.position[0], axis=1)
kinds = run.replay.bodies()
floes = [place for place, number in enumerate(bodies.ids) if kinds[int(number)].kind == "floe"]
print(f"The median floe moved by {np.nanmedian(way[floes]):.4f} m, from {bodies.source}.")

# %% [markdown]
# ## Where the ice pushed
# The mean force by place along the hull, and where the contacts lay, seen from above.

# %%
length = run.replay.head["hull"]["length"]
edges = (
    np.linspace(pressed.hull_x_m.min() - 0.01, length, 30)
    if len(pressed)
    else np.array([0, length])
)
steps = run.table("steps", columns=["contacts"], between=(half, np.inf))
along, _ = np.histogram(pressed.hull_x_m, edges, weights=pressed.size_N / len(steps))

figure, (upper, lower) = plt.subplots(2, 1, sharex=True, figsize=(8, 5.5), layout="constrained")
upper.stairs(along, edges, fill=True, color="C0")
upper.set_ylabel("mean force in each strip [N]")
largest = pressed.size_N.max()
dots = lower.scatter(
    pressed.hull_x_m,
    pressed.hull_y_m,
    c=pressed.size_N,
    norm=LogNorm(largest / 1000, largest),
    s=6,
)
side = max(0.05 * length, 1.1 * pressed.hull_y_m.abs().max())
lower.set_ylim(-side, side)
lower.set_ylabel("to port [m]")
lower.set_xlabel("forward, from the aft end of the hull [m]")
figure.colorbar(dots, ax=lower, label="force [N]")
figure.suptitle(f"{run.summary['scene']}: contacts of ice and hull after {half:g} s")
figure.savefig(FOLDER / "contacts-on-hull.png", dpi=120)
print("The picture is", FOLDER / "contacts-on-hull.png")
