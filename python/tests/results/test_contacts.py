"""Contacts of a step or a window, and files that a run left half written."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

import nilas

h5py = pytest.importorskip("h5py", reason="needs h5py (python3-h5py of Debian)")


def test_forces_of_a_step_sum_to_the_load_on_the_vessel(small_run: nilas.Run) -> None:
    """Over the rows of a step the forces sum to contact_f* of vessel.csv, to rounding."""
    contacts, vessel = small_run.contacts, small_run.vessel
    assert contacts.steps == len(vessel)
    assert contacts.rows > 0
    for number in range(1, contacts.steps + 1):
        step = contacts.step(number)
        scale = 1e-9 * max(1.0, np.abs(step.fx_N).sum())
        for axis in "xyz":
            load = vessel[f"contact_f{axis}_N"].iloc[number - 1]
            assert step[f"f{axis}_N"].sum() == pytest.approx(load, abs=scale)


def test_a_window_has_the_rows_of_its_steps(small_run: nilas.Run) -> None:
    contacts = small_run.contacts
    everything = contacts.all()
    assert len(everything) == contacts.rows
    times = small_run.steps.index
    for start, end in ((times[4], times[20]), (-1.0, 99.0), (0.101, 0.102), (times[-1], 99.0)):
        some = contacts.between(start, end)
        expected = everything[everything.time_s.between(start, end)]
        assert np.array_equal(some.key.to_numpy(), expected.key.to_numpy())


def test_columns_have_units_and_the_order_of_the_reference(small_run: nilas.Run) -> None:
    contacts = small_run.contacts
    assert contacts.columns[:8] == [
        "time_s",
        "step",
        "body",
        "other",
        "x_m",
        "y_m",
        "z_m",
        "hull_x_m",
    ]
    assert contacts.units["impulse_x_Ns"] == "N s"
    assert "normal" in contacts.meanings["nx"]
    assert small_run.units("contacts") == contacts.units


def test_vectors_are_arrays_of_three_columns(small_run: nilas.Run) -> None:
    normal = small_run.contacts.array("normal")
    assert normal.shape == (small_run.contacts.rows, 3)
    assert np.allclose(np.linalg.norm(normal, axis=1), 1)
    with pytest.raises(nilas.UnknownName, match="no vector 'velocity'; allowed: point, hull_point"):
        small_run.contacts.array("velocity")


def test_a_wrong_step_or_column_is_named(small_run: nilas.Run) -> None:
    with pytest.raises(IndexError, match="no step 0, but 1 to 50"):
        small_run.contacts.step(0)
    with pytest.raises(nilas.UnknownName, match="no column 'fx'"):
        small_run.contacts.step(1, columns=["fx"])


def test_only_the_rows_asked_for_are_read(
    small_run: nilas.Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A window reads its own rows, and single times to find them."""
    read = []
    plain = h5py.Dataset.__getitem__

    def counted(self: h5py.Dataset, place: object, *rest: object) -> object:
        values = plain(self, place, *rest)
        if self.parent.name == "/contacts":
            read.append(np.size(values))
        return values

    monkeypatch.setattr(h5py.Dataset, "__getitem__", counted)
    rows = len(small_run.contacts.step(50, columns=["fx_N"]))
    assert sum(read) == rows


def test_rows_of_a_write_that_was_cut_off_are_no_step(own_folder: Path) -> None:
    with h5py.File(own_folder / "contacts.h5", "r+") as file:
        steps = len(file["steps"])
        for column in file["contacts"].values():
            column.resize(len(column) + 7, axis=0)
    contacts = nilas.Run(own_folder).contacts
    assert contacts.steps == steps
    assert contacts.all().step.iloc[-1] <= steps


def test_after_a_full_disk_steps_end_where_they_no_longer_continue(own_folder: Path) -> None:
    with h5py.File(own_folder / "contacts.h5", "r+") as file:
        file["steps"][30] = [0, 0]
        first = int(file["steps"][29, 1])
    contacts = nilas.Run(own_folder).contacts
    assert contacts.steps == 30
    assert contacts.rows == first


def test_a_file_with_the_mark_of_its_writer_is_read(own_folder: Path, tmp_path: Path) -> None:
    """A copy that was made while a writer had it open is what a killed run leaves."""
    whole = nilas.Run(own_folder).contacts.rows
    with h5py.File(own_folder / "contacts.h5", "r+", libver="latest") as file:
        file.swmr_mode = True
        file.flush()
        shutil.copy(own_folder / "contacts.h5", tmp_path / "marked.h5")
    shutil.copy(tmp_path / "marked.h5", own_folder / "contacts.h5")
    assert nilas.Run(own_folder).contacts.rows == whole


def test_a_run_without_contacts_says_so(own_folder: Path) -> None:
    (own_folder / "contacts.h5").unlink()
    with pytest.raises(nilas.NoRun, match="stored no contacts"):
        _ = nilas.Run(own_folder).contacts
    (own_folder / "contacts.h5").write_text("no HDF5")
    with pytest.raises(nilas.NoRun, match="cannot be read as HDF5"):
        _ = nilas.Run(own_folder).contacts.steps
