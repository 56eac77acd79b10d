"""Shapes and motion of all bodies from replay.bin, as ``docs/reference/replay-file.md`` says.

Contacts of the replay are not read here: contacts.h5 has them exactly.
"""

from __future__ import annotations

import json
import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nilas.results.folder import NoRun
from nilas.results.replay_numbers import NO_PAST, NumberReader

_SIGNATURE = b"NILASRP"
_VERSION = b"4"
_HEAD, _SHAPES, _FRAME = b"H", b"S", b"F"
_PIECE_HEAD = 5  # bytes: kind and length
_KEY = 1  # flag of a frame that stands by itself
_TURN_UNIT = 1 / 32768
_MOTION = 7  # kinds of numbers for x, y, z, qw, qx, qy, qz
_CHANNEL_BYTES = 8  # a float32 and two halves

KINDS = ("floe", "vessel", "body", "wall", "part")


class Shape(NamedTuple):
    """A surface of polygons in the frame of its body.

    ``points``: shape (points, 3) [m]. ``polygons``: corners of each, as indices into the points,
    counter-clockwise from outside. ``pieces``: the convex pieces that meet the ice, each a shape
    of its own; empty for floes.

    >>> shape = next(iter(example_run.replay.shapes.values()))
    >>> max(max(polygon) for polygon in shape.polygons) < len(shape.points)
    True
    """

    points: NDArray[np.float64]
    polygons: list[list[int]]
    pieces: list[Shape]


class Body(NamedTuple):
    """What does not change of a body. ``thickness`` [m] is 0 unless it is a plate.

    >>> body = next(body for body in example_run.replay.bodies().values() if body.kind == "floe")
    >>> round(body.thickness, 6), body.fixed, body.mass > 0
    (0.04, False, True)
    """

    id: int
    kind: str
    shape: int | None  # number of its shape; None for a plane
    fixed: bool
    thickness: float
    mass: float  # [kg]
    unit: float  # of its positions [m]
    name: str


@dataclass
class Frame:
    """All bodies at one time. ``position``: (bodies, 3) [m, G], of the centres of mass.

    ``orientation``: (bodies, 4), unit quaternions in the order (w, x, y, z), from body axes to G.

    >>> frame = example_run.replay.frame(0.1)
    >>> frame.step, frame.orientation.shape == (len(frame.bodies), 4)
    (10, True)
    """

    time: float
    step: int
    bodies: list[Body]
    position: NDArray[np.float64]
    orientation: NDArray[np.float64]


@dataclass
class _Place:
    """Where a frame lies in the file."""

    time: float
    is_key: bool
    begin: int
    length: int


@dataclass
class _Motion:
    """What is known of the bodies in the list, for the prediction of the next frame."""

    bodies: list[Body] = field(default_factory=list)
    frames: NDArray[np.int64] = field(default_factory=lambda: np.empty(0, dtype=np.int64))
    now: NDArray[np.int64] = field(default_factory=lambda: np.empty((_MOTION, 0), dtype=np.int64))
    before: NDArray[np.int64] = field(
        default_factory=lambda: np.empty((_MOTION, 0), dtype=np.int64)
    )
    pasts: list[list[int]] = field(default_factory=lambda: [[] for _ in range(_MOTION)])

    def remove(self, gone: list[int]) -> None:
        self.frames = np.delete(self.frames, gone)
        self.now = np.delete(self.now, gone, axis=1)
        self.before = np.delete(self.before, gone, axis=1)
        for place in reversed(gone):
            del self.bodies[place]
            for past in self.pasts:
                del past[place]

    def add(self, came: list[Body]) -> None:
        none = np.zeros((_MOTION, len(came)), dtype=np.int64)
        self.bodies = self.bodies + came
        self.frames = np.concatenate([self.frames, none[0]])
        self.now = np.concatenate([self.now, none], axis=1)
        self.before = np.concatenate([self.before, none], axis=1)
        for past in self.pasts:
            past.extend([NO_PAST] * len(came))

    def advance(self, differences: list[list[int]]) -> None:
        predicted = np.where(self.frames >= 2, 2 * self.now - self.before, self.now)
        self.before = self.now
        self.now = predicted + np.array(differences, dtype=np.int64).reshape(predicted.shape)
        self.frames = np.minimum(self.frames + 1, 2)


class Replay:
    """The motion of a run, also of runs that are too large for bodies.csv.

    No point of a floe is farther than 1e-4 of its diameter from where it was in the run.

    >>> frame = example_run.replay.frame(0.2)
    >>> frame.position.shape == (len(frame.bodies), 3)
    True
    """

    def __init__(self, file: Path) -> None:
        if not file.is_file():
            raise NoRun(f"{file}: this run has no replay; <output trajectory_every> asks for it.")
        self.file = file
        self.head: dict[str, Any] = {}
        self._shape_places: list[tuple[int, int]] = []
        self._frames: list[_Place] = []
        self._shapes: dict[int, Shape] | None = None
        self._scan()

    @property
    def times(self) -> NDArray[np.float64]:
        """Times of the frames, shape (frames,) [s].

        >>> example_run.replay.times.round(6).tolist()
        [0.0, 0.1, 0.2, 0.3, 0.4, 0.5]
        """
        return np.array([frame.time for frame in self._frames])

    @property
    def shapes(self) -> dict[int, Shape]:
        """Shapes of the bodies by their numbers.

        >>> len(example_run.replay.shapes) > 0
        True
        """
        if self._shapes is None:
            self._shapes = _read_shapes(self._content(*place) for place in self._shape_places)
        return self._shapes

    def bodies(self) -> dict[int, Body]:
        """What each body is that occurs in any frame, by its id.

        >>> {body.kind for body in example_run.replay.bodies().values()} >= {"floe", "vessel"}
        True
        """
        found: dict[int, Body] = {}
        for place in self._frames:
            source, _ = self._begin_frame(place)
            source.rising()
            found.update((body.id, body) for body in _read_bodies(source))
        return found

    def frame(self, time: float) -> Frame:
        """The stored frame nearest to a time [s].

        >>> round(example_run.replay.frame(0.22).time, 6)
        0.2
        """
        if not self._frames:
            raise NoRun(f"{self.file}: this holds no frame yet.")
        distances = np.abs(self.times - time)
        wanted = int(np.argmin(distances))
        return next(self.frames(float(self.times[wanted]), float(self.times[wanted])))

    def frames(self, start: float = -np.inf, end: float = np.inf) -> Iterator[Frame]:
        """The frames from one time to another [s], both included, each read in its turn.

        >>> times = [frame.time for frame in example_run.replay.frames()]
        >>> times == sorted(times)
        True
        """
        chosen = [k for k, place in enumerate(self._frames) if start <= place.time <= end]
        if not chosen:
            return
        first = max(k for k in range(chosen[0] + 1) if self._frames[k].is_key or k == 0)
        numbers, motion = NumberReader(), _Motion()
        for place in self._frames[first : chosen[-1] + 1]:
            frame = self._read_frame(place, numbers, motion)
            if place.time >= start:
                yield frame

    def _scan(self) -> None:
        """Finds the whole pieces of the file, of which it reads only the first bytes."""
        with self.file.open("rb") as stream:
            signature = stream.read(len(_SIGNATURE) + 1)
            if signature[:-1] != _SIGNATURE:
                raise NoRun(f"{self.file}: this is no replay file.")
            if signature[-1:] != _VERSION:
                raise NoRun(
                    f"{self.file}: this has version {signature[-1:].decode(errors='replace')} of"
                    f" the replay, and version {_VERSION.decode()} is read here. Run the scene"
                    " again."
                )
            size = self.file.stat().st_size
            while True:
                head = stream.read(_PIECE_HEAD)
                begin = stream.tell()
                if len(head) < _PIECE_HEAD:
                    return
                length = struct.unpack("<I", head[1:])[0]
                if begin + length + 1 > size:
                    return
                self._note_piece(head[:1], begin, length, stream.read(length))
                if stream.read(1) != b"\n":
                    raise NoRun(f"{self.file}: this is damaged at byte {begin - _PIECE_HEAD}.")

    def _note_piece(self, kind: bytes, begin: int, length: int, packed: bytes) -> None:
        if kind == _HEAD:
            self.head = json.loads(zlib.decompress(packed))
        elif kind == _SHAPES:
            self._shape_places.append((begin, length))
        elif kind == _FRAME:
            skipped = _CHANNEL_BYTES * len(self.head["channels"])
            start = zlib.decompressobj().decompress(packed, skipped + 9)
            flags, time = struct.unpack_from("<Bd", start, skipped)
            self._frames.append(_Place(time, bool(flags & _KEY), begin, length))

    def _content(self, begin: int, length: int) -> bytes:
        with self.file.open("rb") as stream:
            stream.seek(begin)
            return zlib.decompress(stream.read(length))

    def _begin_frame(self, place: _Place) -> tuple[_Bytes, int]:
        """The content of a frame from its list of bodies on, and the number of its step."""
        source = _Bytes(self._content(place.begin, place.length))
        source.at = _CHANNEL_BYTES * len(self.head["channels"])
        source.byte()
        source.number("d")
        step = source.varint()
        source.number("d")  # the length of the step
        return source, step

    def _read_frame(self, place: _Place, numbers: NumberReader, motion: _Motion) -> Frame:
        source, step = self._begin_frame(place)
        if place.is_key:
            numbers.forget()
            motion.remove(list(range(len(motion.bodies))))
        motion.remove(source.rising())
        motion.add(_read_bodies(source))
        numbers.begin(source.take(source.varint()))
        motion.advance([numbers.numbers(kind, motion.pasts[kind]) for kind in range(_MOTION)])
        units = np.array([body.unit for body in motion.bodies])
        turn = motion.now[3:].T * _TURN_UNIT
        length = np.linalg.norm(turn, axis=1, keepdims=True)
        return Frame(
            place.time, step, list(motion.bodies), (motion.now[:3] * units).T, turn / length
        )


class _Bytes:
    """Numbers of a piece, read one after another."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        self.at = 0

    def byte(self) -> int:
        self.at += 1
        return self.data[self.at - 1]

    def varint(self) -> int:
        value = shift = 0
        while True:
            byte = self.byte()
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    def signed(self) -> int:
        code = self.varint()
        return code >> 1 if code % 2 == 0 else -(code + 1 >> 1)

    def number(self, kind: str) -> float:
        value = struct.unpack_from("<" + kind, self.data, self.at)[0]
        self.at += struct.calcsize("<" + kind)
        return float(value)

    def take(self, count: int) -> bytes:
        self.at += count
        return self.data[self.at - count : self.at]

    def rising(self) -> list[int]:
        """Places in rising order, stored as their differences; the first counts from -1."""
        places, last = [], -1
        for _ in range(self.varint()):
            last += self.varint()
            places.append(last)
        return places


def _read_bodies(source: _Bytes) -> list[Body]:
    """The bodies that came."""
    bodies, number = [], 0
    for _ in range(source.varint()):
        number += source.signed()
        kind, shape, fixed = KINDS[source.byte()], source.varint(), source.byte() == 1
        thickness, mass, unit = (source.number("f") for _ in range(3))
        name = source.take(source.varint()).decode()
        bodies.append(
            Body(number, kind, shape - 1 if shape else None, fixed, thickness, mass, unit, name)
        )
    return bodies


def _read_shapes(contents: Iterator[bytes]) -> dict[int, Shape]:
    shapes: dict[int, Shape] = {}
    for content in contents:
        source = _Bytes(content)
        while source.at < len(content):
            number = source.varint()
            source.byte()
            owner = source.varint()
            count = source.varint()
            points = np.frombuffer(source.take(12 * count), dtype="<f4").reshape(-1, 3)
            counts = [source.varint() for _ in range(source.varint())]
            polygons = [[source.varint() for _ in range(corners)] for corners in counts]
            shape = Shape(points.astype(float), polygons, [])
            if owner == number:
                shapes[number] = shape
            else:
                shapes[owner].pieces.append(shape)
    return shapes
