#!/usr/bin/env python3
"""Maps how whole scenes end at the extremes of their sizes, steps, speeds, masses, friction and stiffness.

usage: extremes.py [--maps NAME ...] [--out FOLDER] [--program FILE]

Each map is a grid of two quantities over one scene. A run is `converged`; `short`, where the solver or the correction
of positions missed its tolerance, and warning or summary say so; or `refused`, with a message. Anything else is a
fault: a number that is not finite, an account that stays open, a shortfall or a deep overlap that nothing tells of, a
crash, or no end. FOLDER/extremes.csv has a row per cell and maps.csv one per row of a map. The exit code is 1 where
there is a fault.
"""
import argparse
import csv
import sys
import xml.etree.ElementTree as ET
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Sequence

sys.dont_write_bytecode = True  # leaves no folder beside the sources
sys.path.insert(0, str(Path(__file__).resolve().parent))
from accounts import energy, momentum, newton  # noqa: E402  (they stand beside this script)
from case import Case  # noqa: E402
from draw import add  # noqa: E402
from generate.scene import RandomScene  # noqa: E402
from judges import finite, honest  # noqa: E402
from program import Program  # noqa: E402

REPOSITORY = Path(__file__).resolve().parents[2]
STEPS = 20
LARGEST_SCENE_SECONDS = 1800.0  # of processor time, for 1e5 floes
# A body may overlap another by half the thinner one's thickness before it counts as deep.
DEEP = 0.5


@dataclass
class Map:
    """A grid of two quantities; scene gives the scene of a cell."""

    rows: str
    row_values: Sequence[float]
    columns: str
    column_values: Sequence[float]
    scene: Callable[[float, float], ET.Element]
    thickness: Callable[[float, float], float]  # of the thinnest body [m]


def _scene(step: float, steps: int, tolerance: float | None, friction: float = 0.3) -> ET.Element:
    scene = ET.Element("scene", version="1")
    add(scene, "time", step=step)
    scene[0].set("end", f"{step * steps:.10g}")
    contact = add(scene, "contact", tolerance=tolerance)
    add(contact, "friction", between="* *", static=friction)
    return scene


def _ice(scene: ET.Element, thickness: float, size: float, count: int, speed: float) -> None:
    """Square floes in rows that touch, with water, drifting onto a fixed pier as wide as one of them."""
    rows = max(1, round(count ** 0.5))
    columns = max(1, round(count / rows))
    add(scene, "water")
    hydro = add(scene, "hydro")
    add(hydro, "buoyancy")
    add(hydro, "drag")
    ice = add(scene, "ice", thickness=thickness)
    add(ice, "field", kind="grid", rows=rows, columns=columns, gap=1e-3 * size, velocity=[-speed, 0.0, 0.0],
        region=[0.0, -rows * size / 2, columns * size, rows * size / 2])
    add(scene, "body", name="pier", fixed=True, size=[size, size, 4 * thickness], position=[-0.502 * size, 0.0, 0.0])
    add(scene, "output", trajectory_every=0.0, bodies=False)


def thickness_and_size(thickness: float, size: float) -> ET.Element:
    """Sixteen floes at 0.1 body lengths per second, with the step of their size by Froude's law."""
    scene = _scene(0.01 * max(size, 1e-2) ** 0.5, STEPS, None)
    _ice(scene, thickness, size, 16, 0.1 * size)
    return scene


def step_and_speed(step: float, speed: float) -> ET.Element:
    """Sixteen floes of 1 m, 0.1 m thick."""
    scene = _scene(step, STEPS, None)
    _ice(scene, 0.1, 1.0, 16, speed)
    return scene


def friction_and_mass(friction: float, ratio: float) -> ET.Element:
    """A heavy box on three light ones on a floor; the column moves along the floor."""
    scene = _scene(0.005, STEPS, 1e-8, friction)
    add(scene, "body", shape="plane", name="floor")
    for place in range(4):
        add(scene, "body", size=[1.0, 1.0, 0.5], mass=1.0 if place < 3 else float(ratio),
            position=[0.0, 0.0, 0.25 + 0.5 * place],
            velocity=[1.0, 0.2, 0.0])
    add(scene, "output", trajectory_every=0.0, bodies=False)
    return scene


def number_and_speed(count: float, speed: float) -> ET.Element:
    """Floes of 1 m, 0.1 m thick; a tenth of the steps for the largest numbers, whose steps take seconds."""
    scene = _scene(0.01, STEPS if count <= 1000 else 3, None)
    _ice(scene, 0.1, 1.0, int(count), speed)
    return scene


def stiffness_and_step(stiffness: float, step: float) -> ET.Element:
    """A model of 6 m on six cells, towed at 0.3 m/s into broken ice at its bow."""
    scene = _scene(step, STEPS, None, 0.1)
    add(scene, "water")
    hydro = add(scene, "hydro")
    add(hydro, "buoyancy")
    add(hydro, "drag")
    vessel = add(scene, "vessel", position=[0.0, 0.0])
    add(vessel, "hull", length=6.0, triangles=800)
    add(vessel, "mass", draught=0.35)
    carriage = add(vessel, "carriage", speed=0.3, free="heave")
    add(carriage, "force_balance", kind="six-cells", stiffness=stiffness)
    ice = add(scene, "ice", thickness=0.04)
    add(add(ice, "field", kind="packed", region=[5.0, -1.5, 8.0, 1.5], concentration=0.7), "size", mean=0.5, sd=0.1,
        min=0.3, max=0.8)
    add(scene, "output", trajectory_every=0.0, bodies=False)
    return scene


MAPS = {
    "thickness": Map("thickness [m]", (1e-3, 1e-2, 0.1, 1, 10), "floe [m]", (0.01, 0.1, 1, 10, 100, 1e3, 1e4),
                     thickness_and_size, lambda t, _: t),
    "step": Map("step [s]", (1e-5, 1e-4, 1e-3, 1e-2, 0.05, 0.2), "speed [m/s]", (0.01, 0.1, 1, 5, 20), step_and_speed,
                lambda *_: 0.1),
    "friction": Map("friction", (0, 0.1, 0.5, 1, 2, 5), "mass ratio", (1, 1e2, 1e4, 1e6, 1e8), friction_and_mass,
                    lambda *_: 0.5),
    "floes": Map("floes", (1, 10, 100, 1e3, 1e4, 1e5), "speed [m/s]", (0.1, 5), number_and_speed, lambda *_: 0.1),
    "cells": Map("stiffness [N/m]", (1e3, 1e5, 1e7, 1e9, 1e12), "step [s]", (1e-5, 1e-3, 1e-2, 0.05, 0.2),
                 stiffness_and_step, lambda *_: 0.04),
}


def verdict(case: Case, thickness: float) -> tuple[str, str]:
    """How a run ended, and why it is a fault or short."""
    run = case.base
    if run.code is None:
        return "fault", "it does not end"
    if run.code in (2, 3) and run.error() and "report" not in run.error():
        return "refused", run.error().split("\n")[0]
    if run.code != 0:
        return "fault", f"exit code {run.code}: {run.error()[:200]}"
    for judge in (finite, honest, energy, momentum, newton):
        sentence = judge(case)
        if sentence:
            return "fault", sentence
    shortfalls = run.summary["shortfalls"]
    short = [f"{shortfalls[key]} {key.replace('_', ' ')}" for key in ("unconverged_steps",
                                                                      "uncorrected_steps") if shortfalls[key]]
    if short:
        # Steps above the tolerance have a warning; those whose positions were not corrected stand in the summary.
        told = not shortfalls["unconverged_steps"] or "the contact solver left a residual" in run.said
        return ("short" if told else "fault"), " and ".join(short) + ("" if told else ", without a warning")
    depth = run.summary["worst"]["penetration_max_m"]["value"]
    if depth > DEEP * thickness:
        return "fault", f"bodies of {thickness:g} m overlap by {depth:.3g} m although every step converged"
    return "converged", ""


def _grouped(ends: Sequence[str]) -> str:
    """The ends of a row, equal neighbours as one: `converged` x 3, refused."""
    groups: list[tuple[str, int]] = []
    for end in ends:
        if groups and groups[-1][0] == end:
            groups[-1] = (end, groups[-1][1] + 1)
        else:
            groups.append((end, 1))
    return ", ".join(end if count == 1 else f"{end} x {count}" for end, count in groups)


def fill(name: str, integrator: str, program: Program, folder: Path) -> tuple[list[tuple[object, ...]],
                                                                              list[tuple[object, ...]]]:
    """Runs a map; gives its cells and its rows."""
    of = MAPS[name]
    cells: list[tuple[object, ...]] = []
    rows: list[tuple[object, ...]] = []
    for row in of.row_values:
        ends = []
        for column in of.column_values:
            scene = of.scene(row, column)
            scene.find("contact").set("integrator", integrator)  # type: ignore[union-attr]
            end, why = verdict(Case(program, RandomScene(scene, {}), folder), of.thickness(row, column))
            cells.append((name, integrator, of.rows, f"{row:g}", of.columns, f"{column:g}", end, why))
            ends.append(end)
            if why:
                print(f"{name}, {integrator}, {of.rows} {row:g}, {of.columns} {column:g}: {end}: {why}", flush=True)
        values = " ".join(f"{value:g}" for value in of.column_values)
        rows.append((name, integrator, of.rows, f"{row:g}", f"{of.columns}: {values}", _grouped(ends)))
    return cells, rows


def _write(path: Path, header: Sequence[str], rows: Sequence[Sequence[object]]) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def main() -> int:
    """Fills the maps that the command line names; gives the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--maps", nargs="+", choices=tuple(MAPS), default=list(MAPS), help="maps to fill; default: all")
    parser.add_argument("--out", type=Path, default=REPOSITORY / "runs" / "extreme-scenes",
                        help="folder of the tables and the last scene")
    parser.add_argument("--program", type=Path, default=REPOSITORY / "build" / "release" / "nilas",
                        help="program under test")
    options = parser.parse_args()
    out = options.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    program = Program(options.program, seconds=LARGEST_SCENE_SECONDS)
    cells: list[tuple[object, ...]] = []
    rows: list[tuple[object, ...]] = []
    for name in options.maps:
        for integrator in ("moreau", "semi-implicit-euler"):
            new_cells, new_rows = fill(name, integrator, program, out / "at-work")
            cells += new_cells
            rows += new_rows
            _write(out / "extremes.csv", ("scene", "integrator", "row", "row_value", "column", "column_value", "ends",
                                          "why"), cells)
            _write(out / "maps.csv", ("scene", "integrator", "row", "row_value", "columns", "ends"), rows)
            for row in new_rows:
                print(*row, sep=", ", flush=True)
    ends = [str(cell[-2]) for cell in cells]
    print(", ".join(f"{ends.count(end)} {end}" for end in ("converged", "short", "refused", "fault")))
    return 1 if "fault" in ends else 0


if __name__ == "__main__":
    sys.exit(main())
