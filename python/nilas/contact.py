"""Contact problems and their solvers on arrays of numpy.

A unit mass is pressed on the ground with 9.81 N s and pushed along it with 1 N s. Friction of 0.2 could hold 1.96 N s,
so the mass sticks:

>>> import numpy as np
>>> problem = Problem()
>>> body = problem.add_body(mass=np.eye(3), momentum=[-9.81, 1.0, 0.0])
>>> contact = problem.add_contact(-1, [], body, np.eye(3), w=[0, 0, 0], mu=0.2)
>>> solution = solve(problem, solver="newton")
>>> solution.status
'converged'
>>> solution.impulses.round(6).tolist()
[[9.81, -1.0, 0.0]]
>>> measure(problem, solution.impulses)["natural_map_m_s"] < 1e-8
True
"""

import os
from typing import Any

from numpy.typing import ArrayLike

from nilas import _core
from nilas._core import Problem, Solution
from nilas.arguments import number, path, whole, word

__all__ = ["Problem", "Solution", "solve", "measure", "solvers", "version"]

Source = Problem | str | os.PathLike[str]


def problem_of(source: Source) -> Problem:
    """The problem itself, or that of a file in FCLIB's format.

    >>> problem_of(Problem()).num_contacts
    0
    """
    if isinstance(source, Problem):
        return source
    return Problem.read(path("problem", source, "a nilas.Problem"))


def solve(
    problem: Source,
    *,
    solver: str = "auto",
    law: str = "coulomb",
    tolerance: float = 1e-8,
    guess: ArrayLike | None = None,
    max_iterations: int = 100000,
    max_seconds: float = 60.0,
    threads: int = 1,
    history: bool = False,
) -> Solution:
    """Solves a contact problem, or that of a file in FCLIB's format.

    `tolerance` is the residual of the law in m/s at which the solver stops, and `guess` holds impulses, (nc, 3) in N s.
    `max_seconds` limits the wall time in s, and 0 sets no limit. With `history` the answer keeps the residual of each
    iteration. Results do not depend on `threads`. A problem that is not solved is no error: look at `status` of the answer.
    `nilas.solvers()` lists the solvers with their laws.

    >>> W = [[2.0, 0, 0], [0, 2.0, 0], [0, 0, 2.0]]
    >>> problem = Problem.local(W, q=[-1.0, 0.3, 0.1], mu=[0.5])
    >>> solve(problem).impulses.round(9).tolist()
    [[0.5, -0.15, -0.05]]
    """
    return _core.solve(
        problem_of(problem),
        solver=word("solver", solver),
        law=word("law", law),
        tolerance=number("tolerance", tolerance),
        guess=guess,
        max_iterations=whole("max_iterations", max_iterations),
        max_seconds=number("max_seconds", max_seconds),
        threads=whole("threads", threads),
        history=bool(history),
    )


def measure(problem: Source, impulses: ArrayLike, *, law: str = "coulomb") -> dict[str, float]:
    """The residuals of impulses, (nc, 3) in N s, by name. Units are in the names.

    >>> problem = Problem.local([[1.0, 0, 0], [0, 1, 0], [0, 0, 1]], q=[-1.0, 0, 0], mu=[0.5])
    >>> measure(problem, [[0, 0, 0]])["law_map_m_s"]
    1.0
    """
    return _core.measure(problem_of(problem), impulses, law=word("law", law))


def solvers() -> dict[str, dict[str, Any]]:
    """The solvers by name, each with its `summary` and the `laws` that it takes.

    >>> "coulomb" in solvers()["nsgs"]["laws"]
    True
    """
    return _core.solvers()


def version() -> str:
    """The version of the compiled part.

    >>> version().count(".")
    2
    """
    return _core.version()
