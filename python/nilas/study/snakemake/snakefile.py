"""Writes a Snakefile that carries out a study, on this machine or on a cluster."""

from __future__ import annotations

import os
import shlex
import sys
from pathlib import Path
from string import Template

from nilas.study.carry_out.record import RECORD, write_whole
from nilas.study.carry_out.records import Records
from nilas.study.describe.plan import Plan

_TEMPLATE = Path(__file__).with_name("Snakefile.template")


def write_snakefile(plan: Plan, program: Path) -> str:
    """Writes ``Snakefile`` and ``jobs.txt`` into the study's folder. Returns how to start it.

    A job is a run. With ``job.points``, or with a rule for the number of seeds, a job makes all
    runs of some points instead and leaves one part. Snakemake then has as many jobs as there are
    parts, however many runs there are.
    """
    study = plan.study
    out = study.out
    plan.make_folders()
    by_part = study.job.points > 0 or study.seeds.until is not None
    if by_part:
        records = Records(plan)
        jobs = [records.part_file(points).stem for points in plan.jobs()]
        pattern, option = "parts/{job}.jsonl", "--part"
    else:
        jobs = [run.name for run in plan.all_runs()]
        pattern, option = f"runs/{{job}}/{RECORD}", "--run"
    write_whole(out / "jobs.txt", "".join(job + "\n" for job in jobs))
    text = Template(_TEMPLATE.read_text(encoding="utf-8")).substitute(
        name=study.name,
        out=repr(str(out)),
        command=repr(_command(plan, program)),
        pattern=repr(pattern),
        option=repr(option),
        threads=study.run.threads,
        resources=_resources(plan),
    )
    file = out / "Snakefile"
    write_whole(file, text)
    place = os.path.relpath(file)
    return (
        f"{place} has {len(jobs)} jobs. Start it with one of these commands:\n"
        f"  snakemake -s {place} --cores 2\n"
        f"  snakemake -s {place} --executor slurm --jobs 100"
    )


def _command(plan: Plan, program: Path) -> str:
    """The command of all jobs, in the Python that runs this: that of Snakemake may lack SciPy."""
    package = Path(__file__).resolve().parents[3]
    words = [
        sys.executable,
        "-m",
        "nilas.study",
        str(plan.study.file),
        "--out",
        str(plan.study.out),
    ]
    command = shlex.join(["env", f"PYTHONPATH={package}", *words, "--program", str(program)])
    # Snakemake fills in what stands between braces.
    return command.replace("{", "{{").replace("}", "}}")


def _resources(plan: Plan) -> str:
    """Lines of the rule's resources; without any, those of Snakemake's command line hold."""
    job = plan.study.job
    lines = [f"        mem_mb={job.memory_mb}," if job.memory_mb else ""]
    lines += [f"        runtime={job.minutes}," if job.minutes else ""]
    text = "\n".join(line for line in lines if line)
    return f"    resources:\n{text}\n" if text else ""
