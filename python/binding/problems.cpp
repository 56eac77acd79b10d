#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "nilas/solve.h"
#include "python/binding/arrays.h"
#include "python/binding/module.h"
#include "python/binding/problem_docs.h"

namespace nilas::python {

namespace {

py::dict dict_of(const Residuals& residuals) {
  py::dict all;
  all["law_map_m_s"] = residuals.law_map_m_s;
  all["natural_map_m_s"] = residuals.natural_map_m_s;
  all["natural_map_rms_m_s"] = residuals.natural_map_rms_m_s;
  all["ccp_map_m_s"] = residuals.ccp_map_m_s;
  all["penetration_rate_m_s"] = residuals.penetration_rate_m_s;
  all["complementarity_J"] = residuals.complementarity_J;
  all["cone_violation_m_s"] = residuals.cone_violation_m_s;
  all["slip_angle_deg"] = residuals.slip_angle_deg;
  all["creep_m_s"] = residuals.creep_m_s;
  all["bipotential_J"] = residuals.bipotential_J;
  all["momentum_sqrtJ"] = residuals.momentum_sqrtJ;
  return all;
}

/// An array with three columns: one row per contact.
py::array_t<double> by_contact(std::vector<double> numbers) { return rows_of(std::move(numbers), 3); }

/// Three numbers for each contact, as (nc, 3) or one after the other. `what`: their name in messages.
std::span<const double> impulses_of(const Problem& problem, const char* what, const Numbers& r) {
  return span_of(what, r, {problem.num_contacts(), 3});
}

Solution solved(const Problem& problem, const std::string& solver, const std::string& law, double tolerance,
                const py::object& guess, int max_iterations, double max_seconds, int threads, bool history) {
  const SolveSettings settings{solver, law, tolerance, max_iterations, max_seconds, threads, history};
  Numbers first;
  if (!guess.is_none()) first = numbers_of("guess", guess);
  const std::span<const double> impulses =
      guess.is_none() ? std::span<const double>() : impulses_of(problem, "guess", first);
  const py::gil_scoped_release without_lock;
  return solve(problem, settings, impulses);
}

/// The shapes that hold for any number of contacts; whether the three arrays have the same number, the library checks.
Problem local_problem(const py::object& W, const py::object& q, const py::object& mu) {
  const Numbers matrix = numbers_of("W", W), velocities = numbers_of("q", q), friction = numbers_of("mu", mu);
  const bool is_square = matrix.ndim() == 2 && matrix.shape(0) == matrix.shape(1) && matrix.shape(0) % 3 == 0;
  demand_shape("W", matrix, is_square || matrix.ndim() == 1, "(3 nc, 3 nc) for nc contacts");
  const bool has_rows = velocities.ndim() == 2 && velocities.shape(1) == 3;
  demand_shape("q", velocities, has_rows || velocities.ndim() == 1, "(nc, 3) or (3 nc,) for nc contacts");
  demand_shape("mu", friction, friction.ndim() == 1, "(nc,) for nc contacts");
  const auto all = [](const Numbers& x) {
    return std::span<const double>(x.data(), static_cast<std::size_t>(x.size()));
  };
  return Problem::local(all(matrix), all(velocities), all(friction));
}

int add_body(Problem& problem, const py::object& mass, const py::object& momentum) {
  const Numbers matrix = numbers_of("mass", mass), vector = numbers_of("momentum", momentum);
  return problem.add_body(span_of("mass", matrix, {-1, -1}), span_of("momentum", vector, {-1}));
}

int add_contact(Problem& problem, int body_a, const py::object& jacobian_a, int body_b, const py::object& jacobian_b,
                const py::object& w, double mu) {
  const Numbers a = numbers_of("jacobian_a", jacobian_a), b = numbers_of("jacobian_b", jacobian_b);
  const Numbers gap = numbers_of("w", w);
  return problem.add_contact(body_a, span_of("jacobian_a", a, {3, -1}), body_b, span_of("jacobian_b", b, {3, -1}),
                             span_of("w", gap, {3}), mu);
}

void bind_problem(py::module_& module) {
  py::class_<Problem>(module, "Problem", docs::k_problem)
      .def(py::init<>(), "A problem without bodies and contacts, for add_body() and add_contact().")
      .def_static("local", &local_problem, py::arg("W"), py::arg("q"), py::arg("mu"), docs::k_local)
      .def_static("read", &Problem::read, py::arg("file"), docs::k_read)
      .def("add_body", &add_body, py::arg("mass"), py::arg("momentum"), docs::k_add_body)
      .def("add_contact", &add_contact, py::arg("body_a"), py::arg("jacobian_a"), py::arg("body_b"),
           py::arg("jacobian_b"), py::arg("w"), py::arg("mu"), docs::k_add_contact)
      .def_property_readonly("num_contacts", &Problem::num_contacts)
      .def_property_readonly("num_velocities", &Problem::num_velocities, "0 in the local form.")
      .def_property_readonly("is_local", &Problem::is_local)
      .def_property_readonly(
          "mu", [](const Problem& self) { return array_of(self.mu()); }, "Coefficients of friction, (nc,).")
      .def_property_readonly(
          "W",
          [](const Problem& self) {
            const py::ssize_t rows = 3 * static_cast<py::ssize_t>(self.num_contacts());
            return array_of(self.delassus(), {rows, rows});
          },
          "The Delassus operator H^T M^-1 H, (3 nc, 3 nc) [1/kg].")
      .def_property_readonly(
          "q", [](const Problem& self) { return by_contact(self.q()); },
          "Velocities at the contacts without impulses, (nc, 3) [m/s].")
      .def_property_readonly(
          "guess",
          [](const Problem& self) -> std::optional<py::array_t<double>> {
            if (auto guess = self.guess(); !guess.empty()) return by_contact(std::move(guess));
            return {};
          },
          "First guess of the impulses, (nc, 3) [N s], or None.")
      .def_property_readonly(
          "solution",
          [](const Problem& self) -> std::optional<py::array_t<double>> {
            if (auto solution = self.solution(); !solution.empty()) return by_contact(std::move(solution));
            return {};
          },
          "Impulses that came with the problem, (nc, 3) [N s], or None.")
      .def(
          "contact_velocities",
          [](const Problem& self, const py::object& impulses) {
            const Numbers r = numbers_of("impulses", impulses);
            return by_contact(self.contact_velocities(impulses_of(self, "impulses", r)));
          },
          py::arg("impulses"), docs::k_contact_velocities)
      .def(
          "velocities",
          [](const Problem& self, const py::object& impulses) {
            const Numbers r = numbers_of("impulses", impulses);
            return array_of(self.velocities(impulses_of(self, "impulses", r)));
          },
          py::arg("impulses"), docs::k_velocities)
      .def(
          "write",
          [](const Problem& self, const std::filesystem::path& file, const py::object& impulses) {
            if (impulses.is_none()) return self.write(file);
            const Numbers r = numbers_of("impulses", impulses);
            self.write(file, impulses_of(self, "impulses", r));
          },
          py::arg("file"), py::arg("impulses") = py::none(), docs::k_write);
}

void bind_solution(py::module_& module) {
  py::class_<Solution>(module, "Solution", docs::k_solution)
      .def_property_readonly(
          "impulses", [](const Solution& self) { return by_contact(self.impulses); }, "(nc, 3) [N s].")
      .def_property_readonly(
          "contact_velocities", [](const Solution& self) { return by_contact(self.contact_velocities); },
          "(nc, 3) [m/s].")
      .def_property_readonly(
          "velocities", [](const Solution& self) { return array_of(self.velocities); },
          "Those of the bodies; empty in the local form.")
      .def_readonly("status", &Solution::status, "converged, iteration_limit, stalled or numerical_error.")
      .def_readonly("converged", &Solution::converged)
      .def_readonly("iterations", &Solution::iterations)
      .def_readonly("seconds", &Solution::seconds, "Wall time of the solve [s].")
      .def_readonly("message", &Solution::message)
      .def_property_readonly(
          "history", [](const Solution& self) { return array_of(self.history); },
          "The residual after each iteration [m/s]; empty unless it was asked for.")
      .def_property_readonly(
          "residuals", [](const Solution& self) { return dict_of(self.residuals); },
          "Residuals by name, measured independently of the solver.")
      .def("__repr__", [](const Solution& self) {
        return "<nilas.Solution " + self.status + " after " + std::to_string(self.iterations) + " iterations>";
      });
}

}  // namespace

void bind_problems(py::module_& module) {
  bind_problem(module);
  bind_solution(module);
  module.def("solve", &solved, py::arg("problem"), py::kw_only(), py::arg("solver") = "auto",
             py::arg("law") = "coulomb", py::arg("tolerance") = 1e-8, py::arg("guess") = py::none(),
             py::arg("max_iterations") = 100000, py::arg("max_seconds") = 60.0, py::arg("threads") = 1,
             py::arg("history") = false);
  module.def(
      "measure",
      [](const Problem& problem, const py::object& impulses, const std::string& law) {
        const Numbers r = numbers_of("impulses", impulses);
        return dict_of(measure(problem, impulses_of(problem, "impulses", r), law));
      },
      py::arg("problem"), py::arg("impulses"), py::kw_only(), py::arg("law") = "coulomb");
  module.def("solvers", [] {
    py::dict all;
    for (const SolverInfo& info : solver_list()) {
      py::dict one;
      one["summary"] = info.summary;
      one["laws"] = info.laws;
      all[py::str(info.name)] = one;
    }
    return all;
  });
}

}  // namespace nilas::python
