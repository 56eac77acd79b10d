#pragma once
/// Docstrings of scenes and simulations. Their examples are run by python/tests/package/test_public_names.py.

namespace nilas::python::docs {

inline constexpr const char* k_vessel_step = R"(
Loads on the vessel over a step, and its motion at the end, in the ground frame.

contact_force: (3,) [N] and contact_torque: (3,) about the centre of mass [N m], by all contacts. ice_force: (3,)
[N], by floes alone. position: (3,) [m]. velocity: (3,) [m/s]. angular_velocity: (3,) [rad/s]. orientation: (4,),
unit quaternion in the order (w, x, y, z), from body axes to the ground frame.

>>> vessel = nilas.Simulation(small_scene).step().vessel
>>> vessel.contact_force.shape == vessel.contact_torque.shape == vessel.ice_force.shape == (3,)
True
>>> vessel.orientation.tolist(), vessel.angular_velocity.tolist()
([1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0])
>>> vessel.position.shape, bool(vessel.velocity[0] > 0)
((3,), True)
)";

inline constexpr const char* k_step = R"(
What one step did.

number: the first is 1. time: at its end [s]. solved: whether the solver reached the scene's tolerance. message: what
the solver did, or why it failed. residual: of the contact law [m/s]. state_hash: equal in runs with equal bits.
numbers and vessel_numbers: those of a row of Simulation.table() and Simulation.vessel_table(), in the order of their
columns. vessel: loads and motion of the vessel, or None.

>>> simulation = nilas.Simulation(small_scene)
>>> step = simulation.step()
>>> step.number, step.time, step.solved, step.message, step.residual <= 1e-6
(1, 0.01, True, 'nsgs 0 sweeps', True)
>>> step.contacts >= 0 and step.floes > 5 and step.iterations >= 0
True
>>> len(step.numbers) == 1 + simulation.table().shape[1]
True
>>> len(step.vessel_numbers) == simulation.vessel_table().shape[1]
True
>>> step.state_hash == nilas.Simulation(small_scene, threads=2).step().state_hash and step.vessel is not None
True
)";

inline constexpr const char* k_body_states = R"(
All n bodies at one time, a row per body, in the ground frame.

id, name and kind (floe, rigid, wall or vessel): lists. mass: (n,) [kg]. position: (n, 3), centre of mass [m].
orientation: (n, 4), unit quaternions in the order (w, x, y, z), from body axes to the ground frame. velocity: (n,
3) [m/s]. angular_velocity: (n, 3) [rad/s]. Arrays of poses and velocities cannot be changed.

>>> bodies = nilas.Simulation(small_scene).bodies
>>> n = len(bodies.id)
>>> len(bodies.name) == len(bodies.kind) == n and bodies.mass.shape == (n,)
True
>>> bodies.position.shape == bodies.velocity.shape == bodies.angular_velocity.shape == (n, 3)
True
>>> bodies.orientation[bodies.name.index("ship")].tolist()
[1.0, 0.0, 0.0, 0.0]
)";

inline constexpr const char* k_snapshot = R"(
A state to which a simulation can return.

>>> isinstance(nilas.Simulation(small_scene).snapshot(), Snapshot)
True
)";

inline constexpr const char* k_checked_scene = R"(
A scene that was read and checked, with every default filled in.

start, end, step: times [s]. xml: the scene with every default written out. fingerprint: SHA-256 of all that the
states of a run depend on. notes: what follows from the scene, as sentences. warnings: values that are valid but
implausible.

>>> scene = CheckedScene.read(small_scene)
>>> scene.name, scene.start, scene.end, scene.step
('small', 0.0, 0.5, 0.01)
>>> "<gravity" in scene.xml, len(scene.fingerprint), scene.warnings
(True, 64, [])
>>> isinstance(scene.notes, list)
True
)";

inline constexpr const char* k_read_scene = R"(
Reads a scene file. settings: pairs of a path and a value, as --set takes them.

Lengths grow by scale, and all else by Froude's and Cauchy's laws.

>>> CheckedScene.read(small_scene, [("time/@end", "2")]).end
2.0
)";

inline constexpr const char* k_parse_scene = R"(
The same from a text. name: that of the text in messages; its paths are relative to the folder of this name.

>>> CheckedScene.parse('<scene version="1" name="empty"><time end="3"/></scene>', "empty.xml").end
3.0
)";

}  // namespace nilas::python::docs
