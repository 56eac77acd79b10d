"""Bodies that come and go, in a run where a sheet breaks beside a fixed pier."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

import nilas


@pytest.fixture
def breaking_run(breaking_folder: Path) -> nilas.Run:
    return nilas.Run(breaking_folder)


def test_broken_floes_vanish_and_their_pieces_appear(breaking_run: nilas.Run) -> None:
    """A floe is there until its event and not after it; a piece the other way round."""
    bodies, events = breaking_run.bodies, breaking_run.events
    assert {"bending", "splitting"} <= set(events.kind)
    there = np.isfinite(bodies.position[:, :, 0])
    known = set(bodies.ids.tolist())
    for event in events.itertuples():
        after = bodies.times >= event.time_s - 1e-9
        if event.floe_id in known:
            assert not there[after, bodies.place(event.floe_id)].any()
        for piece in (int(text) for text in event.pieces.split(";") if text):
            if piece in known:
                assert not there[~after, bodies.place(piece)].any()


def test_the_replay_follows_bodies_that_come_and_go(
    breaking_folder: Path, breaking_run: nilas.Run, tmp_path: Path
) -> None:
    """The same bodies at the same times, within half a unit of their positions."""
    copy = Path(shutil.copytree(breaking_folder, tmp_path / "copy"))
    (copy / "bodies.csv").unlink()
    exact, rounded = breaking_run.bodies, nilas.Run(copy).bodies
    assert rounded.ids.tolist() == exact.ids.tolist()
    assert np.array_equal(np.isnan(rounded.position), np.isnan(exact.position))
    units = {number: body.unit for number, body in breaking_run.replay.bodies().items()}
    limit = 0.5001 * np.array([units[int(number)] for number in exact.ids])[None, :, None]
    assert (np.nan_to_num(np.abs(rounded.position - exact.position)) <= limit).all()


def test_frames_from_the_middle_are_those_of_the_whole(small_scene: Path, tmp_path: Path) -> None:
    """Reading begins at the key frame before the window; 71 frames have several of these."""
    settings = {"output/@trajectory_every": 0.01}
    run = nilas.run(small_scene, out=tmp_path / "fine", settings=settings, until=0.7)
    (tmp_path / "fine" / "bodies.csv").rename(tmp_path / "bodies.csv")
    keys = [place.time for place in run.replay._frames if place.is_key]
    assert len(keys) > 1
    whole = run.bodies
    some = run.read_bodies(between=(0.645, 0.675))
    assert some.times == pytest.approx([0.65, 0.66, 0.67])
    assert np.array_equal(some.position, whole.position[65:68])
    assert np.array_equal(some.orientation, whole.orientation[65:68])


def test_loads_on_fixed_bodies_have_tables(breaking_run: nilas.Run) -> None:
    assert breaking_run.units("structures")["pier_contact_mx_Nm"] == "N m"
    assert len(breaking_run.structures) == len(breaking_run.steps)
    loads = breaking_run.structure_loads
    assert loads.loc[("pier", "contact_fx_N"), "unit"] == "N"
    assert loads.index.names == ["structure", "channel"]


def test_exports_have_the_pieces_and_the_pier(breaking_run: nilas.Run, tmp_path: Path) -> None:
    text = breaking_run.to_mujoco(tmp_path / "broken.xml").read_text()
    bodies = breaking_run.bodies
    there = np.isfinite(bodies.position[-1, :, 0])
    assert text.count("<body ") == there.sum()
    assert 'name="pier-' in text
    assert breaking_run.to_gltf(tmp_path / "broken.glb").stat().st_size > 0
    mujoco = pytest.importorskip("mujoco", reason="needs the package mujoco of PyPI")
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "broken.xml"))
    assert model.nbody == there.sum() + 1  # and the world
