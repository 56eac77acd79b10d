#!/usr/bin/env python3
"""Runs small scenes for up to a million steps each, and judges what only shows over many steps.

usage: long_runs.py [--steps N] [--scenes NAME ...] [--sessions K] [--resumed-only] [--out FOLDER]
                    [--program FILE]

The scenes stand beside this script. While a run goes on, its resident memory and the sizes of its files are noted. At
its end these must hold: every row of steps.csv and vessel.csv is there, each time is the start plus step times number
to the last bit, the ledger of energy and the balance of momentum close, the counts of the summary are those of the
table, files with a row per step grow as fast in the second half of the run as in the first, and memory stays as it is
in the second half. The same scene is then run in K sessions, each of which resumes the one before, and must give the
same bits. With --resumed-only it is run in sessions alone, and these are judged, memory and growth over the last one. A
scene ends at its own end at the latest.

FOLDER/long.csv has a row per scene, FOLDER/NAME.csv what was noted on the way. The exit code is 1 where something does
not hold.
"""
import argparse
import csv
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree as ET
from dataclasses import dataclass, field
from pathlib import Path
from typing import Iterator

sys.dont_write_bytecode = True  # leaves no folder beside the sources
HERE = Path(__file__).resolve().parent
REPOSITORY = HERE.parents[1]
sys.path.insert(0, str(HERE))
from watch import Sample, growth, sample  # noqa: E402  (they stand beside this script)
from judge import Verdict, judge_rows, same_bits  # noqa: E402

PER_STEP = ("steps.csv", "vessel.csv")  # tables with a row per step
SAMPLES = 200            # on the way through a run
LARGEST_RATIO = 1.25     # of the growth in the second half to that in the first
STEADY_MB = 2.0          # growth of memory in the second half that is no growth


@dataclass
class Scene:
    """A scene with its own step and start, for a number of steps."""

    path: Path
    steps: int
    step: float = field(init=False)
    start: float = field(init=False)

    def __post_init__(self) -> None:
        time_of = ET.parse(self.path).getroot().find("time")
        assert time_of is not None
        self.step, self.start = float(time_of.get("step", "")), float(time_of.get("start", "0"))
        self.steps = min(self.steps, round((float(time_of.get("end", "")) - self.start) / self.step))

    def time_after(self, steps: int) -> float:
        """The time after so many steps, counted as the program counts it [s]."""
        return self.start + steps * self.step

    def until(self, steps: int) -> str:
        """The flag that ends a run there."""
        return repr(self.time_after(steps))


def watched(command: list[str], folder: Path, scene: Scene) -> tuple[int, list[Sample], str]:
    """Runs a command to its end; gives its exit code, what was noted on the way, and what it said."""
    samples: list[Sample] = []
    with (folder.parent / f"{folder.name}.log").open("w+", encoding="utf-8") as said:
        with subprocess.Popen(command, stdout=said, stderr=said) as child:
            while child.poll() is None:
                found = sample(child.pid, folder, scene.start, scene.step)
                if found and (not samples or found.steps >= samples[-1].steps + scene.steps // SAMPLES):
                    samples.append(found)
                time.sleep(0.05 if not samples else 0.5)
        said.seek(0)
        return child.returncode, samples, said.read()


def write_samples(path: Path, samples: list[Sample]) -> None:
    """Stores what was noted on the way."""
    names = sorted({name for found in samples for name in found.bytes})
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["step", "resident_B", *(f"{name}_B" for name in names)])
        for found in samples:
            writer.writerow([found.steps, found.resident, *(found.bytes.get(name, "") for name in names)])


def faults_of_growth(samples: list[Sample]) -> tuple[dict[str, object], Iterator[str]]:
    """Figures of memory and files over the steps, and what is wrong with them."""
    memory = growth([(found.steps, float(found.resident)) for found in samples])
    files = growth([(found.steps, float(sum(found.bytes.values()))) for found in samples])
    rows = growth([(found.steps, float(sum(found.bytes[name] for name in PER_STEP))) for found in samples])
    figures = {
        "memory_first_MB": f"{memory.first / 1e6:.1f}",
        "memory_last_MB": f"{memory.last / 1e6:.1f}",
        "memory_B_per_step": f"{memory.second_half:.1f}",
        "output_MB": f"{files.last / 1e6:.1f}",
        "output_B_per_step": f"{files.second_half:.1f}",
        "rows_halves_1": f"{rows.ratio:.3f}",
    }

    def wrong() -> Iterator[str]:
        if rows.ratio > LARGEST_RATIO:
            yield f"its tables grow {rows.ratio:.2f} times as fast in the second half of the run as in the first"
        if memory.second_half * memory.steps / 2 > 1e6 * STEADY_MB:
            yield f"its memory grows by {memory.second_half:.0f} B with each step in the second half of the run"

    return figures, wrong()


def in_sessions(program: Path, scene: Scene, folder: Path, sessions: int) -> tuple[str, list[Sample]]:
    """Runs the scene anew in sessions that resume one another; gives what went wrong, and what was noted in the last one."""
    every = scene.steps // sessions
    first = [str(program), "run", str(scene.path), "--out", str(folder), "--quiet", "--checkpoint-every",
             repr(every * scene.step), "--until", scene.until(every)]
    samples: list[Sample] = []
    for session in range(1, sessions + 1):
        last = scene.until(scene.steps if session == sessions else session * every)
        command = first if session == 1 else [str(program), "run", "--resume", str(folder), "--quiet", "--until", last]
        code, found, said = watched(command, folder, scene)
        samples = found
        if code != 0:
            return f"session {session} ended with exit code {code}: {said.strip()[:300]}", samples
    return "", samples


def judged(folder: Path, scene: Scene, samples: list[Sample]) -> tuple[dict[str, object], list[str]]:
    """Figures of a run that ended, and what does not hold of it. Stores what was noted on the way."""
    write_samples(folder.parent / f"{folder.name}.csv", samples)
    rows: Verdict = judge_rows(folder, scene.steps, scene.time_after)
    figures, growing = faults_of_growth(samples)
    return {"steps": scene.steps, **rows.figures, **figures}, [*rows.faults, *growing]


def run_in_sessions(program: Path, scene: Scene, out: Path, sessions: int) -> tuple[dict[str, object], list[str]]:
    """The run in sessions alone; gives its row of the table, and what does not hold."""
    name = scene.path.stem
    folder = out / name
    shutil.rmtree(folder, ignore_errors=True)
    wrong, samples = in_sessions(program, scene, folder, sessions)
    if wrong:
        return {"scene": name}, [wrong]
    figures, faults = judged(folder, scene, samples)
    return {"scene": name, **figures, "resumed": f"in {sessions} sessions alone"}, faults


def run_scene(program: Path, scene: Scene, out: Path, sessions: int) -> tuple[dict[str, object], list[str]]:
    """All runs of a scene; gives its row of the table, and what does not hold."""
    name = scene.path.stem
    whole, resumed = out / name, out / f"{name}-resumed"
    for folder in (whole, resumed):
        shutil.rmtree(folder, ignore_errors=True)
    command = [str(program), "run", str(scene.path), "--out", str(whole), "--quiet", "--until", scene.until(scene.steps)]
    code, samples, said = watched(command, whole, scene)
    if code != 0:
        return {"scene": name}, [f"exit code {code}: {said.strip()[:300]}"]
    figures, faults = judged(whole, scene, samples)
    again = "not run"
    if sessions > 1:
        again = in_sessions(program, scene, resumed, sessions)[0] or same_bits(whole, resumed)
        faults += [again] if again else []
        again = again or f"same bits in {sessions} sessions"
    return {"scene": name, **figures, "resumed": again}, faults


def main() -> int:
    """Runs the scenes of the command line; gives the exit code."""
    names = sorted(path.stem for path in (HERE / "scenes").glob("*.xml"))
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--steps", type=int, default=1_000_000, help="steps of each run; default: a million")
    parser.add_argument("--scenes", nargs="+", choices=names, default=names, help="scenes to run; default: all")
    parser.add_argument("--sessions", type=int, default=10, help="sessions of the resumed run, 1: none; default: 10")
    parser.add_argument("--resumed-only", action="store_true",
                        help="runs each scene in sessions alone, and judges these")
    parser.add_argument("--out", type=Path, default=REPOSITORY / "runs" / "long", help="folder of the runs and tables")
    parser.add_argument("--program", type=Path, default=REPOSITORY / "build" / "release" / "nilas",
                        help="program under test")
    options = parser.parse_args()
    out = options.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    rows: list[dict[str, object]] = []
    failed = False
    for name in options.scenes:
        scene = Scene(HERE / "scenes" / f"{name}.xml", options.steps)
        run = run_in_sessions if options.resumed_only else run_scene
        row, faults = run(options.program.resolve(), scene, out, options.sessions)
        row["holds"] = "; ".join(faults) or "yes"
        failed = failed or bool(faults)
        rows.append(row)
        print(", ".join(f"{key} {value}" for key, value in row.items()), flush=True)
        columns = list(dict.fromkeys(key for one in rows for key in one))
        with (out / "long.csv").open("w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, columns, lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
