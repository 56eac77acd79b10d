"""The motion of a run as an animation in glTF 2.0, in one binary file (.glb).

The format: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
"""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nilas.errors import InputError
from nilas.exchange.snapshot import Motion, motion_of, with_steady_signs
from nilas.exchange.triangles import triangles_of
from nilas.results.replay import Body

if TYPE_CHECKING:
    from nilas.results.run import Run

_MAGIC, _VERSION = b"glTF", 2
_JSON, _BIN = b"JSON", b"BIN\0"
_FLOAT, _UNSIGNED = 5126, 5125
_OF_POINTS, _OF_TRIANGLES = 34962, 34963  # what a buffer view is for
_TYPES = {1: "SCALAR", 3: "VEC3", 4: "VEC4"}
# glTF has y up. This turns the ground frame, which has z up, by -90 degrees about x.
_Z_UP = [-(0.5**0.5), 0.0, 0.0, 0.5**0.5]
_COLOURS = {
    "floe": [0.75, 0.86, 0.94, 1.0],
    "vessel": [0.45, 0.05, 0.03, 1.0],
    "part": [0.30, 0.06, 0.04, 1.0],
    "body": [0.30, 0.30, 0.25, 1.0],
    "water": [0.02, 0.10, 0.20, 0.6],
}
_HIDDEN, _SHOWN = 0.0, 1.0  # scales of a body before it comes or after it broke, and else


def write_gltf(run: Run, path: Path, between: tuple[float, float] | None) -> Path:
    """Writes all bodies but planes and tank walls, with their motion as one animation.

    Each body is a node with its id as an extra property. The time of the animation begins at 0
    at the first frame. A floe that broke shrinks to nothing at once, and its pieces appear.

    >>> write_gltf(example_run, Path("small.glb"), between=(0, 0.2)).read_bytes()[:4]
    b'glTF'
    """
    if path.suffix.lower() != ".glb":
        raise InputError(f"{path}: the name must end in .glb, the binary form of glTF.")
    motion = motion_of(run, between)
    document = _Document()
    nodes = []
    for place, number in enumerate(motion.poses.ids):
        body = motion.bodies[int(number)]
        if body.shape is not None and body.kind != "wall":
            nodes.append(_add_body(document, motion, place, body))
    level = run.replay.head.get("water_level")
    if level is not None:
        nodes.append(_add_water(document, motion, float(level)))
    document.nodes.append({"name": "ground frame", "rotation": _Z_UP, "children": nodes})
    document.write(path, str(run.replay.head["scene"]))
    return path


class _Document:
    """The parts of a file while it grows: lists of JSON objects, and the bytes of all arrays."""

    def __init__(self) -> None:
        self.nodes: list[dict[str, Any]] = []
        self.meshes: list[dict[str, Any]] = []
        self.materials: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []
        self.views: list[dict[str, Any]] = []
        self.samplers: list[dict[str, Any]] = []
        self.channels: list[dict[str, Any]] = []
        self.bytes = bytearray()
        self._meshes: dict[tuple[int, str], int] = {}
        self._materials: dict[str, int] = {}
        self.times: int | None = None  # the accessor that all samplers share

    def add_array(
        self, values: NDArray[Any], target: int | None = None, bounds: bool = False
    ) -> int:
        """Adds an array of shape (n,) or (n, components) and returns the number of its accessor."""
        floats = values.dtype.kind == "f"
        packed = np.ascontiguousarray(values, dtype="<f4" if floats else "<u4")
        view: dict[str, Any] = {
            "buffer": 0,
            "byteOffset": len(self.bytes),
            "byteLength": packed.nbytes,
        }
        if target is not None:
            view["target"] = target
        self.views.append(view)
        self.bytes += packed.tobytes()
        components = 1 if packed.ndim == 1 else packed.shape[1]
        accessor: dict[str, Any] = {
            "bufferView": len(self.views) - 1,
            "componentType": _FLOAT if floats else _UNSIGNED,
            "count": len(packed),
            "type": _TYPES[components],
        }
        if bounds:
            table = packed.reshape(len(packed), components)
            accessor["min"], accessor["max"] = (
                table.min(axis=0).tolist(),
                table.max(axis=0).tolist(),
            )
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def material(self, kind: str) -> int:
        if kind not in self._materials:
            look = {
                "baseColorFactor": _COLOURS[kind],
                "metallicFactor": 0.0,
                "roughnessFactor": 0.2 if kind == "water" else 0.8,
            }
            material: dict[str, Any] = {"name": kind, "pbrMetallicRoughness": look}
            if kind == "water":
                material["alphaMode"] = "BLEND"
                material["doubleSided"] = True
            self.materials.append(material)
            self._materials[kind] = len(self.materials) - 1
        return self._materials[kind]

    def mesh(self, motion: Motion, body: Body) -> int:
        """The mesh of a body's shape; bodies of one shape and kind share it."""
        number = body.shape or 0
        key = (number, body.kind)
        if key not in self._meshes:
            shape = motion.shapes[number]
            # Without normals a viewer shades each triangle flat, as ice is. Edges then show.
            self._meshes[key] = self.add_mesh(
                f"shape {number}",
                shape.points,
                triangles_of(shape.points, shape.polygons),
                body.kind,
            )
        return self._meshes[key]

    def add_mesh(
        self,
        name: str,
        points: NDArray[np.float64],
        triangles: NDArray[np.int64],
        kind: str,
    ) -> int:
        primitive = {
            "attributes": {"POSITION": self.add_array(points, _OF_POINTS, bounds=True)},
            "indices": self.add_array(triangles.ravel(), _OF_TRIANGLES),
            "material": self.material(kind),
        }
        self.meshes.append({"name": name, "primitives": [primitive]})
        return len(self.meshes) - 1

    def animate(self, node: int, path: str, values: NDArray[np.float64], how: str) -> None:
        """Adds values over the shared times for one property of a node."""
        assert self.times is not None
        self.samplers.append(
            {"input": self.times, "output": self.add_array(values), "interpolation": how}
        )
        self.channels.append(
            {"sampler": len(self.samplers) - 1, "target": {"node": node, "path": path}}
        )

    def write(self, path: Path, name: str) -> None:
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        content: dict[str, Any] = {
            "asset": {"version": "2.0", "generator": "Nilas"},
            "scene": 0,
            "scenes": [{"name": name, "nodes": [len(self.nodes) - 1]}],
            "nodes": self.nodes,
            "meshes": self.meshes,
            "materials": self.materials,
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": len(self.bytes)}],
        }
        if self.channels:
            content["animations"] = [
                {"name": "motion", "samplers": self.samplers, "channels": self.channels}
            ]
        text = json.dumps(content, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        total = 12 + 8 + len(text) + 8 + len(self.bytes)
        with path.open("wb") as file:
            file.write(_MAGIC + struct.pack("<II", _VERSION, total))
            file.write(struct.pack("<I", len(text)) + _JSON + text)
            file.write(struct.pack("<I", len(self.bytes)) + _BIN + self.bytes)


def _add_body(document: _Document, motion: Motion, place: int, body: Body) -> int:
    """A node with the body's mesh and its motion; returns its number."""
    position = motion.poses.position[:, place]
    there = np.isfinite(position[:, 0])
    # While a body does not exist it waits, without size, where it was last or will be first.
    known = np.flatnonzero(there)
    nearest = known[np.abs(np.arange(len(there))[:, None] - known).argmin(axis=1)]
    position = position[nearest]
    turn = with_steady_signs(motion.poses.orientation[nearest, place])[:, [1, 2, 3, 0]]
    node = len(document.nodes)
    document.nodes.append(
        {
            "name": f"{body.name or body.kind} {body.id}",
            "mesh": document.mesh(motion, body),
            "translation": position[0].tolist(),
            "rotation": turn[0].tolist(),
            "scale": [_SHOWN if there[0] else _HIDDEN] * 3,
            "extras": {"id": body.id, "kind": body.kind},
        }
    )
    if len(there) < 2:
        return node
    if document.times is None:
        times = motion.poses.times
        document.times = document.add_array(times - times[0], bounds=True)
    if np.ptp(position, axis=0).any() or np.ptp(turn, axis=0).any():
        document.animate(node, "translation", position, "LINEAR")
        document.animate(node, "rotation", turn, "LINEAR")
    if not there.all():
        size = np.where(there, _SHOWN, _HIDDEN)[:, None] * np.ones(3)
        document.animate(node, "scale", size, "STEP")
    return node


def _add_water(document: _Document, motion: Motion, level: float) -> int:
    """Still water around all bodies: one rectangle."""
    margin = 0.1  # share of the longer side
    plan = motion.poses.position[:, :, :2].reshape(-1, 2)
    low, high = np.nanmin(plan, axis=0), np.nanmax(plan, axis=0)
    edge = margin * float((high - low).max()) + 1.0
    (x0, y0), (x1, y1) = low - edge, high + edge
    points = np.array([[x0, y0, level], [x1, y0, level], [x1, y1, level], [x0, y1, level]])
    mesh = document.add_mesh("water", points, np.array([[0, 1, 2], [0, 2, 3]]), "water")
    document.nodes.append({"name": "water", "mesh": mesh})
    return len(document.nodes) - 1
