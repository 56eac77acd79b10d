"""The finished runs of a study, in the order of its plan."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from nilas.study.carry_out.record import Record
from nilas.study.carry_out.records import Records, response_value
from nilas.study.carry_out.stopping import seeds_wanted
from nilas.study.describe.plan import Plan, Run
from nilas.study.describe.points import Point
from nilas.study.describe.study import Response


@dataclass(frozen=True)
class Row:
    """One finished run. ``values`` has a number or None for each response of the study."""

    run: Run
    status: str
    exit_code: int
    message: str
    values: tuple[float | None, ...]
    times: dict
    made_by: dict


@dataclass
class Collected:
    """All finished runs that count, and how many are still missing."""

    plan: Plan
    rows: list[Row] = field(default_factory=list)
    missing: int = 0
    unsettled: int = 0

    @property
    def failed(self) -> list[Row]:
        return [row for row in self.rows if row.status != "done"]

    def values_of(self, place: int) -> dict[int, list[float]]:
        """The values of the response number ``place`` of each point, by the point's number."""
        values: dict[int, list[float]] = {point.number: [] for point in self.plan.points}
        for row in self.rows:
            value = row.values[place]
            if value is not None:
                values[row.run.point.number].append(value)
        return values

    def absent(self) -> list[tuple[Response, int]]:
        """Responses that runs which are done do not have, with the number of these runs."""
        done = [row for row in self.rows if row.status == "done"]
        counts = [
            (response, sum(row.values[place] is None for row in done))
            for place, response in enumerate(self.plan.study.responses)
        ]
        return [(response, count) for response, count in counts if count]


def collect(plan: Plan, records: Records) -> Collected:
    """Gathers the runs that count, point by point and seed by seed.

    Under a rule for the number of seeds, only those runs count that the rule asks for. The order
    in which runs ended plays no part.
    """
    collected = Collected(plan)
    for point in plan.points:
        rows, wanted = _rows_of(plan, records, point)
        collected.rows += rows
        collected.missing += wanted - len(rows)
        until = plan.study.seeds.until
        if until and len(rows) == wanted == until.most:
            collected.unsettled += not _is_settled(plan, rows)
    return collected


def _rows_of(plan: Plan, records: Records, point: Point) -> tuple[list[Row], int]:
    """The rows of a point, and the number of runs that it should have."""
    seeds, responses = plan.study.seeds, plan.study.responses
    place = _stopping_place(plan)
    rows: list[Row] = []
    results: list[float | None] = []
    complete = True
    wanted = seeds_wanted(seeds, results)
    for row in _found(plan, records, point, responses):
        if len(results) >= wanted:
            break
        if row is None:
            complete = False
            results.append(None)
        else:
            rows.append(row)
            results.append(row.values[place])
        # The rule needs all of the seeds before; until then the number so far stands.
        if complete:
            wanted = seeds_wanted(seeds, results)
    return rows, wanted


def _found(
    plan: Plan, records: Records, point: Point, responses: tuple[Response, ...]
) -> Iterator[Row | None]:
    """The rows of a point's runs in the order of their seeds, None for a run that is missing."""
    seeds = plan.study.seeds
    for place in range(seeds.until.most if seeds.until else seeds.count):
        run = plan.run(point, place)
        record = records.find(run)
        yield None if record is None else _row(run, record, responses)


def _row(run: Run, record: Record, responses: tuple[Response, ...]) -> Row:
    program = record.provenance.get("program", {})
    made_by = {
        "machine": record.provenance.get("machine", {}).get("name", ""),
        "processor": record.provenance.get("machine", {}).get("processor", ""),
        "program": program.get("version", ""),
        "program_sha256": program.get("sha256", ""),
        "scene_as_run_sha256": record.provenance.get("scene_as_run_sha256", ""),
        "resumed": str(record.provenance.get("resumed", False)).lower(),
    }
    return Row(
        run,
        record.status,
        record.exit_code,
        record.message,
        tuple(response_value(record, response) for response in responses),
        record.times,
        made_by,
    )


def _stopping_place(plan: Plan) -> int:
    until = plan.study.seeds.until
    names = [response.name for response in plan.study.responses]
    return names.index(until.response) if until else 0


def _is_settled(plan: Plan, rows: list[Row]) -> bool:
    from nilas.study.carry_out.stopping import relative_error

    until = plan.study.seeds.until
    values = [value for row in rows if (value := row.values[_stopping_place(plan)]) is not None]
    return until is None or relative_error(values) <= until.relative_error
