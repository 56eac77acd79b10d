"""Studies that were stopped, killed or changed, and go on."""

import json
import signal
import time

from study_desk import SLOW, STAND_IN, STUDY, records, wait_for

from nilas.study.carry_out.launch import Launcher
from nilas.study.carry_out.progress import Progress
from nilas.study.carry_out.queue import queue_of
from nilas.study.carry_out.records import Records
from nilas.study.carry_out.schedule import Scheduler
from nilas.study.describe.plan import Plan
from nilas.study.describe.read_study import read_study


def test_finished_runs_are_not_repeated(desk):
    desk.write()
    desk.run()
    before = records(desk)
    code, text = desk.run("-j", "2")
    assert code == 0 and "12 runs are finished already" in text
    assert records(desk) == before


def test_ctrl_c_lets_runs_write_checkpoints_and_the_same_command_resumes_them(desk):
    desk.write(SLOW)
    assert desk.run("--out", "whole", "-j", "3")[0] == 0
    process = desk.start("-j", "2")
    runs = desk.folder / "runs/trial/runs"
    wait_for(lambda: len(records(desk)) >= 3 and _all_stored(runs))
    process.send_signal(signal.SIGINT)
    errors = process.communicate(timeout=120)[1]
    assert process.returncode == 130 and "The same command continues it" in errors
    stopped = [file.parent for file in runs.rglob("begun.json")]
    assert stopped and all((folder / "checkpoint.h5").exists() for folder in stopped)
    code, text = desk.run("-j", "2")
    assert code == 0, text
    resumed = {name: record["values"]["sessions"] for name, record in records(desk).items()}
    assert all(resumed[str(folder.relative_to(runs))] == 2 for folder in stopped)
    assert desk.table() == desk.table("whole")


def _all_stored(runs):
    """Whether two runs are under way and both have a checkpoint."""
    begun = [file.parent for file in runs.rglob("begun.json")]
    return len(begun) == 2 and all((folder / "checkpoint.h5").exists() for folder in begun)


def test_a_study_that_is_killed_continues_and_its_runs_stop_with_it(desk):
    desk.write(SLOW)
    assert desk.run("--out", "whole", "-j", "3")[0] == 0
    process = desk.start("-j", "2")
    runs = desk.folder / "runs/trial/runs"
    wait_for(lambda: len(records(desk)) >= 2 and len(list(runs.rglob("checkpoint.h5"))) > 2)
    process.kill()
    process.communicate()
    # The system tells the runs that the study died; they store a checkpoint and end.
    wait_for(lambda: _is_quiet(desk))
    done = records(desk)
    code, text = desk.run("-j", "2")
    assert code == 0, text
    assert {name: records(desk)[name] for name in done} == done
    assert desk.table() == desk.table("whole")


def _is_quiet(desk):
    before = {file: file.stat().st_mtime_ns for file in desk.folder.rglob("checkpoint.h5")}
    time.sleep(0.2)
    return before == {file: file.stat().st_mtime_ns for file in desk.folder.rglob("checkpoint.h5")}


def test_a_run_that_cannot_be_continued_begins_again(desk):
    desk.write(SLOW)
    plan = Plan(read_study(desk.folder / "study.yaml", desk.folder / "runs/trial"))
    process = desk.start()
    folder = plan.folder(plan.run(plan.points[0], 0))
    wait_for((folder / "checkpoint.h5").exists)
    process.send_signal(signal.SIGTERM)
    process.communicate(timeout=120)
    assert process.returncode == 130
    (folder / "checkpoint.h5").write_text("torn")
    code, text = desk.run("-j", "3")
    assert code == 0 and "cannot be continued and begins again" in text


def test_a_run_of_another_scene_is_not_resumed(desk):
    desk.write(SLOW)
    process = desk.start()
    wait_for(lambda: list(desk.folder.rglob("checkpoint.h5")))
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=120)
    desk.write(SLOW.replace("steps: 25", "steps: 2"))
    code, text = desk.run("-j", "3")
    if "were made of another scene" in text:
        code, text = desk.run("-j", "3", "--force")
    assert code == 0, text
    assert all(record["values"]["sessions"] == 1 for record in records(desk).values())


def test_a_changed_scene_is_not_mixed_with_old_runs(desk):
    desk.write()
    desk.run()
    (desk.folder / "scene.xml").write_text('<scene version="1" name="other"/>')
    code, text = desk.run()
    assert code == 2 and "12 finished runs" in text and "--force" in text
    assert desk.run("--force")[0] == 0
    assert desk.run()[0] == 0


def test_a_changed_input_of_the_scene_counts_as_a_changed_scene(desk):
    (desk.folder / "scene.xml").write_text('<scene version="1"><vessel hull="hull.stl"/></scene>')
    (desk.folder / "hull.stl").write_text("one")
    desk.write()
    desk.run()
    (desk.folder / "hull.stl").write_text("two")
    assert desk.run()[0] == 2


def test_more_levels_add_runs_and_repeat_none(desk):
    desk.write()
    desk.run()
    before = records(desk)
    desk.write(STUDY.replace("[1, 2, 3]", "[1, 2, 3, 4]"))
    code, text = desk.run()
    assert code == 0 and "12 runs are finished already; 4 are to be made" in text
    assert {name: records(desk)[name] for name in before} == before


def test_a_session_that_is_out_of_time_stops_and_can_go_on(desk):
    desk.write(SLOW)
    plan = Plan(read_study(desk.folder / "study.yaml", desk.folder / "runs/trial"))
    plan.make_folders()
    found, launcher = Records(plan), Launcher(plan, STAND_IN)
    queue = queue_of(plan, found, plan.points, launcher.key, False, False)
    ends_at = time.monotonic() + 1.3
    outcome = Scheduler(queue, found, launcher, 1, Progress(0, True), ends_at).carry_out()
    assert outcome.out_of_time and outcome.interrupted and 1 <= outcome.ran < 12
    # Runs of half a second: the one under way stored its state and stopped.
    assert time.monotonic() < ends_at + 10
    code, text = desk.run("-j", "3")
    assert code == 0, text
    assert len(records(desk)) == 12
