"""Simulations in this process."""

import ctypes
import gc
import os
import pathlib
import signal
import threading
import time
import tracemalloc

import nilas
import numpy as np
import pandas
import pytest
from nilas.scene import Element, Scene


def balls(**settings):
    """Two balls, one of which falls, above the ground."""
    scene = Scene(
        Element("time", step=0.01, end=0.5),
        Element("contact", law="coulomb", solver="auto", tolerance=1e-8, integrator="semi-implicit-euler"),
        Element("body", name="ground", shape="plane", fixed=True),
        Element("body", name="one", shape="sphere", radius=0.1, mass=2, position=[0, 0, 0.3]),
        Element("body", name="two", shape="sphere", radius=0.1, mass=1, position=[1, 0, 0.5], velocity=[-1, 0, 0]),
        name="balls",
    )
    return scene.set(settings)


def hashes(simulation, steps):
    return [simulation.step().state_hash for _ in range(steps)]


def test_a_force_accelerates_for_one_step():
    simulation = nilas.Simulation(balls(), applied_loads=True)
    simulation.apply("one", [3, 0, 0])
    simulation.step()
    assert simulation.bodies.velocity[1, 0] == pytest.approx(0.015, abs=1e-15)
    simulation.step()
    assert simulation.bodies.velocity[1, 0] == pytest.approx(0.015, abs=1e-15)
    table = simulation.table()
    assert table["work_applied_J"].iloc[0] == pytest.approx(0.5 * 2 * 0.015**2, abs=1e-14)


def test_the_callback_controls_and_ends_the_run():
    simulation = nilas.Simulation(balls(), applied_loads=True)

    def hold(running):
        running.apply(1, [0, 0, 2 * 9.81 - 50 * running.bodies.velocity[1, 2]])
        return np.bool_(running.steps >= 30)

    simulation.run(callback=hold)
    assert simulation.steps == 30
    assert simulation.bodies.position[1, 2] == pytest.approx(0.3, abs=1e-3)


def test_bits_are_those_of_the_program(tmp_path, small_scene):
    run = nilas.run(small_scene, out=tmp_path / "program")
    simulation = nilas.Simulation(small_scene, folder=tmp_path / "python", threads=2)
    simulation.run()
    there = pandas.read_csv(tmp_path / "program" / "steps.csv", dtype=str)
    here = pandas.read_csv(tmp_path / "python" / "steps.csv", dtype=str)
    timed = [name for name in there.columns if name.startswith("ms_")]
    pandas.testing.assert_frame_equal(here.drop(columns=timed), there.drop(columns=timed))
    assert run.status == "done"
    assert nilas.Run(tmp_path / "python").status == "done"


def test_tables_are_those_of_the_run_folder(tmp_path, small_scene):
    simulation = nilas.Simulation(small_scene, folder=tmp_path / "run")
    simulation.run()
    stored = pandas.read_csv(tmp_path / "run" / "steps.csv", dtype=str)
    stored.index = pandas.Index(stored.pop("time_s").astype(float), name="time_s")  # to the last bit
    table = simulation.table()
    assert list(table.columns) == [c for c in stored.columns if c not in ("status", "state_hash")]
    # the time that outputs take is known once they are written
    timed = [name for name in table.columns if name.startswith("ms_")]
    pandas.testing.assert_frame_equal(
        table.drop(columns=timed), stored[table.columns].drop(columns=timed).astype(float), check_exact=True
    )


def test_poses_have_the_names_and_the_order_of_those_that_are_read(tmp_path, small_scene):
    with nilas.Simulation(small_scene, folder=tmp_path / "run") as simulation:
        simulation.run()
    here, there = simulation.bodies, nilas.Run(tmp_path / "run").bodies
    assert there.source == "bodies.csv" and there.times[-1] == simulation.time
    order = [there.place(number) for number in here.id]
    for name in ("position", "orientation", "velocity", "angular_velocity"):
        assert np.array_equal(getattr(here, name), getattr(there, name)[-1, order])
    # The floes turn about z alone but for their roll and pitch: the scalar part is the first and the largest.
    assert (abs(here.orientation[:, 0]) > abs(here.orientation[:, 1:3]).max()).all()


def test_snapshots_return_to_the_same_bits():
    simulation = nilas.Simulation(balls())
    hashes(simulation, 10)
    now = simulation.snapshot()
    first = hashes(simulation, 20)
    simulation.restore(now)
    assert simulation.steps == 10 and len(simulation.table()) == 10
    assert hashes(simulation, 20) == first


def test_the_problem_of_a_step_can_be_solved_again():
    simulation = nilas.Simulation(balls())
    while simulation.step().contacts == 0:
        pass
    problem = simulation.problem
    again = nilas.solve(problem, solver="newton", tolerance=1e-10)
    assert np.allclose(again.impulses, problem.solution, atol=1e-7)


def test_other_threads_run_during_a_step(small_scene):
    simulation = nilas.Simulation(small_scene)
    counted, running = 0, True

    def count():
        nonlocal counted
        while running:
            counted += 1
            time.sleep(0)

    thread = threading.Thread(target=count)
    thread.start()
    simulation.run(until=0.5)
    running = False
    thread.join()
    assert counted > 10


def test_two_threads_cannot_share_a_simulation(small_scene):
    simulation = nilas.Simulation(small_scene)
    refused = []

    def step():
        try:
            for _ in range(50):
                simulation.step()
        except nilas.InputError as error:
            refused.append(str(error))

    threads = [threading.Thread(target=step) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert refused and all("another thread" in message for message in refused)
    assert simulation.steps > 0


def test_a_forked_process_must_build_its_own():
    simulation = nilas.Simulation(balls(), threads=2)
    simulation.step()
    child = os.fork()
    if child == 0:
        code = 1
        try:
            simulation.step()
        except nilas.InputError as error:
            code = 0 if "forked" in str(error) else 2
        if code == 0 and nilas.Simulation(balls(), threads=2).step().number != 1:
            code = 3
        os._exit(code)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0


def test_ctrl_c_loses_no_step(tmp_path, small_scene):
    simulation = nilas.Simulation(small_scene, settings={"time/@end": 1000}, folder=tmp_path / "run")
    threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        simulation.run()
    with pytest.warns(nilas.UnfinishedRun):
        run = nilas.Run(tmp_path / "run")
    assert run.status == "interrupted"
    assert len(run.steps) == len(simulation.table()) == len(simulation.vessel_table()) == simulation.steps
    assert simulation.last.number == simulation.steps > 0
    with pytest.raises(nilas.InputError, match="run folder is finished"):
        simulation.step()


def test_folders_end_as_their_runs_do(tmp_path):
    with nilas.Simulation(balls(), folder=tmp_path / "early") as simulation:
        simulation.step()
    early = nilas.Run(tmp_path / "early")
    assert early.status == "done" and early.summary["ended_early"]

    def fail(running):
        raise ValueError("the controller failed")

    simulation = nilas.Simulation(balls(), folder=tmp_path / "failed")
    with pytest.raises(ValueError):
        simulation.run(callback=fail)
    with pytest.warns(nilas.UnfinishedRun, match="the controller failed"):
        assert nilas.Run(tmp_path / "failed").status == "failed"
    with pytest.raises(nilas.InputError, match="allowed: done"):
        nilas.Simulation(balls(), folder=tmp_path / "other").close("finished")


def test_a_table_has_each_step_once_whatever_state_it_returned_to():
    """Also that of another simulation, which was further on."""
    other = nilas.Simulation(balls())
    hashes(other, 10)
    at_10 = other.snapshot()
    hashes(other, 5)
    at_15 = other.snapshot()
    simulation = nilas.Simulation(balls())
    hashes(simulation, 3)
    simulation.restore(at_10)
    hashes(simulation, 8)
    simulation.restore(at_15)
    hashes(simulation, 2)
    steps = [*range(1, 4), *range(11, 18)]
    assert np.allclose(simulation.table().index, 0.01 * np.array(steps), rtol=0, atol=1e-12)


def test_snapshots_of_ice_that_breaks():
    scene = pathlib.Path(__file__).parents[1] / "scenes" / "breaking.xml"
    simulation = nilas.Simulation(scene)
    start = simulation.snapshot()
    while simulation.step().floes == simulation.table()["floes"].iloc[0] and not simulation.is_done:
        pass
    assert not simulation.is_done, "no floe broke"
    broken, steps = simulation.snapshot(), simulation.steps
    after = hashes(simulation, 3)
    simulation.restore(broken)
    assert hashes(simulation, 3) == after
    simulation.restore(start)
    assert simulation.steps == 0 and simulation.last is None
    hashes(simulation, steps)
    assert hashes(simulation, 3) == after


def test_a_snapshot_keeps_loads_that_wait():
    simulation = nilas.Simulation(balls(), applied_loads=True)
    simulation.apply(1, [5, 0, 0])
    now = simulation.snapshot()
    first = simulation.step().state_hash
    simulation.restore(now)
    assert simulation.step().state_hash == first


def test_of_many_bodies_the_nearest_are_told():
    scene = balls()
    for number in range(1, 101):
        scene.append(
            Element("body", name=f"stone-{number}", shape="sphere", radius=0.1, mass=1, position=[number, 2, 1])
        )
    simulation = nilas.Simulation(scene, applied_loads=True)
    with pytest.raises(nilas.UnknownName) as caught:
        simulation.apply("stone-101", [1, 0, 0])
    assert isinstance(caught.value, nilas.InputError)
    assert str(caught.value) == (
        "There is no body 'stone-101'; did you mean stone-11, stone-10 or stone-100? "
        "There are 103 bodies, from ground to stone-100."
    )


def test_faults_say_what_is_allowed(tmp_path):
    simulation = nilas.Simulation(balls())
    with pytest.raises(nilas.InputError, match="applied_loads"):
        simulation.apply(1, [1, 0, 0])
    loaded = nilas.Simulation(balls(), applied_loads=True)
    with pytest.raises(nilas.InputError, match="did you mean"):
        loaded.apply("ones", [1, 0, 0])
    with pytest.raises(nilas.InputError, match=r"force has the shape \(2,\)"):
        loaded.apply(1, [1, 0])
    for wrong in (100.0, None, ["a", 0, 0], np.ones((1, 3))):
        with pytest.raises(nilas.InputError, match="force"):
            loaded.apply(1, wrong)
    with pytest.raises(ValueError, match="read-only"):
        loaded.bodies.velocity[0] = [1, 0, 0]
    with pytest.raises(nilas.InputError, match="index or its name"):
        loaded.apply(None, [1, 0, 0])
    with pytest.raises(nilas.InputError, match="The command rudder is a number; found '1'"):
        simulation.command(rudder="1")
    with pytest.raises(nilas.InputError, match="nothing to command"):
        simulation.command(rudder=1)
    with pytest.raises(nilas.InputError, match="has no vessel"):
        simulation.vessel_table()
    with pytest.raises(nilas.FileError, match="no-such-scene.xml"):
        nilas.Simulation(tmp_path / "no-such-scene.xml")
    with pytest.raises(nilas.InputError, match="scene is a nilas.Scene or the path of a file; found None"):
        nilas.Simulation(None)
    with pytest.raises(nilas.InputError, match="settings is a dict"):
        nilas.Simulation(tmp_path / "scene.xml", settings=[("time/@end", 2)])
    with pytest.raises(nilas.InputError, match="until is a number; found '3'"):
        simulation.run(until="3")
    with pytest.raises(nilas.InputError, match="at least 1"):
        nilas.Simulation(balls(), threads=0)
    (tmp_path / "run").mkdir()
    (tmp_path / "run" / "mine.txt").write_text("kept")
    with pytest.raises(nilas.InputError, match="not empty"):
        nilas.Simulation(balls(), folder=tmp_path / "run")
    assert (tmp_path / "run" / "mine.txt").read_text() == "kept"


class Mallinfo(ctypes.Structure):
    """What mallinfo2() of glibc returns."""

    _fields_ = [
        (name, ctypes.c_size_t)
        for name in "arena ordblks smblks hblks hblkhd usmblks fsmblks uordblks fordblks keepcost".split()
    ]


def bytes_in_use():
    count = ctypes.CDLL(None).mallinfo2
    count.restype = Mallinfo
    found = count()
    return found.uordblks + found.hblkhd


def test_without_a_table_memory_stays_the_same():
    simulation = nilas.Simulation(balls(), settings={"time/@end": 1000}, keep_table=False)
    simulation.run(until=5)
    gc.collect()
    tracemalloc.start()
    before, traced = bytes_in_use(), tracemalloc.get_traced_memory()[0]
    simulation.run(until=15)  # 1000 steps, whose table has more than 200 kB
    gc.collect()
    grown, grown_of_python = bytes_in_use() - before, tracemalloc.get_traced_memory()[0] - traced
    tracemalloc.stop()
    assert simulation.steps == 1500
    assert grown < 40_000 and grown_of_python < 10_000
    assert len(simulation.last.numbers) == len(simulation._core.step_columns) > 25
    for table in (simulation.table, nilas.Simulation(balls(), keep_table=False).table):
        with pytest.raises(nilas.InputError, match="keeps no table, as keep_table=False asks"):
            table()


def test_a_simulation_without_a_table_has_the_same_bits_and_goes_back(small_scene):
    simulation = nilas.Simulation(small_scene, keep_table=False)
    start = simulation.snapshot()
    first = hashes(simulation, 5)
    simulation.restore(start)
    assert hashes(simulation, 5) == first == hashes(nilas.Simulation(small_scene), 5)
    with pytest.raises(nilas.InputError, match="keeps no table"):
        simulation.vessel_table()


def test_memory_stays_over_many_steps():
    simulation = nilas._core.Simulation(balls().check({"time/@end": 1000}), applied_loads=True)
    steps, before = 4000, 0
    for k in range(steps):
        simulation.apply(1, [0, 0, 1], [0, 0, 0], None)
        simulation.step()
        simulation.bodies.position
        if k + 1 == steps // 2:
            before = bytes_in_use()
    grown = bytes_in_use() - before
    table = simulation.rows.nbytes  # kept in a list that doubles when it is full
    assert table > 0
    assert grown < table + 100_000, f"{(grown - table) / (steps // 2):.0f} bytes a step beside the table"
