"""Which run comes next: a seed of every point first, then the longest runs first."""

from __future__ import annotations

import heapq
from collections import deque
from collections.abc import Callable

from nilas.study.carry_out.record import Record
from nilas.study.carry_out.records import Records, response_value
from nilas.study.carry_out.stopping import seeds_wanted
from nilas.study.describe.faults import StudyError
from nilas.study.describe.plan import Plan, Run
from nilas.study.describe.points import Point
from nilas.study.describe.study import Response

# Exit codes of runs that another try may mend: a file that could not be written, a program that
# could not be started, a signal from outside such as that of a machine without memory.
_WORTH_ANOTHER_TRY = {4, 126, 127}
_SIGNAL = 128


class Queue:
    """The runs that are still to be made.

    The first seed of all points comes first: it soon shows the whole picture, and tells how long
    a run of each point takes. Longer runs then go before shorter ones. So at the end no processor
    waits for one long run. Choosing a run costs the logarithm of their number.
    """

    def __init__(
        self, plan: Plan, records: Records, points: list[Point], key_of: Callable[[Run], str]
    ) -> None:
        self.plan = plan
        self.stale: list[Run] = []
        self.failed_runs: list[tuple[Run, Record]] = []
        self._key_of = key_of
        self.stopping_response = self._find_response()
        self._first: deque[Run] = deque()
        self._later: list[tuple[float, int, int, Run]] = []
        self._results: dict[int, dict[int, float | None]] = {}
        self._asked: dict[int, int] = {}
        self._wall_s: dict[int, float] = {}
        self._places: dict[str, int] = {}
        self.failed = 0
        self.done = 0
        self.has_value: set[str] = set()  # responses of which a finished run has one
        for point in points:
            self._add_point(point, records)

    def __len__(self) -> int:
        return len(self._first) + len(self._later)

    def keep_only(self, run: Run) -> None:
        """Leaves out all runs but one, which is left out too where it is finished."""
        self._first = deque(
            one for one in [*self._first, *self._all_later()] if one.name == run.name
        )
        self._later = []

    def next(self) -> Run | None:
        """The run to start now, or None where none is left."""
        if self._first:
            return self._first.popleft()
        return heapq.heappop(self._later)[-1] if self._later else None

    def put_back(self, run: Run) -> None:
        """A run that has to begin again comes next."""
        self._first.appendleft(run)

    def finished(self, run: Run, value: float | None, failed: bool, wall_s: float) -> None:
        """A run ended: its point may need more seeds."""
        point = run.point
        place = self._places.pop(run.name)
        self._count(failed)
        results = self._results[point.number]
        results[place] = value
        if point.number not in self._wall_s:
            self._wall_s[point.number] = wall_s
            self._sort_again(point)
        self._ask(point)

    def _add_point(self, point: Point, records: Records) -> None:
        self._results[point.number] = {}
        self._asked[point.number] = 0
        # Finished runs may make the rule ask for more, and those may be finished too.
        while (wanted := self._wanted(point)) > self._asked[point.number]:
            for place in range(self._asked[point.number], wanted):
                run = self.plan.run(point, place)
                record = records.find(run)
                if record is None:
                    self._put(run, place)
                    continue
                if record.key != self._key_of(run):
                    self.stale.append(run)
                value = (
                    response_value(record, self.stopping_response)
                    if self.stopping_response
                    else None
                )
                self._results[point.number][place] = value
                self._wall_s.setdefault(point.number, float(record.times.get("wall_s", 0.0)))
                self._count(record.status != "done")
                self._note_values(record)
                if record.status != "done":
                    self.failed_runs.append((run, record))
            self._asked[point.number] = wanted

    def _note_values(self, record: Record) -> None:
        for response in self.plan.study.responses:
            if response.name not in self.has_value and response_value(record, response) is not None:
                self.has_value.add(response.name)

    def _wanted(self, point: Point) -> int:
        results = self._results[point.number]
        in_order = []
        for place in range(len(results)):
            if place not in results:
                break
            in_order.append(results[place])
        return seeds_wanted(self.plan.study.seeds, in_order)

    def _ask(self, point: Point) -> None:
        wanted = self._wanted(point)
        for place in range(self._asked[point.number], wanted):
            self._put(self.plan.run(point, place), place)
        self._asked[point.number] = max(wanted, self._asked[point.number])

    def _put(self, run: Run, place: int) -> None:
        self._places[run.name] = place
        if place == 0:
            self._first.append(run)
        else:
            wall_s = self._wall_s.get(run.point.number, 0.0)
            heapq.heappush(self._later, (-wall_s, place, run.point.number, run))

    def _all_later(self) -> list[Run]:
        return [entry[-1] for entry in self._later]

    def _sort_again(self, point: Point) -> None:
        """The time of a point is known now: its waiting runs get their place."""
        if len(self._later) > 5000:
            return  # With so many runs left, the order hardly matters.
        mine = [entry for entry in self._later if entry[-1].point.number == point.number]
        if mine:
            others = [entry for entry in self._later if entry[-1].point.number != point.number]
            wall_s = self._wall_s[point.number]
            self._later = others + [(-wall_s, entry[1], entry[2], entry[3]) for entry in mine]
            heapq.heapify(self._later)

    def _find_response(self) -> Response | None:
        until = self.plan.study.seeds.until
        if until is None:
            return None
        return next(one for one in self.plan.study.responses if one.name == until.response)

    def _count(self, failed: bool) -> None:
        self.failed += failed
        self.done += not failed


def queue_of(
    plan: Plan,
    records: Records,
    points: list[Point],
    key_of: Callable[[Run], str],
    force: bool,
    retry_failed: bool,
) -> Queue:
    """The runs to make. Runs of another scene, or that failed by chance, are forgotten first.

    Without ``force``, runs of another scene raise ``StudyError``. With ``retry_failed`` all failed
    runs are made again.
    """
    plan.make_folders()
    queue = Queue(plan, records, points, key_of)
    if queue.stale and not force:
        raise StudyError(
            f"{len(queue.stale)} finished runs in {plan.study.out} were made of another "
            f"scene or of other "
            f"values of 'set', for example {queue.stale[0].name}. Choose another folder "
            f"with --out, or "
            "make them again with --force."
        )
    again = list(queue.stale)
    for run, record in queue.failed_runs:
        by_chance = record.exit_code in _WORTH_ANOTHER_TRY or record.exit_code > _SIGNAL
        if retry_failed or by_chance:
            again.append(run)
    if not again:
        return queue
    for run in again:
        records.forget(run)
    return Queue(plan, records, points, key_of)
