"""Contact problems in FCLIB form as numpy and scipy arrays, for other programs.

The letters are those of ``docs/reference/conventions.md``. With impulses r, velocities v of the
bodies and relative velocities u, the global form is M v = f + H r, u = H^T v + w. The local form is
u = W r + q. Each contact has three rows: normal, then two tangents.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nilas.errors import FileError, InputError

if TYPE_CHECKING:
    import h5py
    from scipy.sparse import csc_matrix

_LOCAL, _GLOBAL = "fclib_local", "fclib_global"
_ROLLING = "fclib_global_rolling"
_BY_COLUMNS, _BY_ROWS = -1, -2  # how a matrix is stored; else it is a list of entries


@dataclass
class FclibProblem:
    """A contact problem as its file has it.

    ``mu``: friction coefficients, shape (contacts,). ``r``: impulses, shape (3 contacts,) [N s], or
    None. In the local form ``W`` [1/kg] has the shape (3 contacts, 3 contacts) and ``q`` [m/s]
    (3 contacts,). In the global form ``M`` has (velocities, velocities), ``f`` (velocities,),
    ``H`` (velocities, 3 contacts) and ``w`` (3 contacts,). What a form lacks is None. Sizes: ``M``
    [kg], ``f`` [N s] and ``w`` [m/s] where velocities are translations.

    >>> problem = read_fclib(example_run.problems[0])
    >>> problem.W is None and problem.M.shape == (len(problem.f), len(problem.f))
    True
    >>> problem.w.shape == problem.r.shape == (3 * len(problem.mu),)
    True
    """

    mu: NDArray[np.float64]
    r: NDArray[np.float64] | None
    W: csc_matrix | None = None
    q: NDArray[np.float64] | None = None
    M: csc_matrix | None = None
    f: NDArray[np.float64] | None = None
    H: csc_matrix | None = None
    w: NDArray[np.float64] | None = None

    def __len__(self) -> int:
        return len(self.mu)

    def local(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """W dense, shape (3 contacts, 3 contacts) [1/kg], and q, shape (3 contacts,) [m/s].

        Of the global form W = H^T M^-1 H and q = H^T M^-1 f + w. Use it for small problems: a
        thousand contacts make 72 MB.

        >>> W, q = read_fclib(example_run.problems[0]).local()
        >>> bool(np.allclose(W, W.T)) and W.shape == (len(q), len(q))
        True
        """
        if self.W is not None and self.q is not None:
            return self.W.toarray(), self.q
        from scipy.sparse.linalg import splu

        assert self.M is not None and self.H is not None
        assert self.f is not None and self.w is not None
        inverse = splu(self.M)
        return (
            np.asarray(self.H.T @ inverse.solve(self.H.toarray())),
            np.asarray(self.H.T @ inverse.solve(self.f) + self.w),
        )


def read_fclib(path: str | os.PathLike[str]) -> FclibProblem:
    """Reads a three-dimensional problem without rolling friction, in local or global form.

    >>> problem = read_fclib(example_run.problems[0])
    >>> problem.H.shape[1] == 3 * len(problem)
    True
    """
    import h5py

    source = Path(path)
    try:
        file = h5py.File(source, "r")
    except OSError as fault:
        raise FileError(f"{source}: this cannot be read as HDF5: {fault}") from None
    with file:
        if _ROLLING in file:
            raise InputError(
                f"{source}: rolling friction has five rows a contact; use nilas solve."
            )
        root = next((name for name in (_GLOBAL, _LOCAL) if name in file), None)
        if root is None:
            raise InputError(f"{source}: this holds no contact problem in FCLIB form.")
        group = file[root]
        if int(np.ravel(group["spacedim"][()])[0]) != 3:
            raise InputError(f"{source}: the problem is not three-dimensional.")
        vectors = {name: np.asarray(values[:], float) for name, values in group["vectors"].items()}
        impulses = np.asarray(file["solution/r"][:], float) if "solution/r" in file else None
        if root == _LOCAL:
            return FclibProblem(vectors["mu"], impulses, W=_matrix(group["W"]), q=vectors["q"])
        return FclibProblem(
            vectors["mu"],
            impulses,
            M=_matrix(group["M"]),
            H=_matrix(group["H"]),
            f=vectors["f"],
            w=vectors["w"],
        )


def _matrix(group: h5py.Group) -> csc_matrix:
    """A sparse matrix from its group with m, n, nz, p, i and x."""
    from scipy.sparse import coo_matrix, csc_matrix, csr_matrix

    rows, columns, storage = (int(np.ravel(group[name][()])[0]) for name in ("m", "n", "nz"))
    p, i, x = (np.asarray(group[name][:]) for name in "pix")
    shape = (rows, columns)
    if storage == _BY_COLUMNS:
        return csc_matrix((x[: p[columns]], i[: p[columns]], p[: columns + 1]), shape)
    if storage == _BY_ROWS:
        return csc_matrix(csr_matrix((x[: p[rows]], i[: p[rows]], p[: rows + 1]), shape))
    entries = _entries(x[:storage], p[:storage], i[:storage], shape)
    return csc_matrix(coo_matrix(entries, shape))


def _entries(
    x: NDArray[Any], p: NDArray[Any], i: NDArray[Any], shape: tuple[int, int]
) -> tuple[NDArray[Any], tuple[NDArray[Any], NDArray[Any]]]:
    """Values and their rows and columns. Files of Siconos hold columns in p and rows in i.

    The format's own header says the reverse. Where only the reverse fits the shape, it holds.
    """
    fits = bool((i < shape[0]).all() and (p < shape[1]).all())
    return x, ((i, p) if fits else (p, i))
