"""The same study by Snakemake gives the same table to the last digit.

Snakemake 8 or newer is not in Debian 12. It is looked for on the search path and where the
environment variable NILAS_SNAKEMAKE says.
"""

import os
import re
import shutil
import subprocess

import pytest
from study_desk import STUDY

SNAKEMAKE = os.environ.get("NILAS_SNAKEMAKE") or shutil.which("snakemake")


def _version():
    if not SNAKEMAKE:
        return 0
    answer = subprocess.run([SNAKEMAKE, "--version"], capture_output=True, text=True).stdout
    return int(re.match(r"\d+", answer)[0]) if re.match(r"\d+", answer) else 0


needs_snakemake = pytest.mark.skipif(
    _version() < 8,
    reason="Snakemake 8 or newer is not installed (pip install snakemake, in a venv)",
)


def snakemake(desk, out):
    """Writes the Snakefile and runs it. Returns the exit code and what was printed."""
    code, text = desk.run("--out", out, "--snakemake")
    assert code == 0, text
    command = [SNAKEMAKE, "-s", f"{out}/Snakefile", "--cores", "2", "--keep-going"]
    answer = subprocess.run(command, cwd=desk.folder, capture_output=True, text=True, timeout=500)
    return answer.returncode, answer.stdout + answer.stderr


def same_tables(desk):
    for name in ("study.csv", "points.csv"):
        assert desk.table("cluster", name) == desk.table("local", name)


@needs_snakemake
def test_a_job_for_each_run_with_a_failing_one_in_the_middle(desk):
    study = STUDY.replace("[1, 2, 3]", "[1, 2]").replace("seeds: 2", "seeds: 1")
    study = study.replace(
        "  test/@y: [0, 1]\n", "  case: {values: {good: {test/@y: 1}, bad: {test/@fail: 3}}}\n"
    )
    desk.write(study)
    assert desk.run("--out", "local")[0] == 3
    code, text = snakemake(desk, "cluster")
    # The rule that judges fails; table and page are there all the same.
    assert code == 1 and "2 of 4 runs failed" in text
    same_tables(desk)
    assert (desk.folder / "cluster/study.html").exists()


@needs_snakemake
def test_a_job_for_some_points_with_a_rule_for_the_seeds(desk):
    rule = "seeds: {count: 2, until: {response: load, relative_error: 0.03, most: 8}}"
    desk.write(
        STUDY.replace("seeds: 2", rule) + "job: {points: 2, minutes: 5}\nrun: {keep: nothing}\n"
    )
    assert desk.run("--out", "local", "-j", "2")[0] == 0
    code, text = snakemake(desk, "cluster")
    assert code == 0, text
    same_tables(desk)
    # Nothing is left to do, for Snakemake and for the study alike.
    assert "Nothing to be done" in snakemake(desk, "cluster")[1]
    assert "0 are to be made" in desk.run("--out", "cluster")[1]


def test_the_snakefile_names_a_job_for_each_run(desk):
    desk.write(STUDY + "job: {memory_mb: 2000, minutes: 30}\n")
    code, text = desk.run("--snakemake")
    assert code == 0 and "12 jobs" in text
    assert len(desk.table(name="jobs.txt").splitlines()) == 12
    snakefile = desk.table(name="Snakefile")
    assert "mem_mb=2000" in snakefile and "runtime=30" in snakefile


def test_a_job_whose_run_is_no_longer_in_the_study_is_refused(desk):
    desk.write()
    code, text = desk.run("--run", "x-7_y-0/seed-1")
    assert code == 2 and "The study has no run x-7_y-0/seed-1" in text


def test_a_workflow_gathers_failing_runs_and_judges_them_apart(desk):
    study = STUDY.replace("seeds: 2", "seeds: 1").replace("  test/@y: [0, 1]\n", "")
    case = "case: {values: {good: {test/@x: 1}, bad: {test/@fail: 3}}}"
    desk.write(study.replace("test/@x: [1, 2, 3]", case))
    assert desk.run()[0] == 3
    table = desk.table()
    (desk.folder / "runs/trial/study.csv").unlink()
    assert desk.run("--gather")[0] == 0
    assert desk.table() == table
    assert desk.run("--collect")[0] == 3
    code, text = desk.run("--judge")
    assert code == 3 and "1 of 2 runs failed" in text
