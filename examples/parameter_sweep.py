# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
# ---

# %% [markdown]
# # A parameter sweep
#
# How does the ice load grow with the speed of the tow? We run one scene at several speeds and in
# several ice fields. This is a plain loop; `nilas study` does the same with restarts, on several
# cores and on clusters. Run this from the top of the source tree.

# %%
from itertools import product

import matplotlib.pyplot as plt
import numpy as np

import nilas

SCENE = "apps/scenes/towing.xml"
SPEEDS = [0.2, 0.3, 0.4]  # [m/s]
SEEDS = [7, 8, 9]
DISTANCE = 1.5  # way of the carriage in each run [m]
SETTINGS = {"vessel/carriage/@ramp": 1}
FOLDER = "runs/examples/sweep"

# %% [markdown]
# Any attribute of the scene can be set by its path, as by `--set`. The seed makes another ice field
# of the same kind. Each run has its own folder. A run that fails raises `nilas.Failed`, which is
# noted here, and the others go on.

# %%
folders = []
for speed, seed in product(SPEEDS, SEEDS):
    folder = f"{FOLDER}/{speed}-{seed}"
    settings = {**SETTINGS, "vessel/carriage/@speed": speed}
    until = SETTINGS["vessel/carriage/@ramp"] + DISTANCE / speed
    try:
        run = nilas.run(SCENE, out=folder, settings=settings, seed=seed, until=until, force=True)
        print(run)
        folders.append(run.folder)
    except nilas.Failed as failure:
        print(failure)

# %% [markdown]
# ## All runs in one table
# `frame` has the attributes in which the scenes differ, and the main figures of each run.

# %%
runs = nilas.runs(folders)
frame = runs.frame
print(frame[["seed/@value", "vessel/carriage/@speed", "ice_load.along.mean_N"]].round(3))

# %% [markdown]
# ## Mean over the ice fields, and how sure it is
# The fields of one speed are independent. Their scatter gives the standard error of the mean.

# %%
by_speed = frame.groupby("vessel/carriage/@speed")["ice_load.along.mean_N"]
table = by_speed.agg(["mean", "sem", "count"])
print(table.round(3))

figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
axes.plot(
    frame["vessel/carriage/@speed"],
    frame["ice_load.along.mean_N"],
    "o",
    color="0.6",
    label="one ice field each",
)
axes.errorbar(
    table.index,
    table["mean"],
    yerr=np.nan_to_num(table["sem"]),
    fmt="s-",
    color="C0",
    capsize=4,
    label="mean with its standard error",
)
axes.set_xlabel("speed of the carriage [m/s]")
axes.set_ylabel("mean ice load astern [N]")
axes.set_title(f"{len(runs)} tows of {DISTANCE:g} m and a ramp")
axes.legend()
picture = f"{FOLDER}/sweep.png"
figure.savefig(picture, dpi=120)
print("The picture is", picture)
