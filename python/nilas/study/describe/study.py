"""A study as plain values, as its file describes it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from nilas.study.describe.factor import Factor

DESIGNS = ("full", "one-at-a-time", "latin-hypercube", "sobol", "saltelli", "table")
SAMPLED = ("latin-hypercube", "sobol", "saltelli")
STATISTICS = ("mean", "std", "min", "max", "largest", "p99", "last")
KEEPS = ("all", "summary", "record", "nothing")


@dataclass(frozen=True)
class Design:
    """How points are chosen. ``rows``: the points of a table, as texts by factor name."""

    kind: str = "full"
    points: int = 0
    seed: int = 1
    rows: tuple[dict[str, str], ...] = ()


@dataclass(frozen=True)
class Until:
    """When a point has enough seeds: the relative standard error of a response is small."""

    response: str
    relative_error: float
    most: int


@dataclass(frozen=True)
class Seeds:
    """The replicates of each point. ``chosen``: seeds that are listed one by one.
    ``perturbed``: replicates have the same ice, and starts that differ by 1e-12 m.
    """

    count: int = 1
    first: int = 1
    chosen: tuple[int, ...] = ()
    own: bool = False
    until: Until | None = None
    perturbed: bool = False


@dataclass(frozen=True)
class Response:
    """A number that each run gives.

    ``channel``: a path in summary.json with points, as ``ice_load.along.mean_N``. Or ``column``
    of the file ``table``, of which ``statistic`` is taken from ``from_s`` to ``to_s``.
    """

    name: str
    unit: str
    channel: str = ""
    table: str = ""
    column: str = ""
    statistic: str = ""
    from_s: float | None = None
    to_s: float | None = None
    line: int = 0

    @property
    def title(self) -> str:
        return f"{self.name} [{self.unit}]" if self.unit else self.name


@dataclass(frozen=True)
class RunOptions:
    """How each run is carried out. ``keep``: what stays of a finished run."""

    threads: int = 1
    checkpoint_every: float | None = None
    limit_s: float | None = None
    keep: str = "all"


@dataclass(frozen=True)
class JobOptions:
    """How Snakemake hands out work. ``points``: points of one job; 0: a job for each run."""

    points: int = 0
    memory_mb: int = 0
    minutes: int = 0


@dataclass(frozen=True)
class Study:
    """All that a study file says. Paths are absolute."""

    file: Path
    name: str
    scene: Path
    out: Path
    overrides: tuple[tuple[str, str], ...]
    factors: tuple[Factor, ...]
    design: Design
    seeds: Seeds
    responses: tuple[Response, ...]
    run: RunOptions
    job: JobOptions

    def with_threads(self, threads: int) -> Study:
        """The same study with another number of threads, which changes no result."""
        return replace(self, run=replace(self.run, threads=threads))

    @property
    def runs_folder(self) -> Path:
        return self.out / "runs"
