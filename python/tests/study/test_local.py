"""Studies on this machine, with the stand-in for the program."""

import json
import os
import signal

import pytest
from nilas.study import main, needs
from study_desk import SLOW, STAND_IN, STUDY, records, wait_for

from nilas.study.carry_out.launch import Launcher
from nilas.study.describe.plan import Plan
from nilas.study.describe.read_study import read_study

FAILING = """\
name: trial
scene: scene.xml
factors:
  case:
    values: {good: {test/@x: 1}, bad: {test/@fail: 3}, better: {test/@x: 2}}
seeds: 2
responses: [{channel: ice_load.along.mean_N, name: load}]
"""


def test_tables_are_the_same_for_any_number_of_runs_at_a_time(desk):
    desk.write()
    for jobs, out in (("1", "one"), ("2", "two"), ("5", "five")):
        code, text = desk.run("-j", jobs, "--out", out)
        assert code == 0, text
    for name in ("study.csv", "points.csv"):
        assert desk.table("one", name) == desk.table("two", name) == desk.table("five", name)
    assert desk.table("one").splitlines()[0] == "run,point,x,y,seed,status,exit_code,message,load"
    assert len(desk.table("one").splitlines()) == 13


def test_numbers_of_the_table_read_back_to_the_same_bits(desk):
    desk.write()
    assert desk.run()[0] == 0
    stored = {
        name: record["values"]["ice_load.along.mean_N"] for name, record in records(desk).items()
    }
    for line in desk.table().splitlines()[1:]:
        cells = line.split(",")
        assert float(cells[-1]) == stored[cells[0]]


LATE = STUDY.replace("name: load}", "name: load}\n  - {channel: load_error.maen_N, name: late}")


def test_a_name_that_comes_late_is_refused_after_the_first_run(desk):
    """A run of one step has no load_error, so the first whole run shows what is in it."""
    desk.write(LATE + "set: {test/@steps: 2}\n")
    code, text = desk.run()
    assert code == 2
    assert "study.yaml:9: responses.late: summary.json has no number load_error.maen_N" in text
    assert "Did you mean 'load_error.mean_N'? load_error has mean_N and chaos_N." in text
    assert len(records(desk)) == 1 and not (desk.folder / "runs/trial/study.csv").exists()
    desk.write(LATE.replace("maen_N", "chaos_N") + "set: {test/@steps: 2}\n")
    code, text = desk.run()  # this one is in the summary, though no run knows it
    assert len(records(desk)) == 12
    assert code == 2 and "12 runs that are done have no value of load_error.chaos_N" in text


def test_without_the_check_a_wrong_name_is_told_at_the_end(desk):
    desk.write(LATE)
    code, text = desk.run("--no-check")
    assert code == 2 and "12 runs that are done have no value of load_error.maen_N" in text
    assert len(records(desk)) == 12


@pytest.mark.parametrize("words", [("--status",), ("--dry-run",), ("--help",)])
def test_a_reader_that_leaves_is_no_error(desk, words):
    desk.write()
    reading, writing = os.pipe()
    os.close(reading)
    try:
        process = desk.start(*words, stdout=writing)
        errors = process.communicate(timeout=60)[1]
    finally:
        os.close(writing)
    assert (process.returncode, errors) == (0, "")


def test_a_study_goes_on_when_nobody_reads_it(desk):
    desk.write()
    reading, writing = os.pipe()
    os.close(reading)
    try:
        process = desk.start("--no-page", stdout=writing, stderr=writing)
        process.communicate(timeout=120)
    finally:
        os.close(writing)
    assert process.returncode == 0
    assert len(records(desk)) == 12 and len(desk.table().splitlines()) == 13


def test_a_failing_run_in_the_middle_is_recorded_and_stops_nothing(desk):
    desk.write(FAILING)
    code, text = desk.run("-j", "2", page=True)
    assert code == 3
    assert "2 of 6 runs failed" in text
    assert "case-bad/seed-1: error: OUT/runs/case-bad/seed-1: the ice left finite numbers" in text
    lines = desk.table().splitlines()
    assert [line.split(",")[4] for line in lines[1:]] == ["done"] * 2 + ["failed"] * 2 + [
        "done"
    ] * 2
    assert lines[3].endswith(
        ",failed,3,error: OUT/runs/case-bad/seed-1: the ice left finite numbers,"
    )
    page = desk.table(name="study.html")
    assert "Failed runs" in page and "the ice left finite numbers" in page


def test_what_fails_by_its_numerics_is_repeated_only_on_request(desk):
    desk.write(FAILING)
    desk.run()
    before = records(desk)
    assert desk.run()[0] == 3
    assert records(desk) == before
    assert desk.run("--retry-failed")[0] == 3
    after = records(desk)
    repeated = [
        name for name in before if before[name]["times"]["begun"] != after[name]["times"]["begun"]
    ]
    assert all("bad" in name for name in repeated)


def test_what_a_signal_ended_is_tried_again(desk):
    desk.write(FAILING.replace("test/@fail: 3", "test/@die: true"))
    code, text = desk.run()
    assert code == 3 and "Signal SIGKILL ended the program" in text
    desk.write(FAILING.replace("test/@fail: 3", "test/@die: true"))
    assert "4 runs are finished already; 2 are to be made" in desk.run()[1]


def test_a_run_that_takes_too_long_is_ended_and_recorded(desk):
    desk.write(FAILING.replace("test/@fail: 3", "test/@steps: 2000") + "run: {limit_s: 1.5}\n")
    code, text = desk.run("-j", "2")
    assert code == 3 and "The run took longer than limit_s, 1.5 s." in text
    assert desk.table().count(",failed,124,") == 2


def test_a_value_that_the_program_refuses_is_told_before_the_first_run(desk):
    desk.write(STUDY.replace("[1, 2, 3]", "[1, 2, 99]"))
    code, text = desk.run()
    assert code == 2
    assert "study.yaml:4: factors.x: the value 99 is refused" in text and "99 is too large" in text
    assert not records(desk)


def test_a_path_that_the_scene_does_not_have_is_told_with_its_line(desk):
    desk.write(STUDY.replace("test/@y", "test/@why"))
    code, text = desk.run()
    assert code == 2 and "study.yaml:5: factors.why" in text and "there is no such element" in text


def test_seeds_are_added_until_the_mean_is_known(desk):
    # The noise has a deviation of 1 about 10 or 13: an error of
    # 2 % needs some 15 seeds, one of 10 % three.
    rule = "seeds: {count: 3, until: {response: load, relative_error: %s, most: 40}}\n"
    desk.write(STUDY.replace("seeds: 2\n", rule % "0.1").replace("[1, 2, 3]", "[1]"))
    assert desk.run()[0] == 0
    few = len(records(desk))
    desk.write(STUDY.replace("seeds: 2\n", rule % "0.02").replace("[1, 2, 3]", "[1]"))
    assert desk.run("-j", "3")[0] == 0
    assert len(records(desk)) > few >= 6
    header, *lines = (line.split(",") for line in desk.table(name="points.csv").splitlines())
    mean, error = header.index("load_mean"), header.index("load_standard_error")
    assert all(float(line[error]) <= 0.02 * float(line[mean]) for line in lines)
    again = desk.table()
    assert desk.run("-j", "1", "--out", "other")[0] == 0
    assert desk.table("other") == again


@pytest.mark.parametrize(
    ("keep", "files"),
    [
        ("all", {"nilas.log", "record.json", "scene.xml", "summary.json", "vessel.csv"}),
        ("summary", {"nilas.log", "record.json", "scene.xml", "summary.json"}),
        ("record", {"record.json"}),
    ],
)
def test_what_stays_of_a_run(desk, keep, files):
    desk.write(STUDY + f"run: {{keep: {keep}}}\n")
    assert desk.run()[0] == 0
    folder = desk.folder / "runs/trial/runs/x-1_y-0/seed-1"
    assert {file.name for file in folder.iterdir()} == files


def test_parts_hold_the_records_of_many_runs_and_nothing_else_stays(desk):
    desk.write()
    desk.run("--out", "folders")
    desk.write(STUDY + "run: {keep: nothing}\njob: {points: 2}\n")
    assert desk.run("-j", "2", "--out", "parts")[0] == 0
    assert desk.table("parts") == desk.table("folders")
    assert [path.name for path in (desk.folder / "parts/runs").iterdir()] == []
    assert len(list((desk.folder / "parts/parts").iterdir())) == 3
    code, text = desk.run("--out", "parts")
    assert code == 0 and "12 runs are finished already; 0 are to be made" in text


def test_a_column_of_a_table_can_be_a_response(desk):
    # The stand-in writes 1, 3, -8 at 0.1, 0.2, 0.3 s.
    responses = """responses:
  - {column: contact_fx_N, statistic: largest, name: largest}
  - {column: contact_fx_N, statistic: mean, to_s: 0.25, name: early}
  - {column: contact_fx_N, statistic: p99, name: p99}
"""
    desk.write(STUDY[: STUDY.index("responses")] + responses)
    assert desk.run()[0] == 0
    assert desk.table().splitlines()[1].endswith(",done,0,,8,2,7.9")


def test_a_response_that_no_run_has_is_told_with_names_that_exist(desk):
    desk.write(STUDY.replace("along.mean_N", "along.mean"))
    code, text = desk.run()
    assert code == 2 and not records(desk)
    assert "study.yaml:8: responses.load" in text and "Did you mean 'ice_load.along.mean_N'?" in text
    code, text = desk.run("--no-check")
    assert code == 2 and "12 runs that are done have no value of ice_load.along.mean" in text
    # The runs are done: with the right name no run is repeated.
    desk.write()
    code, text = desk.run()
    assert code == 0 and "12 runs are finished already" in text


def test_two_processes_do_not_carry_out_one_study(desk):
    desk.write(SLOW)
    first = desk.start()
    wait_for(
        lambda: (
            (desk.folder / "runs/trial/study.lock").exists()
            and list(desk.folder.rglob("begun.json"))
        )
    )
    code, text = desk.run()
    assert code == 4 and "Another process is carrying out the study" in text
    first.send_signal(signal.SIGINT)
    first.communicate(timeout=120)


def test_missing_packages_are_told_before_any_run(desk, monkeypatch, capsys):
    """Matplotlib is looked for at the begin: without it the page failed after the last run."""
    desk.write()
    monkeypatch.chdir(desk.folder)
    monkeypatch.setattr(needs, "find_spec", lambda name: None if name == "matplotlib" else name)
    words = ["study.yaml", "--program", str(STAND_IN)]
    assert main(words) == 4
    told = capsys.readouterr().err
    assert "Studies need the package matplotlib" in told and "--no-page" in told
    assert not (desk.folder / "runs").exists()
    assert main([*words, "--no-page", "--quiet"]) == 0
    assert len(records(desk)) == 12


def test_without_yaml_the_command_says_so(desk):
    (desk.folder / "yaml.py").write_text("raise ModuleNotFoundError(\"No module named 'yaml'\", name='yaml')\n")
    process = desk.start("--status")  # the folder of the command is searched first
    errors = process.communicate(timeout=60)[1]
    assert process.returncode == 4
    assert "Studies need the package yaml" in errors and "python3-yaml" in errors and "Traceback" not in errors


def test_the_plan_and_the_state_are_told(desk):
    desk.write()
    code, text = desk.run("--dry-run")
    assert (
        code == 0 and "6 points (full), 2 seeds each: 12 runs." in text and "x-1_y-0/seed-1" in text
    )
    assert not (desk.folder / "runs/trial/runs").exists()
    desk.run()
    assert "12 of 12 runs done" in desk.run("--status")[1]
    assert "From 12 finished runs, a run takes" in desk.run("--dry-run")[1]


def test_each_record_says_what_made_the_run(desk):
    desk.write()
    desk.run()
    record = records(desk)["x-1_y-0/seed-1"]
    origin = record["provenance"]
    assert (
        origin["program"]["version"].startswith("nilas") and len(origin["program"]["sha256"]) == 64
    )
    assert len(origin["scene_sha256"]) == len(origin["scene_as_run_sha256"]) == 64
    assert origin["machine"]["name"] and origin["machine"]["cores"] >= 1
    assert origin["command"][1] == "run" and "test/@x=1" in origin["command"]
    assert record["overrides"] == {"test/@x": "1", "test/@y": "0"}


def test_a_scale_is_given_to_the_program_as_its_flag(desk):
    desk.write(STUDY.replace("test/@y: [0, 1]", "--scale: [1, 16]"))
    code, text = desk.run("-j", "3")
    assert code == 0, text
    assert desk.table().splitlines()[0] == "run,point,x,scale,seed,status,exit_code,message,load"
    for name, record in records(desk).items():
        words = record["provenance"]["command"]
        scale = words[words.index("--scale") + 1]
        assert f"scale-{scale}" in name
        assert not any(word.startswith("--scale=") for word in words)


def test_runs_that_vary_in_their_start_have_the_ice_of_the_scene(desk):
    desk.write(STUDY.replace("seeds: 2", "seeds: {count: 2, vary: start}"))
    plan = Plan(read_study(desk.folder / "study.yaml", desk.folder / "runs/trial"))
    launcher = Launcher(plan, STAND_IN)
    first, second = plan.runs(plan.points[0])
    assert "--seed" not in launcher.command(first)
    assert "seed/@twin=1" in launcher.command(first) and "seed/@twin=2" in launcher.command(second)
    assert launcher.key(first) != launcher.key(second)
