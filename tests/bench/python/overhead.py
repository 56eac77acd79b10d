"""What a step costs more in Python than the step itself, what callbacks cost, and whether memory grows.

usage: overhead.py [SCENE [SECONDS]]      with the package on PYTHONPATH; by default apps/scenes/towing.xml to 3 s
"""

import resource
import statistics
import sys
import time
from pathlib import Path

import nilas

ROOT = Path(__file__).parents[3]
BALLS = """<scene version="1" name="balls"><time step="0.01" end="2000"/>
<contact integrator="semi-implicit-euler"/><body name="ground" shape="plane" fixed="true"/>
<body name="one" shape="sphere" radius="0.1" mass="2" position="0 0 0.3"/></scene>"""


def timed_steps(simulation, until, callback=None):
    """Wall times of the steps, and the times that the phases of these steps took [s]."""
    walls, inner = [], []
    names = [k for k, name in enumerate(simulation._core.step_columns) if name.startswith("ms_")]
    while simulation.time < until:
        begin = time.perf_counter()
        if callback is not None:
            callback(simulation)
        step = simulation.step()
        walls.append(time.perf_counter() - begin)
        inner.append(1e-3 * sum(step.numbers[names]))
    return walls, inner


def steps_of(scene, until):
    """Prints what Python adds to a step, without and with a callback."""

    def look(simulation):
        simulation.apply(0, simulation.bodies.velocity[0] * 0)

    def brief(simulation):
        end = time.perf_counter() + 1e-5
        while time.perf_counter() < end:
            pass

    rows = (
        ("no callback", None),
        ("a callback of 10 microseconds", brief),
        ("a callback that reads all bodies and applies a load", look),
    )
    for name, callback in rows:
        simulation = nilas.Simulation(scene, applied_loads=callback is not None)
        walls, inner = timed_steps(simulation, until, callback)
        added = [1e6 * (wall - step) for wall, step in zip(walls, inner)]
        share = 100 * (sum(walls) - sum(inner)) / sum(walls)
        print(
            f"{name}: {len(walls)} steps of {len(simulation.bodies.mass)} bodies, median {1e3 * statistics.median(walls):.2f} ms; "
            f"beside its phases a step takes {statistics.median(added):.0f} microseconds in the median, {share:.1f} % of all"
        )


def memory_of(steps, keep_table):
    """Prints how memory grows over many steps."""
    simulation = nilas.Simulation(nilas.Scene.parse(BALLS), applied_loads=True, keep_table=keep_table)
    used = []
    begin = time.perf_counter()
    for k in range(steps):
        simulation.apply(1, [0, 0, 0.1])
        simulation.bodies
        simulation._core.step()
        if k + 1 in (steps // 10, steps):
            used.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
    kept = len(simulation._core.step_columns) * steps * 8 / 1024 if keep_table else 0
    print(
        f"{steps} steps of two bodies in {time.perf_counter() - begin:.1f} s: {used[0]} kB after a tenth, {used[1]} kB at the end; "
        f"the table of the steps takes {kept:.0f} kB of it"
    )


if __name__ == "__main__":
    scene = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "apps/scenes/towing.xml"
    steps_of(scene, float(sys.argv[2]) if len(sys.argv) > 2 else 3.0)
    for keep_table in (False, True):  # the greatest memory of a process never falls
        memory_of(100000, keep_table)
