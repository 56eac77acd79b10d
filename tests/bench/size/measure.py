#!/usr/bin/env python3
"""Measures what fields of many floes cost: time of each phase, memory, and bytes of output.

usage: measure.py PROGRAM CLOCK FOLDER FLOES ...     (through ./dev bench size)

PROGRAM is nilas, CLOCK the library processor_clock. Each field is a strip of broken ice, 20 floes deep and as long as
it takes, that drifts onto a wall. So the share of the floes that are jammed does not depend on the number. With
LAYOUT=closed it is a square of water that floes fill from wall to wall. The states of all bodies are stored at the
start and at the end. FOLDER/size.csv, or FOLDER/closed.csv, gets a row per field; what a run that fails has said goes
to standard error, and the exit code is then 1. Times are of the processor, on one thread.
"""
import csv
import os
import resource
import statistics
import subprocess
import sys
from pathlib import Path

STEPS = int(os.environ.get("STEPS", "6"))
LAYOUT = os.environ.get("LAYOUT", "strip")
NAME = "size" if LAYOUT == "strip" else LAYOUT
DEPTH = 20         # floes between sea and wall
FLOE = 10.0        # side of the square of water that each floe has [m]
CONCENTRATION = {"strip": 0.98, "closed": 1.0}[LAYOUT]
SPREAD = 0.3       # standard deviation of the floe size over its mean
SPEED = 0.5        # of the drift [m/s]
STEP = 0.1         # [s]
PHASES = ("detection", "assembly", "hydro", "solver", "integration", "output")


def scene(floes: int) -> str:
    """The scene of so many floes."""
    depth = DEPTH if LAYOUT == "strip" else round(floes ** 0.5)
    length, width = FLOE * depth, FLOE * round(floes / depth)
    mean = FLOE * (CONCENTRATION / (1 + SPREAD ** 2)) ** 0.5
    end = STEP * STEPS
    return f"""<scene version="1" name="{NAME}-{floes}">
  <time step="{STEP}" end="{end:.10g}"/>
  <contact solver="auto" tolerance="1e-4"><friction between="* *" kinetic="0.3"/></contact>
  <water><current velocity="{SPEED} 0 0"/></water>
  <hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <tank length="{length}" width="{width}" depth="50"/>
  <ice thickness="1">
    <field kind="voronoi" region="0 {-width / 2} {length} {width / 2}" concentration="{CONCENTRATION}"
           velocity="{SPEED} 0 0">
      <size distribution="lognormal" mean="{mean}" sd="{SPREAD * mean}" min="{0.3 * mean}" max="{3 * mean}"/>
    </field>
  </ice>
  <output trajectory_every="{end:.10g}" bodies="false"/>
</scene>
"""


def run(program: Path, clock: Path, folder: Path, floes: int) -> tuple[float, float]:
    """Runs the scene into a folder; gives the processor time [s] and the peak of the resident memory [B]."""
    file = folder / f"{NAME}-{floes}.xml"
    file.write_text(scene(floes), encoding="utf-8")
    command = [program, "run", file, "--out", folder / f"{NAME}-{floes}", "--force", "--quiet", "--threads", "1"]
    child = subprocess.Popen(command, env={**os.environ, "LD_PRELOAD": str(clock)})
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise RuntimeError(f"{floes} floes: exit code {child.returncode} after {used.ru_utime + used.ru_stime:.0f} s of "
                           f"processor time, with at most {used.ru_maxrss / 1e6:.2f} GB")
    return used.ru_utime + used.ru_stime, 1024.0 * used.ru_maxrss


def row(folder: Path, seconds: float, peak: float) -> dict[str, object]:
    """The figures of a finished run."""
    with (folder / "steps.csv").open(newline="", encoding="utf-8") as file:
        steps = list(csv.DictReader(file))
    floes = int(steps[-1]["floes"])
    ms = {phase: [float(step[f"ms_{phase}"]) for step in steps] for phase in PHASES}
    in_steps = sum(sum(times) for times in ms.values()) / 1e3
    # The first step prepares what later ones only update, and the last one stores a state.
    later = {phase: statistics.fmean(times[1:-1] if phase == "output" else times[1:]) for phase, times in ms.items()}
    states = sorted((folder / "trajectory").glob("step-*-ice.vtp"))
    missed = [step for step in steps if step["status"] != "converged"]
    return {
        "floes": floes,
        "contacts": steps[-1]["contacts"],
        "largest_contacts": max(int(step["contacts"]) for step in steps),
        "islands": steps[-1]["islands"],
        "start_s": round(seconds - in_steps, 2),
        **{f"first_{phase}_ms": round(ms[phase][0], 1) for phase in ("detection", "solver", "integration")},
        **{f"{phase}_ms": round(time, 2) for phase, time in later.items()},
        "state_ms": round(ms["output"][-1] - later["output"], 1),
        "step_us_per_floe": round(1e3 * sum(later.values()) / floes, 2),
        "residual_m_s": max((float(step["law_map_m_s"]) for step in steps if step not in missed), default=""),
        "short_steps": f"{len(missed)} of {len(steps)}",
        "short_residual_m_s": max((float(step["law_map_m_s"]) for step in missed), default=""),
        "peak_MB": round(peak / 1e6),
        "peak_kB_per_floe": round(peak / 1e3 / floes, 2),
        "vtp_B_per_floe": round(states[-1].stat().st_size / floes),
        "replay_B_per_floe": round((folder / "replay.bin").stat().st_size / len(states) / floes),
    }


def main() -> int:
    """Measures the sizes of the command line; gives the exit code."""
    if len(sys.argv) < 5:
        print(__doc__, file=sys.stderr)
        return 2
    program, clock, folder = (Path(word).resolve() for word in sys.argv[1:4])
    folder.mkdir(parents=True, exist_ok=True)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    rows, failed = [], False
    for floes in (int(float(word)) for word in sys.argv[4:]):
        try:
            seconds, peak = run(program, clock, folder, floes)
        except RuntimeError as failure:
            print(failure, file=sys.stderr)
            failed = True
            continue
        rows.append(row(folder / f"{NAME}-{floes}", seconds, peak))
        print(", ".join(f"{key} {value}" for key, value in rows[-1].items()), flush=True)
        with (folder / f"{NAME}.csv").open("w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
