"""Makes the runs of all cases in rounds: a budget that ends early leaves all of them known.

A round adds two seeds to each point of each case. The last round of a case follows its own rule
for the number of seeds. Runs that are finished are never repeated.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from nilas.study.carry_out.launch import Launcher
from nilas.study.carry_out.progress import Progress
from nilas.study.carry_out.queue import Queue, queue_of
from nilas.study.carry_out.records import Records
from nilas.study.carry_out.scene_check import check_scene
from nilas.study.carry_out.schedule import Outcome, Scheduler
from nilas.study.results.collected import collect
from nilas.validate.cases.case import Case

_SEEDS_A_ROUND = 2


@dataclass
class Campaign:
    """How cases are carried out.

    ``budget_s``: wall time after which runs are stopped, None for no limit. ``jobs``: runs at a
    time. ``force``: runs of a changed scene are made again. ``outcome``: what was done.
    """

    program: Path
    jobs: int = 1
    budget_s: float | None = None
    force: bool = False
    retry_failed: bool = False
    quiet: bool = False
    outcome: Outcome = field(default_factory=Outcome)

    def carry_out(self, cases: Sequence[Case]) -> Outcome:
        """Makes what is missing until all is done, the budget ends, or Ctrl-C."""
        begun = time.monotonic()
        ends_at = None if self.budget_s is None else begun + self.budget_s
        for case in cases:
            plan = case.plan()
            key_of = Launcher(plan, self.program).key
            queue_of(plan, Records(plan), plan.points, key_of, self.force, self.retry_failed)
        checked: set[str] = set()
        for case, seeds in rounds_of(cases):
            if self.outcome.interrupted:
                break
            self._round(case, seeds, ends_at, checked)
        self.outcome.wall_s = time.monotonic() - begun
        return self.outcome

    def _round(self, case: Case, seeds: int, ends_at: float | None, checked: set[str]) -> None:
        plan = case.plan(seeds)
        records = Records(plan)
        launcher = Launcher(plan, self.program)
        queue = Queue(plan, records, plan.points, launcher.key)
        if not len(queue):
            return
        if case.name not in checked:
            check_scene(plan, launcher)
            checked.add(case.name)
        progress = Progress(queue.done + queue.failed, self.quiet)
        progress.say(f"{case.name}: {len(queue)} runs, up to seed number {seeds} of each point")
        done = Scheduler(queue, records, launcher, self.jobs, progress, ends_at).carry_out()
        self.outcome.ran += done.ran
        self.outcome.failed += done.failed
        self.outcome.processor_s += done.processor_s
        self.outcome.interrupted |= done.interrupted
        self.outcome.out_of_time |= done.out_of_time


def rounds_of(cases: Sequence[Case]) -> Iterator[tuple[Case, int]]:
    """Each case with the number of its seeds, round by round.

    The last number of a case is that of its study.
    """
    most = max((case.study.seeds.count for case in cases), default=0)
    for seeds in range(_SEEDS_A_ROUND, most + _SEEDS_A_ROUND, _SEEDS_A_ROUND):
        for case in cases:
            if seeds - _SEEDS_A_ROUND < case.study.seeds.count:
                yield case, min(seeds, case.study.seeds.count)


def left_out(cases: Sequence[Case]) -> list[str]:
    """What has not been run, a sentence for each case."""
    sentences = []
    for case in cases:
        plan = case.plan()
        collected = collect(plan, Records(plan))
        if not collected.missing:
            continue
        planned = len(collected.rows) + collected.missing
        runs = {point.number: 0 for point in plan.points}
        for row in collected.rows:
            runs[row.run.point.number] += 1
        empty = sum(count == 0 for count in runs.values())
        text = f"{case.name}: {collected.missing} of {planned} runs were not made."
        if empty:
            text += f" {empty} of {len(runs)} points have none."
        else:
            text += f" Each point has {min(runs.values())} or more."
        sentences.append(text)
    return sentences
