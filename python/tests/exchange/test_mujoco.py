"""The model that MuJoCo loads has the masses, inertias and poses of the run."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pytest

import nilas


@pytest.fixture
def model_file(small_run: nilas.Run, tmp_path: Path) -> Path:
    return small_run.to_mujoco(tmp_path / "model.xml", time=0.3)


def test_each_body_is_in_the_file(small_run: nilas.Run, model_file: Path) -> None:
    root = ElementTree.parse(model_file).getroot()
    names = [body.get("name", "") for body in root.iterfind("worldbody/body")]
    ids = {int(name.rsplit("-", 1)[1]) for name in names}
    assert ids == set(small_run.bodies.ids.tolist())


def test_the_nearest_stored_time_is_taken(small_run: nilas.Run, tmp_path: Path) -> None:
    """0.33 s lies nearest to the frame at 0.3 s; without a time it is the last frame."""
    bodies = small_run.bodies
    for time, frame in ((0.33, 3), (None, -1)):
        file = small_run.to_mujoco(tmp_path / "at.xml", time=time)
        ship = ElementTree.parse(file).getroot().find("worldbody/body[@name='ship-1']")
        if ship is None:
            place = bodies.place("ship")
            name = f"ship-{bodies.ids[place]}"
            ship = ElementTree.parse(file).getroot().find(f"worldbody/body[@name='{name}']")
        assert ship is not None
        position = [float(x) for x in ship.attrib["pos"].split()]
        assert position == pytest.approx(bodies.position[frame, bodies.place("ship")], rel=1e-8)


def test_mujoco_has_the_bodies_of_the_run(small_run: nilas.Run, model_file: Path) -> None:
    mujoco = pytest.importorskip("mujoco", reason="needs the package mujoco of PyPI")
    model = mujoco.MjModel.from_xml_path(str(model_file))
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("nilas").id)
    mujoco.mj_forward(model, data)
    frame = small_run.replay.frame(0.3)
    bodies = small_run.bodies
    time = int(np.argmin(np.abs(bodies.times - 0.3)))
    for body in frame.bodies:
        name = f"{body.name or body.kind}-{body.id}"
        place = bodies.place(body.id)
        at = data.body(name)
        assert at.xpos == pytest.approx(bodies.position[time, place], abs=1e-7)
        if not body.fixed:
            assert model.body(name).mass[0] == pytest.approx(body.mass, rel=1e-6)
            velocity = np.zeros(6)  # angular, then linear, in the axes of the ground
            mujoco.mj_objectVelocity(
                model, data, mujoco.mjtObj.mjOBJ_BODY, model.body(name).id, velocity, 0
            )
            assert velocity[:3] == pytest.approx(bodies.angular_velocity[time, place], abs=1e-7)
            assert velocity[3:] == pytest.approx(bodies.velocity[time, place], abs=1e-7)
    inertia = small_run.summary["vessel"]["inertia_kg_m2"]
    tensor = np.array(inertia)[[0, 3, 4, 3, 1, 5, 4, 5, 2]].reshape(3, 3)
    ship = next(body for body in frame.bodies if body.kind == "vessel")
    found = np.sort(model.body(f"ship-{ship.id}").inertia)
    assert found == pytest.approx(np.sort(np.linalg.eigvalsh(tensor)), rel=1e-6)


def test_mujoco_finds_the_contacts_of_the_hull(model_file: Path) -> None:
    """Floes that touch in the run touch or nearly touch there; nothing is deep in anything."""
    mujoco = pytest.importorskip("mujoco", reason="needs the package mujoco of PyPI")
    model = mujoco.MjModel.from_xml_path(str(model_file))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    deepest = min((contact.dist for contact in data.contact), default=0.0)
    assert deepest > -5e-3
    for _ in range(10):
        mujoco.mj_step(model, data)
    assert np.isfinite(data.qpos).all()
