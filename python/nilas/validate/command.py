"""The command line of validation."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from nilas.study.carry_out.launch import INTERRUPTED
from nilas.study.carry_out.lock import only_one
from nilas.study.carry_out.provenance import find_program
from nilas.study.describe.faults import StudyError
from nilas.study.results.tables import write_tables
from nilas.study.tell import NO_MEMORY
from nilas.study.words import duration
from nilas.validate.campaign.rounds import Campaign, left_out
from nilas.validate.cases.case import Case
from nilas.validate.judge.simulated import result_of
from nilas.validate.judge.slopes import slopes_of
from nilas.validate.judge.table import write_table
from nilas.validate.judge.verdicts import Verdict, rows_of
from nilas.validate.page.page import Judged, write_page
from nilas.validate.shipped import chosen_cases

_DONE = 0
_RUNS_FAILED = 3
# One evening on two cores holds all cases.
_BUDGET_MIN = 300.0


def main(arguments: Sequence[str] | None = None) -> int:
    """Carries out validation and returns the exit code.

    0: table and page are written. 2: a case is wrong. 3: runs failed. 4: a file could not be read
    or written. 130: it was interrupted. Verdicts do not change the code.
    """
    options = _parser().parse_args(arguments)
    try:
        return _validate(options)
    except StudyError as error:
        print(error, file=sys.stderr)
        return error.code
    except OSError as error:
        print(f"error: {error.filename or ''}: {error.strerror}", file=sys.stderr)
        return 4
    except MemoryError:
        print(NO_MEMORY, file=sys.stderr)
        return 4
    except KeyboardInterrupt:
        return INTERRUPTED


def _validate(options: argparse.Namespace) -> int:
    cases = chosen_cases(options.cases)
    if options.slice:
        cases = [case.sliced() for case in cases]
    if options.list:
        print(_listed(cases))
        return _DONE
    out = Path(options.out or ("runs/validate-slice" if options.slice else "runs/validate"))
    cases = [case.placed(out) for case in cases]
    interrupted = False
    with only_one(out, "validate.lock"):
        if not options.collect:
            interrupted = _carry_out(cases, options)
        code = finish(out, cases, options.quiet)
    return INTERRUPTED if interrupted else code


def _carry_out(cases: Sequence[Case], options: argparse.Namespace) -> bool:
    """Makes the runs, and returns whether the user stopped them."""
    campaign = Campaign(
        find_program(options.program),
        options.jobs,
        None if options.budget is None else 60.0 * options.budget,
        options.force,
        options.retry_failed,
        options.quiet,
    )
    outcome = campaign.carry_out(cases)
    if not options.quiet and outcome.ran:
        text = f"{outcome.ran} runs in {duration(outcome.wall_s)}, {outcome.failed} of them failed."
        print(f"{text} Processor time {duration(outcome.processor_s)}.", file=sys.stderr)
    if outcome.out_of_time:
        print(
            f"The budget of {options.budget:g} minutes is used up. The same command goes on.",
            file=sys.stderr,
        )
    elif outcome.interrupted:
        print("Validation was interrupted. The same command continues it.", file=sys.stderr)
    return outcome.interrupted and not outcome.out_of_time


def finish(out: Path, cases: Sequence[Case], quiet: bool = False) -> int:
    """Writes the tables and the page of what is finished, and returns the exit code."""
    judged = []
    for case in cases:
        result = result_of(case)
        write_tables(result.collected)
        judged.append(Judged(result, tuple(rows_of(result)), tuple(slopes_of(result))))
    rows = [row for one in judged for row in one.all_rows]
    write_table(out / "validation.csv", rows)
    sentences = left_out(cases)
    write_page(out / "validation.html", judged, sentences)
    failed = sum(row.status != "done" for one in judged for row in one.result.collected.rows)
    if not quiet:
        for verdict in Verdict:
            count = sum(row.verdict is verdict for row in rows)
            if count:
                print(f"{count:4} comparisons: {verdict.value}")
        print("\n".join(sentences))
        for name in ("validation.csv", "validation.html"):
            print(os.path.relpath(out / name))
    if failed:
        print(f"{failed} runs failed; the page says why.", file=sys.stderr)
    return _RUNS_FAILED if failed else _DONE


def _listed(cases: Sequence[Case]) -> str:
    lines = []
    for case in cases:
        plan = case.plan()
        until = case.study.seeds.until
        runs = plan.least_runs
        most = f" to {plan.most_runs}" if until else ""
        lines.append(f"{case.name}: {case.title}")
        lines.append(f"    {case.question}")
        lines.append(f"    {len(plan.points)} points, {runs}{most} runs")
        if not case.points:
            lines.append(f"    about {duration(60 * case.minutes)} of processor time")
    return "\n".join(lines)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="nilas validate",
        description="Runs scenes and judges their loads by published formulas, measured runs and "
        "scale laws. It writes one table and one page. The same command goes on where it stopped.",
    )
    add = parser.add_argument
    add("cases", nargs="*", metavar="CASE", help="Takes these cases alone: names of shipped ones, "
        "or YAML files. Without a name it takes all shipped cases.")  # fmt: skip
    add("--budget", type=_minutes, default=_BUDGET_MIN, metavar="MINUTES",
        help="Ends after this time. What was left out is stated. The default is 300.")  # fmt: skip
    add("-j", "--jobs", type=_count, default=1, metavar="N", help="Makes this many runs at a time.")
    add("--out", metavar="FOLDER", help="Writes into this folder. The default is runs/validate.")
    add(
        "--list", action="store_true", help="Prints the cases and what they cost, and runs nothing."
    )
    add("--slice", action="store_true", help="Takes a small part of each case, for quick checks.")
    add(
        "--collect", action="store_true", help="Writes table and page from the finished runs alone."
    )
    add("--program", metavar="FILE", help="Runs this program instead of the nilas that is found.")
    add("--retry-failed", action="store_true", help="Makes runs that failed again.")
    add("--force", action="store_true", help="Makes runs of a changed scene again.")
    add("--quiet", action="store_true", help="Prints only errors.")
    return parser


def _count(text: str) -> int:
    if not text.isdigit() or not 1 <= int(text) <= 4096:
        raise argparse.ArgumentTypeError(f"'{text}' is no whole number from 1 to 4096")
    return int(text)


def _minutes(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not 0.0 < value <= 1e6:
        raise argparse.ArgumentTypeError(f"'{text}' is no number of minutes above 0")
    return value
