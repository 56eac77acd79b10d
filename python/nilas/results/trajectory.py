"""The frames of a run that ParaView shows, as numpy arrays: trajectory.pvd and its VTP files."""

from __future__ import annotations

import base64
import re
import struct
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nilas.names import unknown
from nilas.results.folder import NoRun
from nilas.results.lz4 import expand

_ENTRY = re.compile(
    r'<DataSet timestep="([^"]*)" part="[^"]*" name="([^"]*)" file="([^"]*)"/>', re.ASCII
)
_TYPES = {
    "Float32": "<f4",
    "Float64": "<f8",
    "Int32": "<i4",
    "Int64": "<i8",
    "UInt8": "u1",
}


@dataclass
class Surface:
    """Polygons or points in the ground frame G at one time.

    ``points``: shape (points, 3) [m]. ``corners``: indices into the points, all polygons in turn.
    ``ends``: for each polygon the place after its last corner. ``cells``: arrays with one entry
    per polygon, such as ``id`` and ``speed_m_s``. ``values``: arrays with one entry per point,
    such as ``force_N``. ``bodies``: name of each body by its id.

    >>> hull = example_run.trajectory.surface("vessel", 0)
    >>> hull.points.shape[1], int(hull.ends[-1]) == len(hull.corners), len(hull) == len(hull.ends)
    (3, True, True)
    >>> list(hull.bodies.values())
    ['ship']
    """

    points: NDArray[np.float64]
    corners: NDArray[np.int64]
    ends: NDArray[np.int64]
    cells: dict[str, NDArray[np.generic]] = field(default_factory=dict)
    values: dict[str, NDArray[np.generic]] = field(default_factory=dict)
    bodies: dict[int, str] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.ends)

    def polygon(self, number: int) -> NDArray[np.float64]:
        """The corners of one polygon, shape (corners, 3) [m].

        >>> example_run.trajectory.surface("ice floes", 0).polygon(0).shape[1]
        3
        """
        begin = int(self.ends[number - 1]) if number > 0 else 0
        corners = self.corners[begin : int(self.ends[number])]
        return np.asarray(self.points[corners])

    def upper_faces(self) -> dict[int, NDArray[np.float64]]:
        """The upper face of each floe by its id, shape (corners, 3) [m].

        A floe's polygons are its lower face, its upper face and its sides, in that order.

        >>> faces = example_run.trajectory.surface("ice floes", 0).upper_faces()
        >>> all(len(face) >= 3 for face in faces.values())
        True
        """
        ids = np.asarray(self.cells["id"], dtype=np.int64)
        changes = np.flatnonzero(np.diff(ids, prepend=-1))
        return {int(ids[start]): self.polygon(int(start) + 1) for start in changes}


class Trajectory:
    """Frames of a run over time.

    >>> trajectory = example_run.trajectory
    >>> trajectory.blocks[:2]
    ['ice floes', 'vessel']
    >>> trajectory.surface("vessel", time=0.2).points.shape[1]
    3
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        list_file = folder / "trajectory.pvd"
        if not list_file.is_file():
            raise NoRun(
                f"{folder}: this run stored no trajectory; <output trajectory_every> asks for it."
            )
        self._frames: dict[float, dict[str, str]] = {}
        for time, name, file in _ENTRY.findall(list_file.read_text(encoding="utf-8")):
            self._frames.setdefault(float(time), {})[name] = file

    @property
    def times(self) -> NDArray[np.float64]:
        """Times of the frames, shape (frames,) [s].

        >>> example_run.trajectory.times.tolist()
        [0.0, 0.1, 0.2, 0.3, 0.4, 0.5]
        """
        return np.array(sorted(self._frames))

    @property
    def blocks(self) -> list[str]:
        """Names of what the frames show, such as ``ice floes``, ``vessel``, ``contact forces``.

        >>> "contact forces" in example_run.trajectory.blocks
        True
        """
        names: dict[str, None] = {}
        for frame in self._frames.values():
            names.update(dict.fromkeys(frame))
        return list(names)

    def surface(self, block: str, time: float) -> Surface:
        """One block of the frame nearest to a time [s].

        >>> "force_N" in example_run.trajectory.surface("contact forces", 0.3).values
        True
        """
        if not self._frames:
            raise NoRun(f"{self._folder}: trajectory.pvd lists no frame yet.")
        nearest = min(self._frames, key=lambda at: (abs(at - time), at))
        frame = self._frames[nearest]
        if block not in frame:
            raise unknown(f"The frames have no block '{block}'", block, frame)
        return read_vtp(self._folder / frame[block])

    def surfaces(self, block: str) -> Iterator[tuple[float, Surface]]:
        """Time [s] and surface of all frames in turn, each read when its turn comes.

        >>> times = [time for time, ice in example_run.trajectory.surfaces("ice floes")]
        >>> times == list(example_run.trajectory.times)
        True
        """
        for time in self.times:
            yield float(time), self.surface(block, time)


def read_vtp(file: Path) -> Surface:
    """A VTP file as Nilas writes it: polygons or points with their data.

    >>> file = sorted(example_folder.rglob("*.vtp"))[0]
    >>> read_vtp(file).points.shape[1]
    3
    """
    try:
        root = ElementTree.parse(file).getroot()
    except FileNotFoundError:
        raise NoRun(f"{file}: trajectory.pvd lists this file, and it is missing.") from None
    except ElementTree.ParseError as fault:
        raise NoRun(f"{file}: this is no XML text: {fault}.") from None
    piece = root.find("PolyData/Piece")
    if piece is None:
        raise NoRun(f"{file}: this holds no PolyData.")
    try:
        cells = _arrays(piece.find("CellData"))
        values = _arrays(piece.find("PointData"))
        points = _arrays(piece.find("Points")).get("Points", np.empty((0, 3)))
        lists = _arrays(piece.find("Polys")) or _arrays(piece.find("Verts"))
        bodies = _bodies(root.find("PolyData/FieldData"))
    except ValueError as fault:
        raise NoRun(f"{file}: an array is damaged: {fault}.") from None
    return Surface(
        points=np.asarray(points, dtype=float),
        corners=np.asarray(lists.get("connectivity", ()), dtype=np.int64),
        ends=np.asarray(lists.get("offsets", ()), dtype=np.int64),
        cells=cells,
        values=values,
        bodies=bodies,
    )


def _arrays(parent: ElementTree.Element | None) -> dict[str, NDArray[np.generic]]:
    """All number arrays below an element by name; those of vectors have the shape (n, 3)."""
    if parent is None:
        return {}
    arrays = {}
    for element in parent.iterfind("DataArray"):
        values = np.frombuffer(_bytes_of(element.text or ""), dtype=_TYPES[element.attrib["type"]])
        components = int(element.get("NumberOfComponents", "1"))
        arrays[element.attrib["Name"]] = (
            values.reshape(-1, components) if components > 1 else values
        )
    return arrays


def _bodies(parent: ElementTree.Element | None) -> dict[int, str]:
    """Names of the bodies by their ids."""
    if parent is None:
        return {}
    ids = _arrays(parent).get("body_id", np.empty(0, dtype=np.int64))
    element = parent.find("Array[@Name='body_name']")
    names = _bytes_of(element.text or "").decode().split("\0") if element is not None else []
    return {int(number): name for number, name in zip(ids, names)}


def _bytes_of(text: str) -> bytes:
    """The bytes of an array in one block: count, size, size of the last part, packed size."""
    head_text = 24  # of 16 bytes in base64
    text = text.strip()
    count = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
    if count == 0:
        return b""
    count, size, _, packed = struct.unpack("<4I", base64.b64decode(text[:head_text]))
    if count != 1:
        raise ValueError("it has more than one block")
    return expand(base64.b64decode(text[head_text:])[:packed], size)
