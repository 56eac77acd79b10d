"""Bodies of a run at one time as a MuJoCo model: shapes, masses, inertias, poses, velocities.

MuJoCo's format: https://mujoco.readthedocs.io/en/stable/XMLreference.html
"""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nilas.exchange.snapshot import Motion, moment_of
from nilas.exchange.triangles import Solid, solid_of, triangles_of
from nilas.results.replay import Body, Shape

if TYPE_CHECKING:
    from nilas.results.run import Run

Element = ElementTree.Element
_COLOURS = {
    "floe": "0.86 0.93 0.98 1",
    "vessel": "0.70 0.20 0.15 1",
    "part": "0.55 0.25 0.20 1",
    "body": "0.55 0.55 0.50 1",
    "wall": "0.45 0.50 0.55 0.25",
}
# Groups of geometries that viewers switch on and off: what is seen, and what collides.
_SEEN, _COLLIDES = "2", "3"
_HALF_PLANE = "100 100 1"  # half sizes and grid of a plane as it is drawn [m]


def write_mujoco(run: Run, path: Path, time: float | None) -> Path:
    """Writes the bodies at the stored time nearest to ``time`` [s], or at the last one.

    Floes are one mesh each, which MuJoCo takes as its convex hull in contacts. A hull is drawn
    by its closed mesh and collides by its convex pieces. There is no water in MuJoCo, so gravity
    is off: a body at rest stays. The keyframe ``nilas`` has poses and, where the run has
    bodies.csv, velocities.

    >>> file = write_mujoco(example_run, Path("small.xml"), time=None)
    >>> ElementTree.parse(file).getroot().get("model")
    'small'
    """
    motion = moment_of(run, time)
    root = ElementTree.Element("mujoco", model=str(run.replay.head["scene"]))
    root.append(ElementTree.Comment(f" {run.folder.name} at {motion.poses.times[0]:g} s "))
    ElementTree.SubElement(root, "compiler", angle="radian", balanceinertia="true")
    ElementTree.SubElement(
        root, "option", gravity="0 0 0", timestep=_text([run.replay.head["step"]])
    )
    _add_looks(root)
    assets = ElementTree.SubElement(root, "asset")
    world = ElementTree.SubElement(root, "worldbody")
    ElementTree.SubElement(world, "light", pos="0 0 50", dir="0.2 0.1 -1", directional="true")
    present = _present(motion)
    _add_shapes(assets, motion, present)
    for place, body in present:
        _add_body(world, motion, place, body, _inertia_of_vessel(run, body))
    _add_keyframe(root, motion, present)
    ElementTree.indent(root)
    path.write_text(
        ElementTree.tostring(root, encoding="unicode", xml_declaration=False) + "\n",
        encoding="utf-8",
    )
    return path


def _present(motion: Motion) -> list[tuple[int, Body]]:
    """Bodies that exist at the time, with their places in the arrays."""
    there = np.isfinite(motion.poses.position[0, :, 0])
    return [
        (place, motion.bodies[int(number)])
        for place, number in enumerate(motion.poses.ids)
        if there[place]
    ]


def _add_looks(root: Element) -> None:
    visual = ElementTree.SubElement(root, "visual")
    ElementTree.SubElement(visual, "headlight", ambient="0.4 0.4 0.4", diffuse="0.5 0.5 0.5")
    ElementTree.SubElement(visual, "map", znear="0.001", zfar="100")


def _add_shapes(assets: Element, motion: Motion, present: list[tuple[int, Body]]) -> None:
    """Each shape that is used, once. Pieces that collide have points only: MuJoCo hulls them."""
    used = sorted({body.shape for _, body in present if body.shape is not None})
    for number in used:
        shape = motion.shapes[number]
        _add_mesh(assets, _mesh_name(number), shape, faces=True)
        for count, piece in enumerate(shape.pieces):
            _add_mesh(assets, _mesh_name(number, count), piece, faces=False)


def _add_mesh(assets: Element, name: str, shape: Shape, faces: bool) -> None:
    mesh = ElementTree.SubElement(assets, "mesh", name=name, vertex=_text(shape.points.ravel()))
    if faces:
        triangles = triangles_of(shape.points, shape.polygons)
        mesh.set("face", " ".join(str(corner) for corner in triangles.ravel()))
        # Masses are stated with the bodies. So a mesh need not be closed to a rounding.
        mesh.set("inertia", "shell")


def _add_body(
    world: Element,
    motion: Motion,
    place: int,
    body: Body,
    inertia: NDArray[np.float64] | None,
) -> None:
    element = ElementTree.SubElement(
        world,
        "body",
        name=_body_name(body),
        pos=_text(motion.poses.position[0, place]),
        quat=_text(motion.poses.orientation[0, place]),
    )
    shape = None if body.shape is None else motion.shapes[body.shape]
    if not body.fixed and shape is not None:
        ElementTree.SubElement(element, "freejoint")
        solid = solid_of(shape.points, triangles_of(shape.points, shape.polygons))
        _add_inertia(element, body, solid, inertia)
    colour = _COLOURS[body.kind]
    if shape is None:
        ElementTree.SubElement(element, "geom", type="plane", size=_HALF_PLANE, rgba=colour)
        return
    mesh = _mesh_name(body.shape or 0)
    if not shape.pieces:
        ElementTree.SubElement(element, "geom", type="mesh", mesh=mesh, rgba=colour)
        return
    seen = ElementTree.SubElement(element, "geom", type="mesh", mesh=mesh, rgba=colour)
    for name, value in (("contype", "0"), ("conaffinity", "0"), ("group", _SEEN)):
        seen.set(name, value)
    for count in range(len(shape.pieces)):
        piece = _mesh_name(body.shape or 0, count)
        ElementTree.SubElement(
            element, "geom", type="mesh", mesh=piece, rgba=colour, group=_COLLIDES
        )


def _add_inertia(
    element: Element, body: Body, solid: Solid, inertia: NDArray[np.float64] | None
) -> None:
    """The mass about the centre of mass, which is the origin of the body's frame."""
    if inertia is None:
        tensor = solid.inertia * (body.mass / solid.volume)
        inertia = tensor[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    ElementTree.SubElement(
        element, "inertial", pos="0 0 0", mass=_text([body.mass]), fullinertia=_text(inertia)
    )


def _inertia_of_vessel(run: Run, body: Body) -> NDArray[np.float64] | None:
    """Entries xx yy zz xy xz yz of the vessel, where the summary has them; else None."""
    if body.kind != "vessel" or run.status in ("running", "killed"):
        return None
    entries: Any = (run.summary.get("vessel") or {}).get("inertia_kg_m2")
    return None if entries is None else np.array(entries, dtype=float)


def _add_keyframe(root: Element, motion: Motion, present: list[tuple[int, Body]]) -> None:
    """Poses and velocities of the bodies that move, in the order of the model."""
    moving = [place for place, body in present if not body.fixed and body.shape is not None]
    if not moving:
        return
    poses = motion.poses
    pose = np.concatenate([poses.position[0, moving], poses.orientation[0, moving]], axis=1)
    keyframe = ElementTree.SubElement(root, "keyframe")
    key = ElementTree.SubElement(keyframe, "key", name="nilas", qpos=_text(pose.ravel()))
    if poses.source == "bodies.csv":
        turning = [
            _into_body(poses.orientation[0, place], poses.angular_velocity[0, place])
            for place in moving
        ]
        key.set("qvel", _text(np.concatenate([poses.velocity[0, moving], turning], axis=1).ravel()))


def _into_body(quaternion: NDArray[np.float64], vector: NDArray[np.float64]) -> NDArray[np.float64]:
    """A vector of the ground frame in body axes, in which MuJoCo states angular velocities."""
    w, axis = quaternion[0], -quaternion[1:]
    across = np.cross(axis, vector)
    return np.asarray(vector + 2 * (w * across + np.cross(axis, across)))


def _body_name(body: Body) -> str:
    return f"{body.name or body.kind}-{body.id}"


def _mesh_name(shape: int, piece: int | None = None) -> str:
    return f"shape-{shape}" if piece is None else f"shape-{shape}-piece-{piece + 1}"


def _text(numbers: Iterable[float]) -> str:
    return " ".join(f"{float(number):.9g}" for number in numbers)
