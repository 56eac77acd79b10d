"""The plan of a study: its points, seeds, and the folder of every run."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from nilas.study.describe.points import Point, points_of
from nilas.study.describe.study import Study

# With more points than this, folders are spread over 256 others: one folder with 1e5 entries is
# slow to list on shared file systems.
SHARDS_ABOVE = 1000
SHARDED_MARK = ".in-256-folders"


@dataclass(frozen=True)
class Run:
    """One run: a point with a seed. ``name`` is that of its folder below ``runs``."""

    point: Point
    seed: int
    name: str


@dataclass
class Plan:
    """Points and seeds of a study. Runs are named, never stored: 1e5 of them cost nothing.

    >>> from nilas.study import read_study
    >>> plan = Plan(read_study(example_study))
    >>> len(plan.points), plan.least_runs
    (4, 8)
    >>> [run.name for run in plan.runs(plan.points[0])]
    ['speed-0.2_concentration-0.3/seed-1', 'speed-0.2_concentration-0.3/seed-2']
    >>> plan.points[3].overrides
    (('vessel/carriage/@speed', '0.3'), ('ice/field/@concentration', '0.5'))
    """

    study: Study
    points: list[Point] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.points = self.points or points_of(self.study)
        folder = self.study.runs_folder
        # A study that grows keeps the folders that it began with.
        if folder.is_dir():
            self.sharded = (folder / SHARDED_MARK).exists()
        else:
            self.sharded = len(self.points) > SHARDS_ABOVE

    def make_folders(self) -> None:
        """Makes the folder of runs, and marks it where runs are spread over folders."""
        self.study.runs_folder.mkdir(parents=True, exist_ok=True)
        if self.sharded:
            (self.study.runs_folder / SHARDED_MARK).touch()

    def run(self, point: Point, place: int) -> Run:
        """The run of a point with its seed number ``place``, counted from 0."""
        seed = self.seed(point, place)
        return Run(point, seed, f"{self._folder(point)}/seed-{seed}")

    def runs(self, point: Point, count: int | None = None) -> list[Run]:
        """The first ``count`` runs of a point; the default is the number that the study names."""
        return [
            self.run(point, k) for k in range(self.study.seeds.count if count is None else count)
        ]

    def all_runs(self) -> Iterator[Run]:
        """All runs that are certain, point by point."""
        for point in self.points:
            yield from self.runs(point)

    def folder(self, run: Run) -> Path:
        return self.study.runs_folder / run.name

    def seed(self, point: Point, place: int) -> int:
        seeds = self.study.seeds
        if seeds.chosen:
            return seeds.chosen[place]
        if seeds.own:
            digest = hashlib.sha256(f"{point.name} {place}".encode()).hexdigest()
            return int(digest[:8], 16)
        return seeds.first + place

    @property
    def most_runs(self) -> int:
        """The number of runs if the rule of the seeds never stops early."""
        until = self.study.seeds.until
        return len(self.points) * (until.most if until else self.study.seeds.count)

    @property
    def least_runs(self) -> int:
        return len(self.points) * self.study.seeds.count

    def jobs(self) -> list[list[Point]]:
        """The points in groups, as jobs and parts have them."""
        size = max(self.study.job.points, 1)
        return [self.points[k : k + size] for k in range(0, len(self.points), size)]

    def _folder(self, point: Point) -> str:
        if not self.sharded:
            return point.name
        return f"{hashlib.sha256(point.name.encode()).hexdigest()[:2]}/{point.name}"
