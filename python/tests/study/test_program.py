"""Studies with the program itself: a few floes drift onto a pier for a second."""

import json
import signal
import time
from pathlib import Path

import nilas
import pytest
from nilas.program import NotFound, program
from nilas.study.carry_out.outputs import outputs_of
from nilas.study.carry_out.record import flat_numbers
from nilas.study.describe.study import Response

BREAKING = Path(__file__).resolve().parents[1] / "scenes/breaking.xml"
SCENE = Path(__file__).resolve().parents[3] / "tests/slurm/pier.xml"
STUDY = """\
name: trial
scene: pier.xml
factors:
  ice/field/@concentration: [0.4, 0.6]
  "contact/friction[1]/@static":
    {name: friction, also: "contact/friction[1]/@kinetic", values: [0.1, 0.3]}
seeds: 2
run: {checkpoint_every: 0.1}
responses:
  - {channel: structures.pier.loads.ice_resistance_N.mean_N, name: load}
  - {table: structures.csv, column: pier_contact_fx_N, statistic: largest, name: peak}
"""


def _program():
    try:
        return program()
    except NotFound as error:
        pytest.skip(str(error))


@pytest.fixture
def pier(desk):
    desk.program = _program()
    (desk.folder / "pier.xml").write_text(SCENE.read_text())
    desk.write(STUDY)
    return desk


def records(desk):
    return {str(file): json.loads(file.read_text()) for file in desk.folder.rglob("record.json")}


def test_a_study_gives_the_same_table_for_one_and_two_runs_at_a_time(pier):
    for jobs, out in (("1", "one"), ("2", "two")):
        code, text = pier.run("-j", jobs, "--out", out, program=pier.program)
        assert code == 0, text
    assert pier.table("one") == pier.table("two")
    rows = [line.split(",") for line in pier.table("one").splitlines()[1:]]
    assert len(rows) == 8
    # Each concentration and seed is other ice on the pier. Friction acts where floes meet only.
    ice = {(row[2], row[4]): row[-2] for row in rows}
    assert len(ice) == len(set(ice.values())) == 4 and all(float(load) > 0 for load in ice.values())


def test_a_run_that_was_stopped_resumes_and_ends_with_the_same_bits(pier):
    pier.write(STUDY.replace("seeds: 2", "seeds: 1\nset: {time/@end: 8}"))
    assert pier.run("-j", "2", "--out", "whole", program=pier.program)[0] == 0
    process = pier.start("--no-page", program=pier.program)
    end = time.monotonic() + 120
    while not list((pier.folder / "runs/trial").rglob("checkpoint.h5")):
        assert time.monotonic() < end and process.poll() is None
        time.sleep(0.01)
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=120)
    assert process.returncode == 130
    code, text = pier.run("-j", "2", program=pier.program)
    assert code == 0, text
    resumed = [record for record in records(pier).values() if record["provenance"]["resumed"]]
    assert resumed and all("--resume" in record["provenance"]["command"] for record in resumed)
    assert pier.table() == pier.table("whole")


def test_what_the_program_refuses_is_recorded_in_its_own_words(pier):
    study = STUDY.replace("values: [0.1, 0.3]", "values: [0.1, -1, 0.3]").replace(
        "seeds: 2", "seeds: 1"
    )
    pier.write(study)
    code, text = pier.run("-j", "2", program=pier.program)
    assert code == 3
    failed = [record for record in records(pier).values() if record["status"] == "failed"]
    assert len(failed) == 2 and all(record["exit_code"] == 2 for record in failed)
    assert all("<friction kinetic>: found '-1'" in record["message"] for record in failed)


def test_a_wrong_path_is_told_with_its_line_in_the_study(pier):
    pier.write(STUDY.replace("ice/field/@concentration", "ice/field/@concentraton"))
    code, text = pier.run(program=pier.program)
    assert code == 2
    assert "study.yaml:4: factors.concentraton" in text and "concentration" in text


def test_a_response_that_summary_json_does_not_have_is_told_with_its_nearest_name(pier):
    pier.write(STUDY.replace("ice_resistance_N.mean_N", "ice_resistence_N.mean_N"))
    code, text = pier.run("-j", "2", program=pier.program)
    assert code == 2
    assert "study.yaml:10: responses.load: summary.json has no number" in text
    assert "Did you mean 'structures.pier.loads.ice_resistance_N" in text
    assert not records(pier), "a run was made"


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ("{channel: ice_load.along.mean_N, name: peak}", ["no number ice_load.along.mean_N", "It has time_end_s"]),
        ("{channel: structures.pier.loads.contact_fx_N, name: peak}", ["structures.pier.loads.contact_fx_N has mean_N"]),
        ("{channel: wall_s, name: peak}", ["wall_s differs between runs of one scene"]),
        ("{table: steps.csv, column: kinetik_J, name: peak}", ["Did you mean 'kinetic_J'", "It has time_s"]),
        ("{column: x_m, name: peak}", ["The runs write no vessel.csv", "structures.csv"]),
    ],
)
def test_a_response_that_no_run_has_is_refused_before_the_first_run(pier, wrong, words):
    right = STUDY.splitlines()[-1]
    pier.write(STUDY.replace(right, f"  - {wrong}"))
    for option in ((), ("--dry-run",), ("--snakemake",)):
        code, text = pier.run(*option, program=pier.program)
        assert code == 2 and "study.yaml:11: responses.peak: " in text
        for word in words:
            assert word in text
    assert not (pier.folder / "runs/trial/study.csv").exists() and not records(pier)


def test_a_response_that_only_some_points_have_is_no_fault(pier):
    factors = """\
  post:
    values: {no: {ice/@density: 900}, yes: {"body[+]/@name": post, "body[@name='post']/@shape": box,
             "body[@name='post']/@size": 1 1 1, "body[@name='post']/@position": 40 9 0, "body[@name='post']/@fixed": true}}
"""
    begin, end = STUDY.index("  ice/field"), STUDY.index("seeds:")
    study = STUDY[:begin] + factors + STUDY[end:].replace("structures.pier.", "structures.post.")
    pier.write(study.replace("seeds: 2", "seeds: 1"))
    code, text = pier.run(program=pier.program)
    assert "1 runs that are done have no value of structures.post.loads" in text
    assert code == 0 and len(records(pier)) == 2


def test_what_a_run_of_one_step_has_are_the_names_of_a_whole_run(tmp_path, breaking_folder):
    """What counts as unknown before the first run must be unknown in every run."""
    nilas.run(BREAKING, out=tmp_path / "short", until=1e-7, threads=1)
    short, whole = outputs_of(tmp_path / "short", is_whole=False), outputs_of(breaking_folder)
    names = flat_numbers(whole.summary)
    assert len(names) > 300
    assert not [name for name in names if short.has(Response("r", "", channel=name)) is False]
    assert short.columns == whole.columns
    for name in names:
        assert whole.has(Response("r", "", channel=name)) is True
    assert short.has(Response("r", "", channel="ice_load.along.maen_N")) is False
