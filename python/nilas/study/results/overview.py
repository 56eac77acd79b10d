"""The plan of a study and its state, in words."""

from __future__ import annotations

import os

from nilas.study.carry_out.records import Records
from nilas.study.describe.plan import Plan
from nilas.study.results.collected import Collected, collect
from nilas.study.words import duration, size

_SHOWN = 8


def plan_text(plan: Plan, records: Records) -> str:
    """Points, seeds, runs and folders, and what they cost as far as finished runs tell it."""
    study = plan.study
    lines = [f"Study {study.name}: {study.scene}", ""]
    for factor in study.factors:
        if factor.low is not None and not factor.levels:
            what = (
                f"from {factor.low:g} to "
                f"{factor.high:g}{', logarithmic' if factor.logarithmic else ''}"
            )
        else:
            what = _shortened([level.label for level in factor.levels])
        lines.append(f"  {factor.title}: {what}")
    seeds = study.seeds
    rule = (
        f"{seeds.count} seeds, then more until the standard error of "
        f"{seeds.until.response} is below "
        f"{100 * seeds.until.relative_error:g} % of the mean, at most {seeds.until.most}"
        if seeds.until
        else f"{seeds.count} seed{'s' if seeds.count > 1 else ''} each"
    )
    lines += [
        "",
        f"{len(plan.points)} points ({study.design.kind}), {rule}: {_number_of_runs(plan)}.",
    ]
    lines += [f"Each run has a folder in {os.path.relpath(study.runs_folder)}, for example"]
    lines += [f"  {run.name}" for point in plan.points[:3] for run in plan.runs(point, 1)]
    lines += ["", *_cost(plan, records)]
    return "\n".join(lines)


def _number_of_runs(plan: Plan) -> str:
    if plan.least_runs == plan.most_runs:
        return f"{plan.least_runs} runs"
    return f"{plan.least_runs} to {plan.most_runs} runs"


def _cost(plan: Plan, records: Records) -> list[str]:
    """Time, files and bytes, from the runs that are finished."""
    collected = collect(plan, records)
    times = [row.times for row in collected.rows if row.status == "done" and row.times]
    if not times:
        return [
            "No run is finished yet, so nothing is known of the time. Make one run first, "
            "stop with Ctrl-C,",
            "and ask again: what is done stays done.",
        ]
    count = len(times)
    left = collected.missing
    wall_s, processor_s, files, stored = (
        sum(float(one.get(key, 0)) for one in times) / count
        for key in ("wall_s", "processor_s", "files", "bytes")
    )
    total = len(collected.rows) + left
    kept = plan.study.run.keep
    return [
        f"From {count} finished runs, a run takes {duration(wall_s)} (processor time "
        f"{duration(processor_s)}).",
        f"{left} runs are left: {duration(left * wall_s)} one at a time, "
        f"{duration(left * wall_s / 2)} with -j 2.",
        f"A run writes {files:.0f} files and {size(stored)}; {total} runs write "
        f"{total * files:.0f} files "
        f"and {size(total * stored)}, of which the study keeps '{kept}'.",
    ]


def status_text(plan: Plan, records: Records) -> str:
    """How far the study is, and which runs failed."""
    collected = collect(plan, records)
    done = len(collected.rows) - len(collected.failed)
    total = len(collected.rows) + collected.missing
    begun = _begun(plan, collected)
    lines = [
        f"Study {plan.study.name} in {os.path.relpath(plan.study.out)}: {done} of {total} "
        f"runs done, "
        f"{len(collected.failed)} failed, {collected.missing} missing, {begun} of them begun."
    ]
    if plan.study.seeds.until:
        lines.append(
            f"{collected.unsettled} points have all seeds that are allowed, and still "
            f"scatter too much."
        )
    lines += [f"  failed: {row.run.name}: {row.message}" for row in collected.failed]
    return "\n".join(lines + _cost(plan, records))


def _begun(plan: Plan, collected: Collected) -> int:
    from nilas.study.carry_out.record import BEGUN

    finished = {row.run.name for row in collected.rows}
    seeds = plan.study.seeds
    count = seeds.until.most if seeds.until else seeds.count
    runs = (run for point in plan.points for run in plan.runs(point, count))
    return sum(run.name not in finished and (plan.folder(run) / BEGUN).exists() for run in runs)


def _shortened(labels: list[str]) -> str:
    if len(labels) <= _SHOWN:
        return ", ".join(labels)
    return ", ".join(labels[:3]) + f", ... {labels[-1]} ({len(labels)} values)"
