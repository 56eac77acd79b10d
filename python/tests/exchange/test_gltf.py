"""The animation has the poses of the run, read back with nothing but json and struct."""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nilas

COMPONENTS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}


def read_glb(file: Path) -> tuple[dict[str, Any], bytes]:
    content = file.read_bytes()
    magic, version, total = struct.unpack_from("<4sII", content)
    assert (magic, version, total) == (b"glTF", 2, len(content))
    length, kind = struct.unpack_from("<I4s", content, 12)
    assert kind == b"JSON" and length % 4 == 0
    at = 20 + length
    size, kind = struct.unpack_from("<I4s", content, at)
    assert kind == b"BIN\0" and size % 4 == 0
    return json.loads(content[20:at]), content[at + 8 :]


def array(document: dict[str, Any], data: bytes, number: int) -> NDArray[Any]:
    accessor = document["accessors"][number]
    view = document["bufferViews"][accessor["bufferView"]]
    kind = {5126: "<f4", 5125: "<u4"}[accessor["componentType"]]
    count = accessor["count"] * COMPONENTS[accessor["type"]]
    values = np.frombuffer(data, kind, count, view["byteOffset"])
    assert view["byteLength"] == values.nbytes
    return values.reshape(accessor["count"], -1)


def channels_of(document: dict[str, Any], node: int) -> dict[str, dict[str, Any]]:
    animation = document["animations"][0]
    return {
        channel["target"]["path"]: animation["samplers"][channel["sampler"]]
        for channel in animation["channels"]
        if channel["target"]["node"] == node
    }


def test_nodes_move_as_the_bodies_did(small_run: nilas.Run, tmp_path: Path) -> None:
    document, data = read_glb(small_run.to_gltf(tmp_path / "small.glb"))
    bodies = small_run.bodies
    nodes = {
        node["extras"]["id"]: k for k, node in enumerate(document["nodes"]) if "extras" in node
    }
    assert set(nodes) == set(bodies.ids.tolist())
    for number, node in nodes.items():
        place = bodies.place(number)
        channels = channels_of(document, node)
        times = array(document, data, channels["translation"]["input"])[:, 0]
        assert times == pytest.approx(bodies.times, abs=1e-6)
        moved = array(document, data, channels["translation"]["output"])
        assert moved == pytest.approx(bodies.position[:, place], abs=1e-6)
        turned = array(document, data, channels["rotation"]["output"])[:, [3, 0, 1, 2]]
        along = np.einsum("ij,ij->i", turned, bodies.orientation[:, place])
        assert np.abs(along) == pytest.approx(1, abs=1e-6)
        assert (np.einsum("ij,ij->i", turned[1:], turned[:-1]) > 0).all()


def test_the_ground_frame_is_turned_so_that_y_is_up(small_run: nilas.Run, tmp_path: Path) -> None:
    """The root turns z of Nilas to y of glTF: q z q* = y."""
    document, _ = read_glb(small_run.to_gltf(tmp_path / "small.glb"))
    root = document["nodes"][document["scenes"][0]["nodes"][0]]
    x, y, z, w = root["rotation"]
    turned = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]
    assert turned == pytest.approx([0, 1, 0], abs=1e-12)


def test_meshes_are_closed_and_face_outwards(small_run: nilas.Run, tmp_path: Path) -> None:
    """Each edge of a floe occurs once in each direction, and its volume is above 0."""
    document, data = read_glb(small_run.to_gltf(tmp_path / "small.glb"))
    floes = [node for node in document["nodes"] if node.get("extras", {}).get("kind") == "floe"]
    for node in floes:
        primitive = document["meshes"][node["mesh"]]["primitives"][0]
        points = array(document, data, primitive["attributes"]["POSITION"]).astype(float)
        corners = array(document, data, primitive["indices"]).reshape(-1, 3).astype(int)
        edges = [(t[k], t[(k + 1) % 3]) for t in corners.tolist() for k in range(3)]
        assert len(set(edges)) == len(edges)
        assert {(b, a) for a, b in edges} == set(edges)
        a, b, c = (points[corners[:, k]] for k in range(3))
        assert np.einsum("ij,ij->", a, np.cross(b, c)) > 0
        accessor = document["accessors"][primitive["attributes"]["POSITION"]]
        assert accessor["min"] == points.min(axis=0).tolist()


def test_bodies_that_break_vanish_at_once(own_folder: Path, tmp_path: Path) -> None:
    table = nilas.Run(own_folder).table("bodies")
    gone, from_time = int(table.id.max()), sorted(table.time_s.unique())[3]
    kept = table[(table.time_s < from_time) | (table.id != gone)]
    kept.to_csv(own_folder / "bodies.csv", index=False)
    document, data = read_glb(nilas.Run(own_folder).to_gltf(tmp_path / "broken.glb"))
    node = next(
        k for k, node in enumerate(document["nodes"]) if node.get("extras", {}).get("id") == gone
    )
    scale = channels_of(document, node)["scale"]
    assert scale["interpolation"] == "STEP"
    assert array(document, data, scale["output"])[:, 0].tolist() == [1, 1, 1, 0, 0, 0]


def test_a_window_begins_at_time_zero(small_run: nilas.Run, tmp_path: Path) -> None:
    document, data = read_glb(small_run.to_gltf(tmp_path / "part.glb", between=(0.15, 0.45)))
    sampler = document["animations"][0]["samplers"][0]
    assert array(document, data, sampler["input"])[:, 0] == pytest.approx([0, 0.1, 0.2], abs=1e-6)
    with pytest.raises(nilas.NoRun, match="no frame from .* The frames are from 0 s to 0.5 s"):
        small_run.to_gltf(tmp_path / "none.glb", between=(5, 6))
    with pytest.raises(nilas.InputError, match="must end in .glb"):
        small_run.to_gltf(tmp_path / "small.gltf")
