# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
# ---

# %% [markdown]
# # A first tow and its plot
#
# A model icebreaker is towed through broken ice. We run the scene, read the load on the hull and
# plot it. Run this from the top of the source tree: `python3 examples/first_tow.py`.

# %%
import matplotlib.pyplot as plt

import nilas

SCENE = "apps/scenes/towing.xml"
SECONDS = 10
FOLDER = "runs/examples/first-tow"

# %% [markdown]
# `nilas.run` does what `nilas run` does on the command line, and returns the run.
# It takes half a minute on a free core.

# %%
run = nilas.run(SCENE, out=FOLDER, until=SECONDS, force=True)
print(run)

# %% [markdown]
# ## What the program found
# The mean load has an interval of about 95 %. It covers chance, rounding and the solver in this one
# ice field, and no other field.

# %%
start, end = run.window
along = run.loads.loc["ice_resistance_N"]
print(f"ice load from {start:g} s to {end:g} s: {along['mean']:.1f} N +- {along['error']:.1f} N")
print(run.loads.loc[["ice_resistance_N", "ice_side_N", "carriage_fx_N"]].round(2))

# %% [markdown]
# ## The load over time
# A table has a row per step and the time as its index, so `loc` cuts a window of time out.
# The load jumps from step to step, as rigid contacts do. Its mean over 0.2 s shows more.

# %%
vessel = run.vessel
load = vessel["ice_resistance_N"]
step = vessel.index[1] - vessel.index[0]
smooth = load.rolling(max(1, round(0.2 / step)), center=True).mean()

figure, (upper, lower) = plt.subplots(2, 1, sharex=True, figsize=(8, 5), layout="constrained")
upper.plot(load.index, load, color="0.75", linewidth=0.6, label="each step")
upper.plot(smooth.index, smooth, color="C0", label="mean over 0.2 s")
upper.hlines(along["mean"], start, end, color="C3", linestyle="--", label="mean of the window")
if smooth.max() > 0:
    upper.set_ylim(min(0, 1.2 * smooth.min()), 2 * smooth.max())
upper.set_ylabel(f"ice load astern [{run.units('vessel')['ice_resistance_N']}]")
upper.legend(loc="upper left", ncols=3, fontsize="small")
contacts = run.steps["contacts"]
lower.plot(contacts.index, contacts, color="C2")
lower.set_ylabel("contacts [1]")
lower.set_xlabel("time [s]")
figure.suptitle(f"{run.summary['scene']}: load of the ice on the hull")
figure.savefig(run.folder / "first-tow.png", dpi=120)
print("The picture is", run.folder / "first-tow.png")
