#include "apps/compare/scenes/plan/grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <system_error>

#include "contact/registry.h"
#include "core/base/error.h"
#include "core/sim/reference/reference.h"
#include "core/sim/world/contact_model.h"

namespace nilas::compare {

namespace {

/// Whether an error is one of a file. It is none of the setting that was tried when the file could not be read.
bool is_of_file(const std::runtime_error& error) {
  const auto* const scene = dynamic_cast<const SceneError*>(&error);
  return (scene != nullptr && scene->only_unreadable_files()) || dynamic_cast<const FileError*>(&error) != nullptr ||
         dynamic_cast<const std::system_error*>(&error) != nullptr;
}

bool holds(const std::vector<CompareSetting>& settings, const CompareSetting& one) {
  return std::find(settings.begin(), settings.end(), one) != settings.end();
}

void demand_choice(const std::string& flag, const std::string& found, const std::vector<std::string>& allowed) {
  if (std::find(allowed.begin(), allowed.end(), found) != allowed.end()) return;
  std::string list;
  for (const auto& name : allowed) list += (list.empty() ? "" : ", ") + name;
  const std::string nearest = nearest_name(found, allowed);
  throw InputError(fmt::format("{}: found '{}'; allowed: {}{}", flag, found, list,
                               nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

void demand_names(const GridRequest& request) {
  for (const auto& solver : request.solvers) contact::find_solver(solver);
  for (const auto& law : request.laws) parse_law(law);
  for (const auto& name : request.integrators) demand_choice("--integrators", name, choice_names<Integrator>());
  for (const auto& name : request.stabilisations)
    demand_choice("--stabilisations", name, choice_names<Stabilisation>());
}

/// Adds settings that can run and are not there yet.
class Collector {
 public:
  Collector(const scene::Scene& scene, const scene::Overrides& overrides, Grid& grid)
      : scene_(scene), overrides_(overrides), grid_(grid) {}

  void add(const CompareSetting& setting) {
    const auto known = [&](const RefusedSetting& r) { return r.setting == setting; };
    if (holds(grid_.settings, setting) || std::any_of(grid_.refused.begin(), grid_.refused.end(), known)) return;
    try {
      read_with(scene_, overrides_, setting);
      grid_.settings.push_back(setting);
    } catch (const std::runtime_error& e) {
      if (is_of_file(e)) throw;
      grid_.refused.push_back({setting, e.what()});
    }
  }

 private:
  const scene::Scene& scene_;
  const scene::Overrides& overrides_;
  Grid& grid_;
};

/// Adds every combination of the values that were named. Axes without names keep the scene's own value.
void add_product(const CompareSetting& own, const GridRequest& request, std::vector<CompareSetting>& all) {
  const auto values = [](const auto& named, const auto& own_value) {
    using List = std::decay_t<decltype(named)>;
    return named.empty() ? List{own_value} : named;
  };
  for (const double step : values(request.steps, own.step))
    for (const auto& law : values(request.laws, own.law))
      for (const auto& solver : values(request.solvers, own.solver))
        for (const double tolerance : values(request.tolerances, own.tolerance))
          for (const auto& stabilisation : values(request.stabilisations, own.stabilisation))
            for (const auto& integrator : values(request.integrators, own.integrator))
              all.push_back({solver, law, integrator, stabilisation, step, tolerance});
}

/// Solver and law together, the second axis of the default grid.
struct SolverAndLaw {
  std::string solver, law;
};

std::vector<SolverAndLaw> default_models(const CompareSetting& own) {
  const std::string smooth = own.law == "frictionless" ? "frictionless" : "coulomb";
  std::vector<SolverAndLaw> models{{"auto", smooth}, {"nsgs", smooth}};
  if (smooth == "coulomb") {
    models.push_back({"pgs", "pyramid"});
    models.push_back({"auto", "ccp"});
  } else {
    models.push_back({"pgs", smooth});
  }
  models.push_back({"apgd", smooth});
  models.push_back({"newton", smooth});
  return models;
}

CompareSetting with_model(CompareSetting setting, const SolverAndLaw& model) {
  const bool same_solver = setting.solver == model.solver;
  setting.solver = model.solver;
  setting.law = model.law;
  if (setting.tolerance == 0 && !same_solver) {
    setting.tolerance = k_usual_tolerance;
    setting.more = {{"contact/@max_iterations", std::to_string(defaults::k_max_iterations)}};
  }
  return setting;
}

/// Adds half and double the scene's step, looser and tighter tolerances and the usual models; then two of these at
/// once.
void add_default(const CompareSetting& own, std::vector<CompareSetting>& all) {
  constexpr double k_decades = 100;
  std::vector<double> steps{own.step / 2, own.step * 2}, tolerances;
  if (own.tolerance > 0) tolerances = {own.tolerance * k_decades, own.tolerance / k_decades};
  const std::vector<SolverAndLaw> models = default_models(own);
  const auto stepped = [](CompareSetting s, double step) { return s.step = step, s; };
  const auto aiming = [](CompareSetting s, double tolerance) { return s.tolerance = tolerance, s; };
  for (const double step : steps) all.push_back(stepped(own, step));
  for (const auto& model : models) all.push_back(with_model(own, model));
  for (const double tolerance : tolerances) all.push_back(aiming(own, tolerance));
  for (const char* name : {"projection", "split-impulse"}) {
    all.push_back(own);
    all.back().stabilisation = name;
  }
  for (const char* name : {"semi-implicit-euler", "moreau"}) {
    all.push_back(own);
    all.back().integrator = name;
  }
  for (const double step : steps)
    for (const double tolerance : tolerances) all.push_back(aiming(stepped(own, step), tolerance));
  for (const double step : steps)
    for (const auto& model : models) all.push_back(with_model(stepped(own, step), model));
  for (const auto& model : models)
    for (const double tolerance : tolerances) all.push_back(with_model(aiming(own, tolerance), model));
}

void add_ablation(const scene::Scene& scene, const Grid& grid, Collector& collector) {
  std::vector<Simplification> together;
  collector.add(without_simplifications(scene));
  if (grid.settings.empty()) return;
  for (const Simplification which : all_simplifications()) {
    if (!no_effect(which, scene).empty()) continue;
    collector.add(with_simplifications(scene, {which}));
    together.push_back(which);
  }
  collector.add(with_simplifications(scene, together));
}

/// Throws InputError if the first setting cannot run, because the labels of all others name their difference from it.
void demand_first(const Grid& grid) {
  if (!grid.refused.empty() && grid.settings.empty()) throw InputError(grid.refused.front().reason);
}

}  // namespace

bool GridRequest::names_axes() const {
  return !solvers.empty() || !laws.empty() || !integrators.empty() || !stabilisations.empty() || !steps.empty() ||
         !tolerances.empty();
}

scene::Scene read_with(const scene::Scene& scene, const scene::Overrides& overrides, const CompareSetting& setting) {
  scene::Overrides all = overrides;
  const scene::Overrides own = setting.overrides();
  all.insert(all.end(), own.begin(), own.end());
  return scene::read_scene(scene.file, all);
}

Grid make_grid(const scene::Scene& scene, const scene::Overrides& overrides, const GridRequest& request) {
  demand_names(request);
  Grid grid;
  Collector collector(scene, overrides, grid);
  if (request.ablate) {
    add_ablation(scene, grid, collector);
    demand_first(grid);
    return grid;
  }
  const CompareSetting own = setting_of(scene);
  std::vector<CompareSetting> all;
  if (request.names_axes())
    add_product(own, request, all);
  else
    add_default(own, all);
  if (request.names_axes())
    std::stable_sort(all.begin(), all.end(), [&](const CompareSetting& a, const CompareSetting& b) {
      return differences(a, own).size() < differences(b, own).size();
    });
  collector.add(own);
  demand_first(grid);
  for (const auto& setting : all) collector.add(setting);
  if (grid.settings.size() < 2) {
    std::string why;
    for (const auto& refused : grid.refused) why += "\n  " + refused.reason;
    throw InputError(
        "There is nothing to compare with the scene's own setting. Name more solvers, laws, steps, tolerances, "
        "integrators or stabilisations." +
        why);
  }
  return grid;
}

std::size_t core_of(const Grid& grid, const GridRequest& request) {
  if (request.ablate) return grid.settings.size();
  const CompareSetting& own = grid.settings.front();
  std::size_t core = 0;
  while (core < grid.settings.size()) {
    auto axes = differences(grid.settings[core], own);
    // solver and law come together in the default grid
    if (!request.names_axes()) {
      std::erase(axes, "law");
      // a solver with a fixed number of sweeps sets no tolerance for another
      if (own.tolerance == 0 && grid.settings[core].solver != own.solver) std::erase(axes, "tolerance");
    }
    if (axes.size() > 1) break;
    ++core;
  }
  return core;
}

CompareSetting reference_setting(const scene::Scene& scene, const scene::Overrides& overrides, const Grid& grid,
                                 double tolerance) {
  CompareSetting reference = setting_of(scene);
  reference.law = scene.contact.law.law == Law::frictionless ? "frictionless" : "coulomb";
  reference.tolerance = tolerance;
  reference.stabilisation = "projection";
  reference.more = {
      {"contact/@gyroscopic", "true"},
      {"contact/@max_iterations", std::to_string(std::max(defaults::k_max_iterations, scene.contact.max_iterations))},
      {"contact/@on_failure", "record"}};
  const auto taken = [&] {
    try {
      read_with(scene, overrides, reference);
      return true;
    } catch (const std::runtime_error& e) {
      if (is_of_file(e)) throw;
      return false;
    }
  };
  reference.solver = "auto";
  reference.integrator = "reference";
  // A field of floes, or a hull towed into floes, has more contacts at once than that integrator can follow.
  const bool is_towed = scene.vessel && scene.vessel->carriage;
  const bool among_floes = scene.ice && (!scene.ice->fields.empty() || is_towed);
  if (!among_floes && taken()) return reference;
  for (const auto& setting : grid.settings) reference.step = std::min(reference.step, 0.5 * setting.step);
  for (const char* integrator : {"moreau", "semi-implicit-euler"}) {
    reference.integrator = integrator;
    if (taken()) return reference;
  }
  return reference;
}

}  // namespace nilas::compare
