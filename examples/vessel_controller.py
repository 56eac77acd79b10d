# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
# ---

# %% [markdown]
# # A controller for a vessel
#
# A free vessel shall keep its speed and its heading in broken ice. Our controller measures both
# before each step and applies a force and a moment. This needs the compiled part of the package.
# Run it from the top of the source tree.

# %%
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import nilas

SCENE = "examples/free-vessel.xml"
SECONDS = 15
SPEED = 0.3  # wanted [m/s]
HEADING = np.radians(3)  # wanted [rad]
FOLDER = Path("runs/examples/controller")

# %% [markdown]
# ## The controller
# Speed: proportional and integral. Heading: proportional and derivative. The gains follow from the
# mass of the vessel and from the time in which it shall answer.


# %%
class Controller:
    def __init__(self, mass, length, answer=2.0):
        inertia = mass * (0.25 * length) ** 2
        self.speed_gain = mass / answer  # [N s/m]
        self.heading_gain = inertia / answer**2  # [N m/rad]
        self.turn_gain = 2 * inertia / answer  # [N m s/rad]
        self.answer = answer
        self.sum = 0.0  # of the speed error over time [m]
        self.before = 0.0
        self.rows = []

    def __call__(self, simulation):
        bodies, ship = simulation.bodies, simulation.vessel
        w, x, y, z = bodies.orientation[ship]
        heading = np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
        ahead = np.array([np.cos(heading), np.sin(heading), 0])
        speed = bodies.velocity[ship] @ ahead
        self.sum += (SPEED - speed) * (simulation.time - self.before)
        self.before = simulation.time
        force = self.speed_gain * ((SPEED - speed) + 0.5 * self.sum / self.answer)
        moment = self.heading_gain * (HEADING - heading)
        moment -= self.turn_gain * bodies.angular_velocity[ship][2]
        simulation.apply(ship, force=force * ahead, torque=[0, 0, moment])
        self.rows.append((simulation.time, speed, np.degrees(heading), force, moment))


# %% [markdown]
# ## The run
# `run` calls the controller before each step. With `folder` the run can be read and drawn later.

# %%
simulation = nilas.Simulation(SCENE, applied_loads=True, folder=FOLDER, force=True)
mass = simulation.bodies.mass[simulation.vessel]
controller = Controller(mass, length=6.0)
with simulation:
    simulation.run(until=SECONDS, callback=controller)
ice = -simulation.vessel_table()["ice_resistance_N"]
print(f"{mass:.0f} kg, {simulation.steps} steps")

# %%
time, speed, heading, force, moment = np.array(controller.rows).T
smooth = ice.rolling(max(1, round(0.5 * len(time) / SECONDS)), center=True, min_periods=1).mean()
figure, axes = plt.subplots(3, 1, sharex=True, figsize=(8, 6.5), layout="constrained")
axes[0].plot(time, speed)
axes[0].axhline(SPEED, color="0.5", linestyle="--")
axes[0].set_ylabel("speed [m/s]")
axes[1].plot(time, heading)
axes[1].axhline(np.degrees(HEADING), color="0.5", linestyle="--")
axes[1].set_ylabel("heading [deg]")
axes[2].plot(time, force, label="thrust of the controller")
axes[2].plot(smooth.index, smooth, label="ice, mean over 0.5 s")
axes[2].set_ylabel("force ahead [N]")
axes[2].set_xlabel("time [s]")
axes[2].legend()
figure.suptitle("A vessel that a controller drives through broken ice")
figure.savefig(FOLDER / "controller.png", dpi=120)
print("The picture is", FOLDER / "controller.png")
