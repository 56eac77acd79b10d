"""Contact problems on arrays."""

import nilas
import numpy as np
import pytest


def sliding_mass(slide, mu):
    problem = nilas.Problem()
    problem.add_body(np.eye(3), [-9.81, slide, 0])
    problem.add_contact(-1, [], 0, np.eye(3), [0, 0, 0], mu)
    return problem


def random_stack(count, seed):
    """A chain of bodies on the ground, each pressed on the one below."""
    random = np.random.default_rng(seed)
    problem = nilas.Problem()
    up = np.array([[0, 0, 1.0], [1, 0, 0], [0, 1, 0]])
    for k in range(count):
        momentum = [*random.normal(0, 1, 2), -9.81 * (1 + k)]
        problem.add_body((1 + k) * np.eye(3), momentum)
        problem.add_contact(k - 1, -up if k else [], k, up, random.normal(0, 0.01, 3), 0.3)
    return problem


@pytest.mark.parametrize("solver", ["nsgs", "newton", "auto", "ipm", "admm"])
def test_solvers_agree(solver):
    problem = random_stack(5, 1)
    solution = nilas.solve(problem, solver=solver, tolerance=1e-9)
    assert solution.converged
    assert nilas.measure(problem, solution.impulses)["natural_map_m_s"] <= 1e-9
    reference = nilas.solve(problem, tolerance=1e-10)
    assert np.allclose(solution.impulses, reference.impulses, atol=1e-6)


def test_velocities_follow_from_the_impulses():
    problem = random_stack(4, 2)
    solution = nilas.solve(problem)
    W, q = problem.W, problem.q.ravel()
    u = (W @ solution.impulses.ravel() + q).reshape(-1, 3)
    assert np.allclose(u, solution.contact_velocities, atol=1e-12)
    assert np.allclose(problem.contact_velocities(solution.impulses), u, atol=1e-12)


def test_local_form_takes_any_layout():
    problem = random_stack(3, 3)
    local = nilas.Problem.local(np.asfortranarray(problem.W), problem.q, list(problem.mu))
    assert local.is_local and local.num_contacts == 3
    assert np.allclose(nilas.solve(local).impulses, nilas.solve(problem).impulses, atol=1e-7)


def test_files_keep_everything(tmp_path):
    problem = random_stack(3, 4)
    solution = nilas.solve(problem)
    problem.write(tmp_path / "p.hdf5", solution.impulses)
    stored = nilas.Problem.read(tmp_path / "p.hdf5")
    assert np.array_equal(stored.solution, solution.impulses)
    assert stored.guess is None
    assert np.allclose(stored.W, problem.W, rtol=1e-14)
    assert nilas.solve(tmp_path / "p.hdf5").converged


def test_threads_change_no_bits():
    problem = random_stack(40, 5)
    one, two = (nilas.solve(problem, threads=n).impulses for n in (1, 2))
    assert np.array_equal(one, two)


def test_a_guess_and_a_history():
    problem = sliding_mass(10, 0.2)
    solution = nilas.solve(problem, solver="nsgs", history=True)
    assert len(solution.history) == solution.iterations
    assert nilas.solve(problem, guess=solution.impulses).iterations == 0


@pytest.mark.parametrize(
    ("arguments", "part"),
    [
        ({"solver": "newtn"}, "newton"),
        ({"law": "coulom"}, "coulomb"),
        ({"solver": "admm", "law": "pyramid"}, "coulomb"),
        ({"guess": [1.0]}, r"guess has the shape \(1,\); allowed: \(1, 3\) or \(3,\)"),
        ({"guess": [[1.0, 0], [2.0]]}, "guess is no array of real numbers; found list"),
        ({"guess": "abc"}, "guess is no array of real numbers; found str"),
        ({"guess": [1j, 0, 0]}, "guess is no array of real numbers; found list of complex128"),
        ({"guess": [[np.nan, 0, 0]]}, "not finite"),
        ({"threads": 0}, "at least 1"),
        ({"threads": 1.5}, "threads is a whole number; found 1.5"),
        ({"max_iterations": "9"}, "max_iterations is a whole number; found '9'"),
        ({"tolerance": None}, "tolerance is a number; found None"),
        ({"solver": 3}, "solver is a text; found 3"),
        ({"tolerance": -1.0}, "0 or above"),
    ],
)
def test_faults_say_what_is_allowed(arguments, part):
    with pytest.raises(nilas.InputError, match=part):
        nilas.solve(sliding_mass(1, 0.2), **arguments)


def test_arrays_of_another_shape_are_refused():
    problem = random_stack(5, 6)
    impulses = nilas.solve(problem).impulses
    with pytest.raises(nilas.InputError, match=r"shape \(3, 5\); allowed: \(5, 3\)"):
        nilas.measure(problem, impulses.T)
    for name, call in {
        r"jacobian_b has the shape \(9, 1\); allowed: \(3, n\)": lambda: problem.add_contact(
            -1, [], 0, np.ones((9, 1)), [0, 0, 0], 0.1
        ),
        "jacobian_b has 18 numbers; allowed: 9, in 3 rows for the 3 velocities of body 0": lambda: problem.add_contact(
            -1, [], 0, np.ones((3, 6)), [0, 0, 0], 0.1
        ),
        r"w has the shape \(2,\); allowed: \(3,\)": lambda: problem.add_contact(-1, [], 0, np.eye(3), [0, 0], 0.1),
        r"momentum has the shape \(3, 1\); allowed: \(n,\)": lambda: problem.add_body(np.eye(3), np.ones((3, 1))),
        "mass has 9 numbers and momentum 2; allowed for n velocities: n x n and n": lambda: problem.add_body(
            np.eye(3), [0, 0]
        ),
        r"impulses has the shape \(14,\); allowed: \(5, 3\) or \(15,\)": lambda: problem.contact_velocities([0] * 14),
        "impulses is no array of real numbers": lambda: problem.velocities(["a"] * 15),
    }.items():
        with pytest.raises(nilas.InputError, match=name):
            call()
    assert problem.num_contacts == 5


W2, Q2, MU2 = np.eye(6), np.zeros(6), [0.1, 0.2]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((W2, Q2, [0.1]), r"mu has 1 numbers; allowed: 2, one for each contact of W, 36 \(6 x 6\), and q, 6"),
        ((W2, Q2, [0.1] * 3), "mu has 3 numbers; allowed: 2"),
        ((np.eye(9), Q2, MU2), r"W has 81 numbers; allowed: 36 \(6 x 6\), since q has 6 and mu 2"),
        ((W2, np.zeros((3, 3)), MU2), r"q has 9 numbers; allowed: 6, since W has 36 \(6 x 6\) and mu 2"),
        ((W2, np.zeros(3), [0.1] * 3), r"W has 36 numbers, q 3 and mu 3; allowed for nc contacts"),
        ((np.eye(4), Q2, MU2), r"W has the shape \(4, 4\); allowed: \(3 nc, 3 nc\)"),
        ((np.zeros(35), Q2, MU2), "W has 35 numbers; allowed: 36"),
        ((W2, np.zeros((3, 2)), MU2), r"q has the shape \(3, 2\); allowed: \(nc, 3\) or \(3 nc,\)"),
        ((W2, Q2, [MU2]), r"mu has the shape \(1, 2\); allowed: \(nc,\)"),
        ((W2, Q2, 0.1), r"mu has the shape \(\); allowed: \(nc,\)"),
        (("W", Q2, MU2), "W is no array of real numbers; found str"),
        ((W2, Q2, [0.1, -0.1]), "mu has a negative number"),
    ],
)
def test_the_array_of_a_local_problem_that_does_not_fit_is_named(arguments, message):
    with pytest.raises(nilas.InputError, match=message):
        nilas.Problem.local(*arguments)


def test_a_longer_problem_forgets_its_solution(tmp_path):
    problem = random_stack(2, 7)
    problem.write(tmp_path / "p.hdf5", nilas.solve(problem).impulses)
    stored = nilas.Problem.read(tmp_path / "p.hdf5")
    body = stored.add_body(np.eye(3), [0, 0, -1.0])
    stored.add_contact(-1, [], body, np.eye(3), [0, 0, 0], 0.2)
    assert stored.solution is None
    assert nilas.solve(stored).converged


def test_what_is_no_problem_is_named():
    with pytest.raises(nilas.InputError, match="problem is a nilas.Problem or the path of a file; found None"):
        nilas.solve(None)
    with pytest.raises(nilas.InputError, match="found a dict"):
        nilas.measure({}, [[0, 0, 0]])


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(nilas.FileError, match="none.hdf5"):
        nilas.solve(tmp_path / "none.hdf5")
