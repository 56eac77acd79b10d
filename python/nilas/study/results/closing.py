"""The end of a study: tables, page, and what to tell the user."""

from __future__ import annotations

import os

from nilas.study.carry_out.records import Records
from nilas.study.describe.faults import listed, nearest
from nilas.study.describe.plan import Plan
from nilas.study.results.collected import Collected, collect
from nilas.study.results.tables import why_no_parquet, write_tables
from nilas.study.tell import tell, warn

_FAILED = 3
_WRONG_INPUT = 2
_TOLD_FAILURES = 5


def finish_study(
    plan: Plan, records: Records, *, quiet: bool, write: bool = True, page: bool = True
) -> int:
    """Writes tables and page of the finished runs, tells failures, and returns the exit code."""
    collected = collect(plan, records)
    if write:
        written = _write(collected, page)
        if not quiet:
            tell("\n".join(os.path.relpath(path) for path in written))
            if not any(path.suffix == ".parquet" for path in written):
                tell(f"study.parquet was not written: {why_no_parquet()}.")
    code = _tell_absent(collected, records)
    if collected.failed:
        _tell_failures(collected)
        code = _FAILED
    if collected.missing and not quiet:
        warn(f"{collected.missing} runs are still missing.")
    return code


def _write(collected: Collected, page: bool) -> list:

    written = write_tables(collected)
    if page:
        # Matplotlib takes a second to load, so it is loaded here only.
        from nilas.study.results.page import write_page

        written.append(write_page(collected))
    return written


def _tell_failures(collected: Collected) -> None:
    failed = collected.failed
    warn(f"{len(failed)} of {len(collected.rows)} runs failed:")
    for row in failed[:_TOLD_FAILURES]:
        warn(f"  {row.run.name}: {row.message}")
    if len(failed) > _TOLD_FAILURES:
        warn(f"  and {len(failed) - _TOLD_FAILURES} more; study.csv has them all.")


def _tell_absent(collected: Collected, records: Records) -> int:
    """Responses that runs do not have: a wrong name, or a load that this run does not state."""
    code = 0
    done = [row for row in collected.rows if row.status == "done"]
    for response, count in collected.absent():
        text = f"{count} runs that are done have no value of {response.channel or response.column}."
        if count == len(done):
            code = _WRONG_INPUT
            record = records.find(done[0].run)
            names = list(record.values) if record else []
            if response.channel:
                text += nearest(response.channel, names) + _beginning(response.channel, names)
            else:
                text += f" {done[0].message}"
        place = f"{collected.plan.study.file}:{response.line}: responses.{response.name}"
        warn(f"{place}: {text}")
    return code


def _beginning(channel: str, names: list[str]) -> str:
    """Some names that begin as the wrong one does."""
    start = channel.split(".")[0]
    alike = [name for name in names if name.startswith(start + ".")][:6]
    return f" summary.json has, for example, {listed(alike)}." if alike else ""
