#include "nilas/simulation.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "python/binding/arrays.h"
#include "python/binding/module.h"

namespace nilas::python {

namespace {

void bind_steps(py::module_& module) {
  py::class_<VesselStep>(module, "VesselStep", "Loads on the vessel over a step, and its motion at the end.")
      .def_property_readonly(
          "contact_force", [](const VesselStep& self) { return array_of(self.contact_force); }, "(3,) [N]")
      .def_property_readonly(
          "contact_torque", [](const VesselStep& self) { return array_of(self.contact_torque); },
          "(3,) about the centre of mass [N m]")
      .def_property_readonly(
          "ice_force", [](const VesselStep& self) { return array_of(self.ice_force); }, "(3,) by floes alone [N]")
      .def_property_readonly(
          "position", [](const VesselStep& self) { return array_of(self.position); }, "(3,) [m]")
      .def_property_readonly(
          "velocity", [](const VesselStep& self) { return array_of(self.velocity); }, "(3,) [m/s]")
      .def_property_readonly(
          "angular_velocity", [](const VesselStep& self) { return array_of(self.angular_velocity); }, "(3,) [rad/s]")
      .def_property_readonly(
          "orientation", [](const VesselStep& self) { return array_of(self.orientation); },
          "(4,) unit quaternion w, x, y, z from body axes to the ground frame");
  py::class_<Step>(module, "Step", "What one step did.")
      .def_readonly("number", &Step::number, "The first is 1.")
      .def_readonly("time", &Step::time, "At its end [s].")
      .def_readonly("contacts", &Step::contacts)
      .def_readonly("floes", &Step::floes)
      .def_readonly("iterations", &Step::iterations)
      .def_readonly("solved", &Step::solved, "Whether the solver reached the scene's tolerance.")
      .def_readonly("message", &Step::message, "Why it did not.")
      .def_readonly("residual", &Step::residual, "Of the contact law [m/s].")
      .def_readonly("state_hash", &Step::state_hash)
      .def_property_readonly(
          "numbers", [](const Step& self) { return array_of(self.numbers); }, "In the order of step_columns.")
      .def_property_readonly(
          "vessel_numbers", [](const Step& self) { return array_of(self.vessel_numbers); },
          "In the order of vessel_columns.")
      .def_readonly("vessel", &Step::vessel, "Loads and motion of the vessel, or None.");
}

void bind_bodies(py::module_& module) {
  py::class_<BodyStates>(module, "BodyStates", "All bodies at one time, a row per body.")
      .def_readonly("id", &BodyStates::id)
      .def_readonly("name", &BodyStates::name)
      .def_readonly("kind", &BodyStates::kind, "floe, rigid, wall or vessel")
      .def_property_readonly(
          "mass", [](const BodyStates& self) { return array_of(self.mass); }, "(n,) [kg]")
      .def_property_readonly(
          "position", [](const BodyStates& self) { return rows_of(self.position, 3); }, "(n, 3) centre of mass [m]")
      .def_property_readonly(
          "orientation", [](const BodyStates& self) { return rows_of(self.orientation, 4); },
          "(n, 4) unit quaternions w, x, y, z from body axes to the ground frame")
      .def_property_readonly(
          "velocity", [](const BodyStates& self) { return rows_of(self.velocity, 3); }, "(n, 3) [m/s]")
      .def_property_readonly(
          "angular_velocity", [](const BodyStates& self) { return rows_of(self.angular_velocity, 3); },
          "(n, 3), ground frame [rad/s]");
}

}  // namespace

void bind_simulation(py::module_& module) {
  bind_steps(module);
  bind_bodies(module);
  py::class_<Snapshot>(module, "Snapshot", "A state to which a simulation can return.");
  py::class_<Simulation>(module, "Simulation")
      .def(py::init([](const Scene& scene, int threads, bool applied_loads) {
             const py::gil_scoped_release without_lock;
             return Simulation(scene, {threads, applied_loads});
           }),
           py::arg("scene"), py::kw_only(), py::arg("threads") = 1, py::arg("applied_loads") = false)
      .def("step", &Simulation::step, py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("is_done", &Simulation::is_done)
      .def_property_readonly("end_of_course", &Simulation::end_of_course)
      .def_property_readonly("time", &Simulation::time)
      .def_property_readonly("steps", &Simulation::steps)
      .def_property_readonly("num_bodies", &Simulation::num_bodies)
      .def_property_readonly("bodies", &Simulation::bodies)
      .def_property_readonly("vessel", &Simulation::vessel)
      .def_property_readonly("step_columns", &Simulation::step_columns)
      .def_property_readonly("vessel_columns", &Simulation::vessel_columns)
      .def_property_readonly("modules", &Simulation::modules)
      .def_property_readonly("warnings", &Simulation::warnings)
      .def("apply", &Simulation::apply, py::arg("body"), py::arg("force"), py::arg("torque"), py::arg("point"))
      .def_property_readonly("commands", &Simulation::commands)
      .def("set_command", &Simulation::set_command, py::arg("name"), py::arg("value"))
      .def_property_readonly("last_problem", &Simulation::last_problem)
      .def_property_readonly("last_impulses", [](const Simulation& self) { return rows_of(self.last_impulses(), 3); })
      .def("snapshot", &Simulation::snapshot)
      .def("restore", &Simulation::restore, py::arg("snapshot"));
  py::class_<RunWriter>(module, "RunWriter")
      .def(py::init<const Simulation&, const std::filesystem::path&, bool>(), py::arg("simulation"), py::arg("folder"),
           py::arg("force") = false, py::keep_alive<1, 2>())
      .def("record", &RunWriter::record)
      .def("finish", &RunWriter::finish, py::arg("status") = "done");
}

}  // namespace nilas::python
