"""Stored problems have the solution that the run used, and the form that FCLIB describes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import nilas
from nilas.exchange.fclib import read_fclib

h5py = pytest.importorskip("h5py", reason="needs h5py (python3-h5py of Debian)")
pytest.importorskip("scipy", reason="needs scipy (python3-scipy of Debian)")


def test_impulses_keep_coulombs_law(small_run: nilas.Run) -> None:
    """The natural map of the exact cone vanishes to the tolerance of the scene, 1e-6 m/s.

    For each contact r is the projection of r - rho (u + mu |u_T| n) onto the cone, for any rho.
    """
    problem = read_fclib(small_run.problems[0])
    W, q = problem.local()
    assert problem.r is not None and np.abs(problem.r).max() > 0
    u = (W @ problem.r + q).reshape(-1, 3)
    r = problem.r.reshape(-1, 3)
    for contact, mu in enumerate(problem.mu):
        block = W[3 * contact : 3 * contact + 3, 3 * contact : 3 * contact + 3]
        rho = 3 / np.trace(block)
        aim = r[contact] - rho * u[contact]
        aim[0] -= rho * mu * np.hypot(*u[contact, 1:])
        tangent = np.hypot(*aim[1:])
        if mu * tangent <= -aim[0]:
            projected = np.zeros(3)
        elif tangent <= mu * aim[0]:
            projected = aim
        else:
            normal = (aim[0] + mu * tangent) / (1 + mu * mu)
            projected = np.array([normal, *(mu * normal * aim[1:] / tangent)])
        assert np.linalg.norm(projected - r[contact]) / rho < 1e-5


def write_local(file: Path, storage: str) -> np.ndarray:
    """One contact with an unsymmetric W, so that rows cannot be taken for columns."""
    W = np.array([[2.0, 0.5, 0], [0.25, 3, 0], [0, 0, 4]])
    with h5py.File(file, "w") as out:
        group = out.create_group("fclib_local")
        group["spacedim"] = 3
        group["vectors/q"], group["vectors/mu"] = [-1.0, 0, 0], [0.3]
        matrix = group.create_group("W")
        rows, columns = np.nonzero(W)
        if storage == "rows":
            matrix["nz"], matrix["p"], matrix["i"] = -2, [0, 2, 4, 5], columns
            matrix["x"] = W[rows, columns]
        elif storage == "columns":
            columns, rows = np.nonzero(W.T)
            matrix["nz"], matrix["p"], matrix["i"] = -1, [0, 2, 4, 5], rows
            matrix["x"] = W[rows, columns]
        else:
            matrix["nz"], matrix["p"], matrix["i"] = 5, columns, rows
            matrix["x"] = W[rows, columns]
        matrix["m"], matrix["n"], matrix["nzmax"] = 3, 3, 5
    return W


@pytest.mark.parametrize("storage", ["rows", "columns", "entries"])
def test_each_way_to_store_a_matrix_is_read(tmp_path: Path, storage: str) -> None:
    expected = write_local(tmp_path / "p.hdf5", storage)
    problem = read_fclib(tmp_path / "p.hdf5")
    assert np.array_equal(problem.local()[0], expected)
    assert problem.r is None and len(problem) == 1


def test_what_is_no_problem_is_refused(small_run: nilas.Run, tmp_path: Path) -> None:
    with pytest.raises(nilas.InputError, match="no contact problem in FCLIB form"):
        read_fclib(small_run.folder / "contacts.h5")
    with pytest.raises(nilas.FileError, match="cannot be read as HDF5"):
        read_fclib(tmp_path / "none.hdf5")
