"""The commands that are tried: what each starts from, does and leaves."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from contents import difference, half_files, hashes, status, table
from interpose import Ended, Plan, Runner

SCENES = Path(__file__).resolve().parent / "scenes"
_DONE, _BAD_INPUT, _FILE = 0, 2, 4


@dataclass
class Bench:
    """A folder with the scene, and a program to run in it."""

    folder: Path
    program: Path
    runner: Runner

    def words(self, text: str) -> list[str]:
        return [str(self.program), *text.split()]

    def demand(self, text: str) -> None:
        ended = self.runner.plainly(self.words(text))
        if ended.code != _DONE:
            raise SystemExit(f"{text}: exit code {ended.code}: {ended.err}")

    def put_back(self, name: str, stored: Path | None) -> None:
        """Puts an output folder into the state before the command: as stored, or absent."""
        shutil.rmtree(self.folder / name, ignore_errors=True)
        if stored is not None:
            shutil.copytree(stored, self.folder / name)


@dataclass
class Command:
    """A command under trial.

    ``before``: the stored state of its output folder, if there is one. ``mend``: repeats or
    resumes the command without a fault, and returns what is wrong with it. ``judge``: what is
    wrong with the outputs as they stand, for an exit code of 0 (True) or another.
    """

    name: str
    words: str
    out: str
    before: Path | None
    mend: Callable[[], str]
    judge: Callable[[bool], str]
    files: set[str] = field(default_factory=set)  # names of the files that it reads and writes


def _same_run(bench: Bench, run: Path, reference: Path) -> str:
    if hashes(run) != hashes(reference):
        return "the hashes of the states differ"
    return difference(run, reference)


def _mend_run(bench: Bench, reference: Path, forced: bool) -> str:
    """Resumes a run; where there is nothing to resume it begins again, as the message says.

    ``forced``: it may need --force for that, as after a loss of power, which takes the log too.
    """
    run = bench.folder / "run"
    had_checkpoint = (run / "checkpoint.h5").exists()
    ended = bench.runner.plainly(bench.words("run --resume run --quiet"))
    if ended.code == _FILE and not (run / "scene.xml").exists() and not had_checkpoint:
        ended = bench.runner.plainly(bench.words("run ship.xml --out run --quiet"))
        if ended.code == _BAD_INPUT and forced and "--force" in ended.err:
            ended = bench.runner.plainly(bench.words("run ship.xml --out run --quiet --force"))
    if ended.code != _DONE:
        return f"cannot be continued, exit code {ended.code}: {ended.err.strip()}"
    return _same_run(bench, run, reference)


def _judge_run(bench: Bench, reference: Path, done: bool) -> str:
    run = bench.folder / "run"
    if done:
        return _same_run(bench, run, reference)
    if status(run) == "done" and difference(run, reference):
        return "summary.json says done"
    return half_files(run, reference)


def run_command(bench: Bench, store: Path) -> Command:
    """A run from its beginning."""
    bench.demand("run ship.xml --out run --quiet")
    reference = store / "run"
    shutil.move(bench.folder / "run", reference)
    return Command(
        "run",
        "run ship.xml --out run --quiet",
        "run",
        None,
        lambda: _mend_run(bench, reference, not (bench.folder / "run/nilas.log").exists()),
        lambda done: _judge_run(bench, reference, done),
    )


def resume_command(bench: Bench, store: Path) -> Command:
    """A run that goes on after it was killed between its second checkpoint and its end."""
    whole = run_command(bench, store / "whole")
    calls = bench.runner.run(bench.words(whole.words)).calls["change"]
    bench.put_back("run", None)
    bench.runner.run(bench.words(whole.words), Plan("change", calls * 9 // 10, "kill"))
    stopped = store / "stopped"
    shutil.move(bench.folder / "run", stopped)
    if not (stopped / "checkpoint.h5").exists() or (stopped / "summary.json").exists():
        raise SystemExit("The run to resume was not stopped between a checkpoint and its end.")
    return Command("resume", "run --resume run --quiet", "run", stopped, whole.mend, whole.judge)


def report_command(bench: Bench, store: Path) -> Command:
    """The report of a run, with pictures for papers."""
    bench.demand("run ship.xml --out run --quiet")
    stored = store / "run"
    shutil.move(bench.folder / "run", stored)
    bench.put_back("run", stored)
    words = "report run"
    bench.demand(words)
    page = (bench.folder / "run/report.html").read_bytes()

    def judge(done: bool) -> str:
        file = bench.folder / "run/report.html"
        if file.exists() and file.read_bytes() != page and not _names_a_gap(file):
            return "report.html is not that of a report that did not fail"
        if done and not file.exists():
            return "there is no report.html"
        file.unlink(missing_ok=True)
        for part in (bench.folder / "run").glob("*.part"):
            part.unlink()
        return difference(bench.folder / "run", stored)

    def mend() -> str:
        ended = bench.runner.plainly(bench.words(words))
        return ended.err if ended.code != _DONE else judge(True)

    return Command("report", words, "run", stored, mend, judge)


def _names_a_gap(page: Path) -> bool:
    """Whether a report says that it leaves something out, since a file cannot be read."""
    text = page.read_text()
    return "</html>" in text and re.search(r"cannot (be )?(read|open)|is no file|is not in the folder|cut, damaged", text) is not None


def _compared(out: Path) -> object:
    """What a comparison found, without times."""
    loads = table(out / "loads.csv", "wall|cpu|computing|_s_per_s|_ms")
    runs = {}
    for file in sorted((out / "results").glob("*.json")):
        result = json.loads(file.read_text())
        runs[file.stem] = (result.get("status"), result.get("loads"), result.get("ice_load"))
    return loads, runs


def compare_command(bench: Bench, store: Path) -> Command:
    """A comparison of two solvers, one run at a time."""
    words = (
        "compare ship.xml --out compared --budget 0 --seeds 1 --solvers auto,nsgs --until 0.1 "
        "--jobs 1 --quiet"
    )
    bench.demand(words)
    out = bench.folder / "compared"
    reference = _compared(out)

    def judge(done: bool) -> str:
        if done:
            return "" if _compared(out) == reference else "the comparison found something else"
        for file in out.rglob("*.json"):
            try:
                json.loads(file.read_text())
            except ValueError:
                return f"{file.relative_to(out)} is no JSON"
        return ""

    def mend() -> str:
        ended = bench.runner.plainly(bench.words("compare --resume compared --budget 0 --quiet"))
        if ended.code in (_FILE, _BAD_INPUT) and _has_no_plan(out):
            ended = bench.runner.plainly(bench.words(words + " --force"))
        if ended.code != _DONE:
            return f"cannot be continued, exit code {ended.code}: {ended.err.strip()}"
        return judge(True)

    return Command("compare", words, "compared", None, mend, judge)


def _has_no_plan(out: Path) -> bool:
    try:
        return "plan" not in json.loads((out / "study.json").read_text())
    except (OSError, ValueError):
        return not (out / "study.json").exists()


def study_command(bench: Bench, store: Path) -> Command:
    """A study of two runs, one at a time, without its page."""
    words = "study study.yaml --out studied --quiet --no-page --no-check -j 1"
    bench.demand(words)
    out = bench.folder / "studied"
    reference = table(out / "study.csv")
    runs = store / "runs"
    shutil.copytree(out / "runs", runs)

    def judge(done: bool) -> str:
        if done:
            if table(out / "study.csv") != reference:
                return "study.csv differs"
            for record in sorted(runs.rglob("steps.csv")):
                folder = record.parent.relative_to(runs)
                if hashes(out / "runs" / folder) != hashes(runs / folder):
                    return f"the hashes of the states of {folder} differ"
            return ""
        for file in out.rglob("*.json"):
            try:
                json.loads(file.read_text())
            except ValueError:
                return f"{file.relative_to(out)} is no JSON"
        return ""

    def mend() -> str:
        ended = bench.runner.plainly(bench.words(words))
        if ended.code != _DONE:
            return f"cannot be continued, exit code {ended.code}: {ended.err.strip()}"
        return judge(True)

    return Command("study", words, "studied", None, mend, judge)


COMMANDS: dict[str, Callable[[Bench, Path], Command]] = {
    "run": run_command,
    "resume": resume_command,
    "compare": compare_command,
    "study": study_command,
    "report": report_command,
}


def bench_for(program: Path, library: Path, folder: Path) -> Bench:
    """A folder with the scenes of these tests and the hull that they name."""
    shutil.copytree(SCENES, folder)
    build = program.parent
    environment = {"NILAS_PROGRAM": str(program), "PYTHONDONTWRITEBYTECODE": "1"}
    environment |= {"PYTHONPATH": str(build / "python"), "OPENBLAS_NUM_THREADS": "1"}
    bench = Bench(folder, program, Runner(library, folder, environment))
    hull = "hull --generate icebreaker --length 3 --beam 0.8 --draught 0.2 --triangles 300"
    bench.demand(f"{hull} --out ship --quiet")
    return bench


def prepared(name: str, bench: Bench, store: Path) -> Command:
    """A command with the outputs that it is held against."""
    for folder in ("run", "compared", "studied"):
        bench.put_back(folder, None)
    (store / name).mkdir(parents=True)
    (store / name / "whole").mkdir()
    command = COMMANDS[name](bench, store / name)
    command.files = {path.name for path in [*bench.folder.rglob("*"), *store.rglob("*")]}
    return command


def carry_out(bench: Bench, command: Command, plan: Plan | None = None) -> Ended:
    """Runs a command from its beginning with a plan of failure."""
    bench.put_back(command.out, command.before)
    return bench.runner.run(bench.words(command.words), plan)
