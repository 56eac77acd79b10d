"""The finished runs of a study: records in run folders, and parts that hold many of them."""

from __future__ import annotations

import hashlib
import json
import shutil
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from nilas.study.carry_out.named_file import text_in
from nilas.study.carry_out.record import RECORD, Record, record_of, write_whole
from nilas.study.describe.plan import Plan, Run
from nilas.study.describe.points import Point
from nilas.study.describe.study import Response, Study


class Records:
    """Finds and writes records.

    A part is a file with a record per line, without the numbers that no response asks for. A
    study of 1e5 runs so is read from some hundred files.
    """

    def __init__(self, plan: Plan, part: str = "") -> None:
        """``part``: only this part is read, as a job needs it. Else all of them are."""
        self.plan = plan
        self._lines: dict[str, str] = {}
        for file in sorted(self.parts_folder.glob(f"{part or 'part-*'}.jsonl")):
            for line in text_in(file).splitlines():
                self._lines[_run_name(line)] = line

    @property
    def parts_folder(self) -> Path:
        return self.plan.study.out / "parts"

    def find(self, run: Run) -> Record | None:
        """The record of a finished run, or None."""
        line = self._lines.get(run.name)
        if line is not None:
            record = record_of(line)
            if not _missing(self.plan.study, record):
                return record
        try:
            text = (self.plan.folder(run) / RECORD).read_text(encoding="utf-8")
        except OSError:
            return None if line is None else record
        try:
            return record_of(text)
        except (ValueError, TypeError):
            # A file that is cut off, as by a full disk: the run begins again.
            return None

    def write(self, run: Run, record: Record) -> None:
        write_whole(self.plan.folder(run) / RECORD, record.text() + "\n")

    def forget(self, run: Run) -> None:
        """Removes a record, so that the run is made again."""
        (self.plan.folder(run) / RECORD).unlink(missing_ok=True)
        if self._lines.pop(run.name, None) is None:
            return
        for part in self.parts_folder.glob("part-*.jsonl"):
            lines = text_in(part).splitlines()
            kept = [line for line in lines if _run_name(line) != run.name]
            if len(kept) < len(lines):
                write_whole(part, "".join(line + "\n" for line in kept))

    def part_file(self, points: list[Point]) -> Path:
        """The part of a group of points. Its name follows from the points alone."""
        digest = hashlib.sha256("\n".join(point.name for point in points).encode()).hexdigest()
        return self.parts_folder / f"part-{digest[:12]}.jsonl"

    def write_part(self, points: list[Point], runs: Iterable[Run]) -> None:
        """Gathers the records of a group. With ``keep: nothing`` run folders are then removed."""
        runs = list(runs)
        found = [(run, record) for run in runs if (record := self.find(run)) is not None]
        lines = [_slim(self.plan.study, record).text() for _, record in found]
        self.parts_folder.mkdir(parents=True, exist_ok=True)
        write_whole(self.part_file(points), "".join(line + "\n" for line in lines))
        for (run, record), line in zip(found, lines, strict=True):
            self._lines[run.name] = line
            # The folder of a failed run shows why it failed.
            if self.plan.study.run.keep == "nothing" and record.status == "done":
                shutil.rmtree(self.plan.folder(run), ignore_errors=True)
                _remove_empty(self.plan.folder(run).parent)


def response_value(record: Record, response: Response) -> float | None:
    """The number that a run gives for a response, or None where it failed or has no such number."""
    if record.status != "done":
        return None
    if response.channel:
        return record.values.get(response.channel)
    return record.columns.get(column_key(response))


def column_key(response: Response) -> str:
    """What a response takes from a table, as a key of the record."""
    start, end = ("" if time is None else f"{time:g}" for time in (response.from_s, response.to_s))
    return f"{response.table}:{response.column}:{response.statistic}:{start}..{end}"


def _missing(study: Study, record: Record) -> bool:
    if record.status != "done":
        return False
    return any(response_value(record, response) is None for response in study.responses)


def _slim(study: Study, record: Record) -> Record:
    wanted = {response.channel for response in study.responses}
    values = {key: value for key, value in record.values.items() if key in wanted}
    return replace(record, values=values)


def _run_name(line: str) -> str:
    # The name is the first entry; to parse whole lines only for it would cost minutes at 1e5 runs.
    start = line.index('"run":') + len('"run":')
    return json.JSONDecoder().raw_decode(line, start)[0]


def _remove_empty(folder: Path) -> None:
    try:
        folder.rmdir()
    except OSError:
        pass
