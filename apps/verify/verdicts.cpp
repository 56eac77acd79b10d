#include "apps/verify/verdicts.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "apps/verify/jobs.h"
#include "apps/verify/setting.h"
#include "contact/registry.h"
#include "core/base/error.h"

namespace nilas::verify {

namespace {

constexpr double k_variation = 1.1;
constexpr int k_order_steps = 5;
/// A measured order may be below the proven one by this much, because the steps are finite.
constexpr double k_order_allowance = 0.05;

bool has(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

bool takes(const contact::SolverEntry& solver, const std::string& law) {
  return std::find(solver.laws.begin(), solver.laws.end(), parse_law(law).law) != solver.laws.end();
}

double scale_of(const Quantity& q) { return q.scale > 0 ? q.scale : std::abs(q.expected); }
double error_of(const Quantity& q) { return std::abs(q.measured - q.expected) / scale_of(q); }

std::map<std::string, double> input_values(const Case& one, bool vary) {
  std::map<std::string, double> values;
  for (const auto& input : one.inputs)
    values[input.name] = input.value * (vary && input.name == one.varied ? k_variation : 1);
  return values;
}

/// Returns the slope of log(error) over log(step) by least squares.
double fitted_order(const std::vector<double>& steps, const std::vector<double>& errors) {
  double mean_x = 0, mean_y = 0, up = 0, down = 0;
  const auto n = static_cast<double>(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    mean_x += std::log(steps[i]) / n;
    mean_y += std::log(errors[i]) / n;
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double x = std::log(steps[i]) - mean_x;
    up += x * (std::log(errors[i]) - mean_y);
    down += x * x;
  }
  return up / down;
}

Row row_of(const Case& one, const Model& model, bool vary, const Quantity& q) {
  Row row;
  row.id = one.id();
  row.quantity = q.name;
  row.input = vary ? one.varied + " x 1.1" : "as given";
  row.family = one.family;
  row.model = model;
  row.measured = q.measured;
  row.expected = q.expected;
  row.error = error_of(q);
  row.scale = scale_of(q);
  row.tolerance = one.tolerance;
  row.holds = std::isfinite(q.expected) && row.error <= row.tolerance;
  return row;
}

/// Returns the entry of a list for the model's integrator, 0 where it has none.
double by_integrator(const std::vector<double>& list, const Case& one, const Model& model) {
  const auto at = std::find(one.integrators.begin(), one.integrators.end(), model.integrator);
  const auto k = static_cast<std::size_t>(at - one.integrators.begin());
  return k < list.size() ? list[k] : 0;
}

/// Judges a case at five steps. The error at the first step has a bound. The error at the last step may be that bound,
/// reduced at the proven order.
std::vector<Row> judge_order(const Case& one, const Model& model, bool vary, double order) {
  std::vector<double> steps;
  std::vector<std::vector<Quantity>> at;
  for (int k = 0; k < k_order_steps; ++k) {
    Model finer = model;
    finer.step = std::ldexp(model.step, -k);
    steps.push_back(finer.step);
    at.push_back(one.check(Setting(one, finer, input_values(one, vary))));
  }
  std::vector<Row> rows;
  for (std::size_t i = 0; i < at.front().size(); ++i) {
    std::vector<double> errors;
    for (const auto& quantities : at) errors.push_back(error_of(quantities[i]));
    Model finest = model;
    finest.step = steps.back();
    Row row = row_of(one, finest, vary, at.back()[i]);
    if (at.back()[i].exact) {
      rows.push_back(row);
      continue;
    }
    const double bound = by_integrator(one.coarsest, one, model);
    row.tolerance = bound * std::pow(steps.back() / steps.front(), order);
    row.order = fitted_order(steps, errors);
    row.proven_order = order;
    row.holds = errors.front() <= bound && row.error <= row.tolerance && row.order >= order - k_order_allowance;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::vector<const Case*> selected_cases(const Selection& selection) {
  std::vector<const Case*> chosen;
  const auto& all = catalogue();
  for (const auto& wanted : selection.cases) {
    std::string id = wanted;
    if (!id.empty()) id.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(id.front())));
    bool known = false;
    for (const auto& one : all) {
      if (id != one.id() && id != std::to_string(one.number) && id != std::string(1, one.family)) continue;
      known = true;
      if (std::find(chosen.begin(), chosen.end(), &one) == chosen.end()) chosen.push_back(&one);
    }
    if (!known)
      throw InputError("--case: found '" + wanted +
                       "', allowed: a case as 'A3' or '3', or a family as 'A'; nilas verify --list lists them");
  }
  if (selection.cases.empty())
    for (const auto& one : all) chosen.push_back(&one);
  return chosen;
}

std::vector<Model> models_of(const Case& one, const Selection& selection) {
  std::vector<Model> models;
  for (const auto& law : one.laws) {
    if (!selection.laws.empty() && !has(selection.laws, law)) continue;
    for (const auto& solver : contact::solver_registry()) {
      if (!takes(solver, law) || (!one.solvers.empty() && !has(one.solvers, solver.name))) continue;
      if (!selection.solvers.empty() && !has(selection.solvers, solver.name)) continue;
      for (std::size_t k = 0; k < one.integrators.size(); ++k) {
        // The solvers get problems of the same kind under either integrator, so the default set runs only `auto` with
        // both.
        const bool first = k == 0 || solver.name == "auto" || selection.all;
        if (first) models.push_back({law, solver.name, one.integrators[k], one.step});
      }
    }
    if (one.reference && !models.empty() && models.back().solver == "auto" && models.back().law == law)
      models.push_back({law, "auto", "reference", one.step});
  }
  return models;
}

std::vector<Row> judge(const Case& one, const Model& model, bool vary) {
  try {
    const double order = by_integrator(one.orders, one, model);
    if (order > 0) return judge_order(one, model, vary, order);
    std::vector<Row> rows;
    for (const auto& q : one.check(Setting(one, model, input_values(one, vary))))
      rows.push_back(row_of(one, model, vary, q));
    return rows;
  } catch (const FileError&) {
    throw;  // A missing scene is a fault of the installation, not of one row.
  } catch (const std::exception& error) {
    // A run that fails gives a row that fails, and the other runs continue.
    Row row = row_of(one, model, vary, {"run", 0, 0, 1});
    row.holds = false;
    row.message = error.what();
    return {row};
  }
}

std::vector<Row> verify(const Selection& selection, int threads, const std::function<void(double)>& done) {
  for (const auto& name : selection.solvers) contact::find_solver(name);
  for (const auto& name : selection.laws) parse_law(name);
  struct Job {
    const Case* one;
    Model model;
    bool vary;
  };
  std::vector<Job> jobs;
  for (const Case* one : selected_cases(selection))
    for (const auto& model : models_of(*one, selection)) {
      jobs.push_back({one, model, false});
      if (model.solver == "auto" || selection.all || has(selection.solvers, model.solver) ||
          (!one->solvers.empty() && model.solver == one->solvers.front()))
        jobs.push_back({one, model, true});
    }
  if (jobs.empty()) {
    std::string allowed;
    for (const Case* one : selected_cases(selection)) {
      allowed += (allowed.empty() ? "" : "; ") + one->id() + " with";
      for (const auto& law : one->laws) allowed += " " + law;
    }
    throw InputError(
        "no case runs with the solvers and laws that were given; allowed: " + allowed +
        ", and the solvers that take these laws (nilas solvers; docs/evidence/verification.md names exceptions)");
  }

  std::vector<std::vector<Row>> results(jobs.size());
  run_jobs(
      jobs.size(), threads, [&](std::size_t k) { results[k] = judge(*jobs[k].one, jobs[k].model, jobs[k].vary); },
      done);
  std::vector<Row> rows;
  for (auto& result : results) rows.insert(rows.end(), result.begin(), result.end());
  return rows;
}

}  // namespace nilas::verify
