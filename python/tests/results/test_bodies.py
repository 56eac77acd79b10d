"""Poses from bodies.csv, replay.bin and the frames for ParaView agree with each other."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import nilas
from nilas.results.replay_numbers import NO_PAST, NumberReader


def turned(quaternion: NDArray[np.float64], points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points turned by a unit quaternion w x y z, by its rotation matrix."""
    w, x, y, z = quaternion
    matrix = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
    return points @ matrix.T


def test_arrays_have_the_values_of_the_table(small_run: nilas.Run) -> None:
    bodies, table = small_run.bodies, small_run.table("bodies")
    assert bodies.source == "bodies.csv"
    for row in (0, 5, len(table) - 1):
        line = table.iloc[row]
        time, place = np.flatnonzero(bodies.times == line.time_s)[0], bodies.place(int(line.id))
        assert bodies.names[place] == line["name"]
        assert list(bodies.position[time, place]) == [line.x_m, line.y_m, line.z_m]
        assert list(bodies.orientation[time, place]) == [line.qw, line.qx, line.qy, line.qz]
        assert list(bodies.velocity[time, place]) == [line.vx_m_s, line.vy_m_s, line.vz_m_s]
        assert bodies.angular_velocity[time, place, 2] == line.wz_rad_s


def test_the_vessel_moves_as_in_its_own_table(small_run: nilas.Run) -> None:
    """vessel.csv has 12 digits after the point."""
    ship = small_run.bodies.one("ship")
    for time, position in zip(ship.times[1:], ship.position[1:, 0]):
        row = small_run.vessel.iloc[np.argmin(np.abs(small_run.vessel.index - time))]
        assert position == pytest.approx([row.x_m, row.y_m, row.z_m], abs=1e-12)


def test_the_replay_has_the_same_poses_within_its_error(own_folder: Path) -> None:
    """No point of a floe is farther than 1e-4 of its diameter from its place.

    The unit of positions is 0.8e-4 of the diameter, so half of it is the error along an axis.
    Components of quaternions are in units of 2^-15.
    """
    exact = nilas.Run(own_folder).bodies
    (own_folder / "bodies.csv").unlink()
    run = nilas.Run(own_folder)
    rounded = run.bodies
    assert rounded.source == "replay.bin"
    assert list(rounded.ids) == list(exact.ids)
    assert np.allclose(rounded.times, exact.times, rtol=0, atol=1e-12)
    units = np.array([run.replay.bodies()[int(number)].unit for number in rounded.ids])
    errors = np.abs(rounded.position - exact.position)
    assert (errors <= 0.5001 * units[None, :, None]).all()
    same = np.sign(np.einsum("tbk,tbk->tb", rounded.orientation, exact.orientation))
    assert np.abs(rounded.orientation * same[:, :, None] - exact.orientation).max() <= 2 / 32768
    with pytest.raises(nilas.NoRun, match="replay.bin has no velocities"):
        _ = rounded.velocity


def test_shapes_and_poses_give_the_surfaces_that_paraview_shows(small_run: nilas.Run) -> None:
    """Points of the VTP files are float32, and so are those of the shapes."""
    frame = small_run.replay.frame(0.3)
    bodies = small_run.bodies
    time = int(np.argmin(np.abs(bodies.times - 0.3)))
    faces = small_run.trajectory.surface("ice floes", 0.3).upper_faces()
    floes = [body for body in frame.bodies if body.kind == "floe"]
    assert {floe.id for floe in floes} == set(faces)
    for floe in floes:
        assert floe.shape is not None
        shape = small_run.replay.shapes[floe.shape]
        place = bodies.place(floe.id)
        upper = turned(bodies.orientation[time, place], shape.points[shape.polygons[1]])
        expected = faces[floe.id]
        assert np.abs(upper + bodies.position[time, place] - expected).max() < 2e-6
        assert floe.thickness == pytest.approx(0.04)


def test_a_hull_has_its_pieces_mass_and_name(small_run: nilas.Run) -> None:
    frame = small_run.replay.frame(0)
    ship = next(body for body in frame.bodies if body.kind == "vessel")
    assert ship.name == "ship"
    assert ship.mass == pytest.approx(small_run.summary["vessel"]["mass_kg"], rel=1e-6)
    assert ship.shape is not None
    # The generated icebreaker is convex, so it is one piece.
    assert len(small_run.replay.shapes[ship.shape].pieces) == 1


def test_a_cut_replay_has_its_whole_frames(own_folder: Path) -> None:
    file = own_folder / "replay.bin"
    frames = len(nilas.Run(own_folder).replay.times)
    content = file.read_bytes()
    file.write_bytes(content[:-40])
    replay = nilas.Run(own_folder).replay
    assert frames - 1 <= len(replay.times) <= frames
    file.write_bytes(b"NILASRP3" + content[8:])
    with pytest.raises(nilas.NoRun, match="has version 3 of the replay, and version 4"):
        _ = nilas.Run(own_folder).replay


def test_broken_floes_are_nan(own_folder: Path) -> None:
    table = nilas.Run(own_folder).table("bodies")
    last = table.time_s.max()
    gone = int(table.id.max())
    kept = table[(table.time_s < last) | (table.id != gone)]
    kept.to_csv(own_folder / "bodies.csv", index=False)
    bodies = nilas.Run(own_folder).bodies
    place = bodies.place(gone)
    assert np.isnan(bodies.position[-1, place]).all()
    assert np.isfinite(bodies.position[0, place]).all()


def test_an_unknown_body_is_named(small_run: nilas.Run) -> None:
    with pytest.raises(nilas.UnknownName, match="no body 'boat'; allowed: .*ship"):
        small_run.bodies.one("boat")
    with pytest.raises(nilas.UnknownName, match="no body of the id 99999; allowed: ids from"):
        small_run.bodies.place(99999)


class NumberWriter:
    """Writes numbers as core/output/replay/number_coder.cpp does, with whole numbers of any size.

    The interval [low, low + range) is kept as a fraction of 2^32 with all bytes so far.
    """

    def __init__(self) -> None:
        self.low, self.range, self.shifts = 0, 0xFFFFFFFF, 0
        self.shares: dict[tuple[int, int, str, int], int] = {}

    def digit(self, place: tuple[int, int, str, int], one: bool) -> None:
        share = self.shares.setdefault(place, 2048)
        bound = self.range // 4096 * share
        if one:
            self.low += bound
            self.range -= bound
            self.shares[place] = share - share // 32
        else:
            self.range = bound
            self.shares[place] = share + (4096 - share) // 32
        self.narrow()

    def even(self, one: bool) -> None:
        self.range //= 2
        self.low += self.range if one else 0
        self.narrow()

    def narrow(self) -> None:
        while self.range < 1 << 24:
            self.range <<= 8
            self.low <<= 8
            self.shifts += 1

    def add(self, kind: int, past: int, number: int) -> int:
        size = abs(number)
        digits = size.bit_length()
        self.digit((kind, past, "zero", 0), size != 0)
        if size:
            self.digit((kind, past, "sign", 0), number < 0)
            for k in range(1, digits + 1):
                self.digit((kind, past, "longer", min(k, 20)), k < digits)
            if digits > 1:
                self.digit((kind, past, "second", min(digits, 20)), bool(size >> (digits - 2) & 1))
                for k in range(digits - 3, -1, -1):
                    self.even(bool(size >> k & 1))
        return min(5, digits)

    def finish(self) -> bytes:
        return self.low.to_bytes(self.shifts + 4, "big")


def test_coded_numbers_are_read_as_they_were_written() -> None:
    """Small and huge numbers of both signs, over two frames that share what they learnt."""
    random = np.random.default_rng(5)
    frames = [
        [int(x) for x in random.normal(0, 3, 200)] + [2**40, -(2**40), 0, 1, -1],
        [int(x) for x in random.normal(0, 300, 205)],
    ]
    writer, reader = NumberWriter(), NumberReader()
    written, read = [NO_PAST] * 205, [NO_PAST] * 205
    for numbers in frames:
        writer.low, writer.range, writer.shifts = 0, 0xFFFFFFFF, 0
        for place, number in enumerate(numbers):
            written[place] = writer.add(3, written[place], number)
        reader.begin(writer.finish())
        assert reader.numbers(3, read) == numbers
        assert read == written
