#pragma once
/// Docstrings of contact problems. Their examples are run by python/tests/package/test_public_names.py.

namespace nilas::python::docs {

inline constexpr const char* k_problem = R"(
A contact problem: M v = f + H r, u = H^T v + w, or u = W r + q in its local form.

Each of its nc contacts has a normal row and two tangential ones: impulses r [N s] and velocities u [m/s] are (nc,
3). num_velocities is 0 in the local form. mu: (nc,), coefficients of friction. W: (3 nc, 3 nc) [1/kg], the Delassus
operator H^T M^-1 H. q: (nc, 3) [m/s], velocities at the contacts without impulses. guess and solution: (nc, 3) [N
s], impulses that came with the problem, or None.

>>> problem = Problem()
>>> mass = problem.add_body(mass=4 * np.eye(3), momentum=[-6, 1, 0])
>>> contact = problem.add_contact(-1, [], mass, np.eye(3), w=[0, 0, 0], mu=0.3)
>>> problem.num_contacts, problem.num_velocities, problem.is_local, problem.mu.tolist()
(1, 3, False, [0.3])
>>> problem.W.diagonal().tolist(), problem.q.tolist()
([0.25, 0.25, 0.25], [[-1.5, 0.25, 0.0]])
>>> problem.guess is None and problem.solution is None
True
)";

inline constexpr const char* k_local = R"(
The problem u = W r + q.

W: (3 nc, 3 nc) [1/kg]; q: (nc, 3) or (3 nc,) [m/s]; mu: (nc,). Raises InputError, which names the array that does
not fit the others.

>>> Problem.local(W=np.eye(6), q=np.zeros((2, 3)), mu=[0.1, 0.2]).num_contacts
2
>>> Problem.local(W=np.eye(6), q=np.zeros((2, 3)), mu=[0.1])
Traceback (most recent call last):
nilas.errors.InputError: mu has 1 numbers; allowed: 2, one for each contact of W, 36 (6 x 6), and q, 6
)";

inline constexpr const char* k_read = R"(
Reads a file in FCLIB's format (HDF5).

>>> Problem.local(np.eye(3), [-1, 0, 0], [0.5]).write("one.hdf5")
>>> Problem.read("one.hdf5").num_contacts
1
)";

inline constexpr const char* k_add_body = R"(
Adds a body with n velocities and returns its index.

mass: (n, n), symmetric and positive definite. momentum: (n,), M v without contacts. For translations these are in
kg and N s, for rotations in kg m^2 and N m s.

>>> problem = Problem()
>>> problem.add_body(np.eye(6), np.zeros(6)), problem.add_body(np.eye(3), np.zeros(3))
(0, 1)
)";

inline constexpr const char* k_add_contact = R"(
Adds a contact between two bodies and returns its index.

Body -1 does not move, and its jacobian is empty. jacobian_a, jacobian_b: (3, n) for the n velocities of each body,
with the normal row first, so that u = J_a v_a + J_b v_b + w. w: (3,) [m/s]. The impulse acts on body b, and its
reverse on body a.

>>> problem = Problem()
>>> body = problem.add_body(np.eye(3), [-1, 0, 0])
>>> problem.add_contact(-1, [], body, np.eye(3), w=[0, 0, 0], mu=0.2)
0
)";

inline constexpr const char* k_contact_velocities = R"(
Velocities at the contacts under impulses (nc, 3) [N s], as (nc, 3) [m/s].

>>> Problem.local(np.eye(3), [-1, 0.5, 0], [0.5]).contact_velocities([[1, 0, 0]]).tolist()
[[0.0, 0.5, 0.0]]
)";

inline constexpr const char* k_velocities = R"(
Velocities of the bodies under impulses (nc, 3) [N s], (num_velocities,); empty in the local form.

>>> problem = Problem()
>>> body = problem.add_body(4 * np.eye(3), [-2, 1, 0])
>>> contact = problem.add_contact(-1, [], body, np.eye(3), w=[0, 0, 0], mu=0.2)
>>> problem.velocities([[2, 0, 0]]).tolist()
[0.0, 0.25, 0.0]
)";

inline constexpr const char* k_write = R"(
Writes the problem in FCLIB's format, with impulses (nc, 3) [N s] as its solution if they are given.

>>> problem = Problem.local(np.eye(3), [-1, 0, 0], [0.5])
>>> problem.write("solved.hdf5", impulses=[[1, 0, 0]])
>>> Problem.read("solved.hdf5").solution.tolist()
[[1.0, 0.0, 0.0]]
)";

inline constexpr const char* k_solution = R"(
The answer of a solver, and how good it is.

impulses: (nc, 3) [N s]. contact_velocities: (nc, 3) [m/s]. velocities: those of the bodies, empty in the local
form. status: converged, iteration_limit, stalled or numerical_error; message tells more. seconds: wall time of the
solve [s]. history: the residual after each iteration [m/s], empty unless it was asked for. residuals: by name,
measured independently of the solver; their units are in the names.

>>> problem = Problem.local(np.eye(3), [-1, 0.2, 0.1], [0.5])
>>> solution = nilas.solve(problem, solver="nsgs", history=True)
>>> solution.status, solution.converged, solution.message
('converged', True, '')
>>> solution.impulses.round(6).tolist(), solution.contact_velocities.round(6).tolist()
([[1.0, -0.2, -0.1]], [[0.0, 0.0, 0.0]])
>>> solution.velocities.shape, len(solution.history) == solution.iterations, solution.seconds < 1
((0,), True, True)
>>> solution.residuals["natural_map_m_s"] <= 1e-8
True
)";

}  // namespace nilas::python::docs
