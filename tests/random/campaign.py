"""Counts what judges say of many scenes, and writes the tables."""
import csv
import shutil
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from case import Case
from generate.scene import random_scene
from judges import JUDGES
from program import Program
from refusals import documented, page_of
from schema import Coverage, Schema
from shrink import Shrinker, kind_of

# These judges need runs of their own of nearly every scene. In a brief campaign a scene gets one of them in turn.
IN_TURN = ("check", "again", "threads", "resumed")
COMMANDS = {"again": "`nilas run scene.xml --out one` and `nilas run one/scene.xml --out two`",
            "threads": "`nilas run scene.xml` with `--threads 2` and without",
            "resumed": "`nilas run scene.xml --until HALF --checkpoint-every 3_STEPS --out run` and "
                       "`nilas run --resume run --until END`",
            "check": "`nilas check scene.xml` and `nilas run scene.xml`",
            "mirror": "`nilas run scene.xml` and the same of its mirror image in y = 0",
            "turn": "`nilas run scene.xml` and the same of the scene turned by 90 degrees"}


@dataclass
class Count:
    """How often a judge was asked, had something to say, and found a fault."""

    asked: int = 0
    applied: int = 0
    failed: int = 0


@dataclass
class Campaign:
    """A series of seeds, judged one after another."""

    program: Program
    folder: Path
    brief: bool
    shrink_seconds: float
    coverage: Coverage = field(init=False)
    counts: dict[str, Count] = field(default_factory=lambda: {name: Count() for name in JUDGES})
    refused: Counter[str] = field(default_factory=Counter)
    kinds: Counter[str] = field(default_factory=Counter)
    failures: list[str] = field(default_factory=list)
    scenes: int = 0
    done: int = 0

    def __post_init__(self) -> None:
        self.coverage = Coverage(Schema(self.program.schema()))

    def judge(self, seed: int) -> None:
        """Makes the scene of a seed and asks the judges."""
        scene = random_scene(seed)
        case = Case(self.program, scene, self.folder / "at-work")
        self.scenes += 1
        self.coverage.add(scene.xml)
        skipped = {name for k, name in enumerate(IN_TURN) if self.brief and seed % len(IN_TURN) != k}
        for name, judge in JUDGES.items():
            if name in skipped:
                continue
            count = self.counts[name]
            count.asked += 1
            verdict = judge(case)
            count.applied += verdict is not None
            if verdict:
                count.failed += 1
                self._failed(seed, case, name, verdict)
        self.done += case.done
        if not case.done:
            self.refused[documented(case.base.error()) or "other errors"] += 1

    def _failed(self, seed: int, case: Case, judge: str, sentence: str) -> None:
        kind = kind_of(judge, sentence)
        self.kinds[kind] += 1
        self.failures.append(f"seed {seed}, {judge}: {sentence}")
        print(f"seed {seed}, {judge}: {sentence}", flush=True)
        folder = self.folder / "failed" / f"{judge}-{seed}"
        shutil.rmtree(folder, ignore_errors=True)
        case.scene.write(folder / "whole")
        # One scene of a kind is made small: others of it mostly have the same cause.
        if self.shrink_seconds > 0 and self.kinds[kind] <= 2:
            small = Shrinker(self.program, self.folder / "shrinking",
                             self.shrink_seconds).shrink(case.scene, judge, sentence)
            small.write(folder)
            command = COMMANDS.get(judge, "`nilas run scene.xml`")
            (folder / "fault.txt").write_text(f"Seed {seed}, judge {judge}: {sentence}\nCompare {command}.\n",
                                              encoding="utf-8")

    def write(self) -> None:
        """Writes judges.csv, schema.csv, refusals.csv and missing.txt into the folder."""
        self.folder.mkdir(parents=True, exist_ok=True)
        judges = [(name, (JUDGES[name].__doc__ or "").removesuffix("."), c.asked, c.applied, c.failed) for name,
                  c in self.counts.items()]
        tables: dict[str, tuple[tuple[str, ...], list[tuple[object, ...]]]] = {
            "judges.csv": (("judge", "holds", "asked", "applied", "failed"), judges),
            "schema.csv": (("of", "used", "all"), [(kind, *share) for kind, share in self.coverage.shares().items()]),
            "refusals.csv": (("error", "scenes", "page"), [(name, count, page_of(name)) for name,
                                                           count in self.refused.most_common()])}
        for name, (header, rows) in tables.items():
            with (self.folder / name).open("w", newline="", encoding="utf-8") as file:
                writer = csv.writer(file, lineterminator="\n")
                writer.writerow(header)
                writer.writerows(rows)
        (self.folder / "missing.txt").write_text("\n".join(self.coverage.missing()) + "\n", encoding="utf-8")

    def report(self) -> str:
        """The tables as text."""
        lines = [f"{self.scenes} scenes, of which {self.done} ran to their end.",
                 f"{'judge':12} {'asked':>7} {'applied':>8} {'failed':>7}"]
        lines += [f"{name:12} {c.asked:7} {c.applied:8} {c.failed:7}" for name, c in self.counts.items()]
        lines += [f"{count} scenes ended with a documented error: {name}" for name, count in self.refused.most_common()]
        lines += [f"{used} of {every} {kind} of the schema were used." for kind,
                  (used, every) in self.coverage.shares().items()]
        lines.append(f"{self.folder / 'missing.txt'} lists what was never used.")
        return "\n".join(lines)
