"""The command line of a study."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from nilas.study.carry_out.launch import INTERRUPTED, Launcher
from nilas.study.carry_out.lock import only_one
from nilas.study.carry_out.progress import Progress
from nilas.study.carry_out.provenance import find_program
from nilas.study.carry_out.queue import Queue, queue_of
from nilas.study.carry_out.records import Records
from nilas.study.carry_out.scene_check import check_scene
from nilas.study.carry_out.schedule import Outcome, Scheduler
from nilas.study.describe.faults import StudyError
from nilas.study.describe.plan import Plan, Run
from nilas.study.describe.points import Point
from nilas.study.describe.read_study import read_study
from nilas.study.needs import demand_packages
from nilas.study.options import option_parser
from nilas.study.results.closing import finish_study
from nilas.study.results.overview import plan_text, status_text
from nilas.study.snakemake.snakefile import write_snakefile
from nilas.study.tell import NO_MEMORY, settle, tell, warn
from nilas.study.words import duration

_DONE = 0
_RUNS_FAILED = 3


def main(arguments: Sequence[str] | None = None) -> int:
    """Carries out a study and returns the exit code.

    0: all runs are done. 2: the study is wrong. 3: runs failed. 4: a file could not be read or
    written, or there is too little memory. 130: the study was interrupted. ``arguments``: the words after ``python3 -m nilas.study``.

    >>> main(["there-is-none.yaml", "--status"])
    4
    >>> main([str(example_study), "--status", "--out", "none"])  # doctest: +ELLIPSIS
    Study trial in none: 0 of 8 runs done, 0 failed, 8 missing, 0 of them begun.
    ...
    0
    """
    try:
        return carried_out(arguments)
    except MemoryError:
        warn(NO_MEMORY)
        return 4
    finally:
        settle()


def carried_out(arguments: Sequence[str] | None = None) -> int:
    """As ``main()``, but raises ``MemoryError``: its caller may have to end at once."""
    try:
        return _carry_out(option_parser().parse_args(arguments))
    except StudyError as error:
        warn(error)
        return error.code
    except BrokenPipeError:  # of --help, which argparse writes
        return _DONE
    except OSError as error:
        warn(f"error: {error.filename or ''}: {error.strerror}")
        return 4
    except KeyboardInterrupt:
        return INTERRUPTED
    finally:
        settle()


def _carry_out(options: argparse.Namespace) -> int:
    is_part = options.status or options.judge or options.run or options.part
    demand_packages(page=not is_part and not options.no_page)
    plan = Plan(read_study(options.study, options.out))
    if options.threads:
        plan = Plan(plan.study.with_threads(options.threads))
    if options.dry_run:
        if not options.no_check:
            check_scene(plan, Launcher(plan, find_program(options.program)))
        tell(plan_text(plan, Records(plan)))
        return _DONE
    if options.status:
        tell(status_text(plan, Records(plan)))
        return _DONE
    if options.snakemake:
        program = find_program(options.program)
        if not options.no_check:
            check_scene(plan, Launcher(plan, program))
        tell(write_snakefile(plan, program))
        return _DONE
    if options.judge:
        return finish_study(plan, Records(plan), quiet=True, write=False)
    if options.collect or options.gather:
        code = finish_study(plan, Records(plan), quiet=options.quiet, page=not options.no_page)
        return _DONE if options.gather else code
    if options.run or options.part:
        return _one_job(plan, options)
    with only_one(plan.study.out, "study.lock"):
        return _whole_study(plan, options)


def _whole_study(plan: Plan, options: argparse.Namespace) -> int:
    """Makes all runs that are missing, then writes tables and page."""
    records = Records(plan)
    launcher = Launcher(plan, find_program(options.program))
    queue = _queue(plan, records, launcher, plan.points, options)
    if not options.no_check:
        is_new = queue.done + queue.failed == 0
        doubtful = check_scene(plan, launcher) if is_new else plan.study.responses
        launcher.watched = [one for one in doubtful if one.name not in queue.has_value]
    progress = Progress(queue.done + queue.failed, options.quiet)
    if queue.done + queue.failed:
        progress.say(
            f"{queue.done + queue.failed} runs are finished already; {len(queue)} are to be made."
        )
    outcome = Scheduler(queue, records, launcher, options.jobs, progress).carry_out()
    if launcher.faults:
        kept = "The first run ended without them, and no other begins. What is done stays done."
        raise StudyError("\n".join([*launcher.faults, kept]))
    if plan.study.job.points:
        for points in plan.jobs():
            if not Queue(plan, records, points, launcher.key):
                _write_part(plan, records, points)
    if not outcome.interrupted or outcome.ran:
        progress.say(_account(outcome))
    code = finish_study(plan, records, quiet=options.quiet, page=not options.no_page)
    if outcome.interrupted:
        progress.say("The study was interrupted. The same command continues it.")
        return INTERRUPTED
    return code


def _one_job(plan: Plan, options: argparse.Namespace) -> int:
    """Makes one run, or the runs of one part, as a job of Snakemake. A failed run is a result."""
    records = Records(plan, options.part or "no part")
    launcher = Launcher(plan, find_program(options.program))
    progress = Progress(0, options.quiet)
    if options.part:
        points = _points_of_part(plan, records, options.part)
        queue = _queue(plan, records, launcher, points, options)
    else:
        run = _run_named(plan, options.run)
        points = [run.point]
        queue = _queue(plan, records, launcher, points, options)
        queue.keep_only(run)
    outcome = Scheduler(queue, records, launcher, options.jobs, progress).carry_out()
    if outcome.interrupted:
        return INTERRUPTED
    if options.part:
        _write_part(plan, records, points)
    return _DONE


def _queue(
    plan: Plan,
    records: Records,
    launcher: Launcher,
    points: list[Point],
    options: argparse.Namespace,
) -> Queue:
    """The runs to make. Runs of another scene, or that failed by chance, are forgotten first."""
    return queue_of(plan, records, points, launcher.key, options.force, options.retry_failed)


def _write_part(plan: Plan, records: Records, points: list[Point]) -> None:
    """Writes the part of some points, of whose runs none is missing."""
    seeds = plan.study.seeds
    runs = [
        run
        for point in points
        for run in plan.runs(point, seeds.until.most if seeds.until else None)
    ]
    records.write_part(points, runs)


def _points_of_part(plan: Plan, records: Records, name: str) -> list[Point]:
    for points in plan.jobs():
        if records.part_file(points).stem == name:
            return points
    raise StudyError(f"The study has no part {name}. Its file changed; write the Snakefile again.")


def _run_named(plan: Plan, name: str) -> Run:
    for point in plan.points:
        if f"/{point.name}/" in f"/{name}":
            for run in plan.runs(point):
                if run.name == name:
                    return run
    raise StudyError(f"The study has no run {name}. Its file changed; write the Snakefile again.")


def _account(outcome: Outcome) -> str:
    if outcome.ran == 0:
        return "No run was to be made."
    return (
        f"{outcome.ran} runs in {duration(outcome.wall_s)}, {outcome.failed} of them failed. "
        f"Processor time {duration(outcome.processor_s)}, efficiency {outcome.efficiency:.2f} on "
        f"{outcome.slots} at a time. Places were free for {outcome.idle_s:.2f} s while runs waited."
    )
