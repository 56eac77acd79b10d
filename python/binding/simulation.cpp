#include "nilas/simulation.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <memory>

#include "python/binding/arrays.h"
#include "python/binding/module.h"
#include "python/binding/session.h"
#include "python/binding/simulation_docs.h"

namespace nilas::python {

namespace {

void bind_steps(py::module_& module) {
  py::class_<VesselStep>(module, "VesselStep", docs::k_vessel_step)
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
          "(4,) unit quaternion (w, x, y, z) from body axes to the ground frame");
  py::class_<Step>(module, "Step", docs::k_step)
      .def_readonly("number", &Step::number, "The first is 1.")
      .def_readonly("time", &Step::time, "At its end [s].")
      .def_readonly("contacts", &Step::contacts)
      .def_readonly("floes", &Step::floes)
      .def_readonly("iterations", &Step::iterations)
      .def_readonly("solved", &Step::solved, "Whether the solver reached the scene's tolerance.")
      .def_readonly("message", &Step::message, "What the solver did, or why it failed.")
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
  py::class_<BodyStates>(module, "BodyStates", docs::k_body_states)
      .def_readonly("id", &BodyStates::id)
      .def_readonly("name", &BodyStates::name)
      .def_readonly("kind", &BodyStates::kind, "floe, rigid, wall or vessel")
      .def_property_readonly(
          "mass", [](const BodyStates& self) { return array_of(self.mass); }, "(n,) [kg]")
      .def_property_readonly(
          "position", [](const BodyStates& self) { return fixed_rows_of(self.position, 3); },
          "(n, 3) centre of mass [m]")
      .def_property_readonly(
          "orientation", [](const BodyStates& self) { return fixed_rows_of(self.orientation, 4); },
          "(n, 4) unit quaternions (w, x, y, z) from body axes to the ground frame")
      .def_property_readonly(
          "velocity", [](const BodyStates& self) { return fixed_rows_of(self.velocity, 3); }, "(n, 3) [m/s]")
      .def_property_readonly(
          "angular_velocity", [](const BodyStates& self) { return fixed_rows_of(self.angular_velocity, 3); },
          "(n, 3), ground frame [rad/s]");
}

}  // namespace

void bind_simulation(py::module_& module) {
  bind_steps(module);
  bind_bodies(module);
  py::class_<Snapshot>(module, "Snapshot", docs::k_snapshot);
  py::class_<Session>(module, "Simulation")
      .def(py::init([](const Scene& scene, int threads, bool applied_loads,
                       const std::optional<std::filesystem::path>& folder, bool force, bool keep_rows) {
             return std::make_unique<Session>(scene, SimulationSettings{threads, applied_loads}, folder, force,
                                              keep_rows);
           }),
           py::arg("scene"), py::kw_only(), py::arg("threads") = 1, py::arg("applied_loads") = false,
           py::arg("folder") = py::none(), py::arg("force") = false, py::arg("keep_rows") = true)
      .def("step", &Session::step)
      .def("finish", &Session::finish, py::arg("status"), py::arg("message") = "")
      .def_property_readonly("last", &Session::last)
      .def_property_readonly("rows",
                             [](const Session& self) {
                               return rows_of(self.rows(),
                                              static_cast<py::ssize_t>(self.simulation().step_columns().size()));
                             })
      .def_property_readonly("vessel_rows",
                             [](const Session& self) {
                               const std::size_t columns = self.simulation().vessel_columns().size();
                               return rows_of(self.vessel_rows(),
                                              static_cast<py::ssize_t>(std::max<std::size_t>(1, columns)));
                             })
      .def_property_readonly("is_done", [](const Session& self) { return self.simulation().is_done(); })
      .def_property_readonly("end_of_course", [](const Session& self) { return self.simulation().end_of_course(); })
      .def_property_readonly("time", [](const Session& self) { return self.simulation().time(); })
      .def_property_readonly("steps", [](const Session& self) { return self.simulation().steps(); })
      .def_property_readonly("num_bodies", [](const Session& self) { return self.simulation().num_bodies(); })
      .def_property_readonly("bodies", [](const Session& self) { return self.simulation().bodies(); })
      .def_property_readonly("vessel", [](const Session& self) { return self.simulation().vessel(); })
      .def_property_readonly("step_columns", [](const Session& self) { return self.simulation().step_columns(); })
      .def_property_readonly("vessel_columns", [](const Session& self) { return self.simulation().vessel_columns(); })
      .def_property_readonly("modules", [](const Session& self) { return self.simulation().modules(); })
      .def_property_readonly("warnings", [](const Session& self) { return self.simulation().warnings(); })
      .def(
          "apply",
          [](Session& self, int body, const Vector3& force, const Vector3& torque,
             const std::optional<Vector3>& point) { self.simulation().apply(body, force, torque, point); },
          py::arg("body"), py::arg("force"), py::arg("torque"), py::arg("point"))
      .def_property_readonly("commands", [](const Session& self) { return self.simulation().commands(); })
      .def(
          "set_command",
          [](Session& self, const std::string& name, double value) { self.simulation().set_command(name, value); },
          py::arg("name"), py::arg("value"))
      .def_property_readonly("last_problem", [](const Session& self) { return self.simulation().last_problem(); })
      .def_property_readonly("last_impulses",
                             [](const Session& self) { return rows_of(self.simulation().last_impulses(), 3); })
      .def("snapshot", [](const Session& self) { return self.simulation().snapshot(); })
      .def("restore", &Session::restore, py::arg("snapshot"));
}

}  // namespace nilas::python
