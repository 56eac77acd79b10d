#include "apps/compare/scenes/plan/setting.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"

namespace nilas::compare {

scene::Overrides CompareSetting::overrides() const {
  scene::Overrides all{{"contact/@solver", solver},
                       {"contact/@law", law},
                       {"time/@step", fmt::format("{}", step)},
                       {"contact/@tolerance", fmt::format("{}", tolerance)},
                       {"contact/@integrator", integrator},
                       {"contact/@stabilisation", stabilisation}};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

CompareSetting setting_of(const scene::Scene& scene) {
  const scene::ContactScene& contact = scene.contact;
  return {name_of(contact.solver),        name_of(contact.law), name_of(contact.integrator),
          name_of(contact.stabilisation), scene.time.step,      contact.tolerance};
}

CompareSetting without_simplifications(const scene::Scene& scene) {
  CompareSetting setting = setting_of(scene);
  setting.law = "coulomb";
  if (setting.solver == "pgs") setting.solver = "auto";
  if (setting.tolerance == 0) setting.tolerance = k_usual_tolerance;
  setting.stabilisation = "projection";
  // a preset's fixed number of sweeps is a simplification, too
  setting.more = {
      {"contact/@max_iterations", std::to_string(std::max(defaults::k_max_iterations, scene.contact.max_iterations))}};
  for (const Simplification which : all_simplifications()) {
    const scene::Overrides changes = taking_out(which, scene);
    setting.more.insert(setting.more.end(), changes.begin(), changes.end());
  }
  return setting;
}

CompareSetting with_simplifications(const scene::Scene& scene, const std::vector<Simplification>& on) {
  CompareSetting setting = without_simplifications(scene);
  setting.simplifications = on;
  for (const Simplification which : on) {
    if (which == Simplification::pyramid) setting.law = "pyramid";
    if (which == Simplification::split_impulse) setting.stabilisation = "split-impulse";
    if (which == Simplification::fixed_sweeps) {
      setting.solver = "pgs";
      setting.tolerance = 0;
    }
    const scene::Overrides changes = putting_in(which, scene);
    setting.more.insert(setting.more.end(), changes.begin(), changes.end());
  }
  return setting;
}

std::vector<std::string> differences(const CompareSetting& a, const CompareSetting& b) {
  std::vector<std::string> axes;
  const auto note = [&](bool same, const char* axis) {
    if (!same) axes.emplace_back(axis);
  };
  note(a.solver == b.solver, "solver");
  note(a.law == b.law, "law");
  note(a.step == b.step, "step");
  note(a.tolerance == b.tolerance, "tolerance");
  note(a.stabilisation == b.stabilisation, "stabilisation");
  note(a.integrator == b.integrator, "integrator");
  return axes;
}

bool is_part(const CompareSetting& part, const CompareSetting& whole, const CompareSetting& first) {
  const auto either = [](const auto& value, const auto& one, const auto& other) {
    return value == one || value == other;
  };
  return part != whole && part != first && either(part.solver, whole.solver, first.solver) &&
         either(part.law, whole.law, first.law) && either(part.step, whole.step, first.step) &&
         either(part.tolerance, whole.tolerance, first.tolerance) &&
         either(part.stabilisation, whole.stabilisation, first.stabilisation) &&
         either(part.integrator, whole.integrator, first.integrator) &&
         either(part.simplifications, whole.simplifications, first.simplifications) &&
         either(part.more, whole.more, first.more);
}

/// The label of a setting in an ablation, which turns simplifications on singly, then all together.
static std::string simplifications_label(const CompareSetting& setting) {
  if (setting.simplifications.size() > 1) return "all together";
  return setting.simplifications.empty() ? "none" : name_of(setting.simplifications.front());
}

static std::string axis_text(const CompareSetting& setting, const std::string& axis) {
  if (axis == "solver") return setting.solver;
  if (axis == "law") return setting.law;
  if (axis == "step") return fmt::format("step {:g} s", setting.step);
  if (axis == "tolerance")
    return setting.tolerance > 0 ? fmt::format("tolerance {:g} m/s", setting.tolerance) : std::string("fixed sweeps");
  return axis == "stabilisation" ? setting.stabilisation : setting.integrator;
}

std::string label_of(const CompareSetting& setting, const CompareSetting& first) {
  if (!first.more.empty()) return simplifications_label(setting);
  std::string label;
  for (const auto& axis : differences(setting, first)) label += (label.empty() ? "" : " + ") + axis_text(setting, axis);
  return label.empty() ? "own setting" : label;
}

std::string full_label(const CompareSetting& setting) {
  std::string label;
  for (const char* axis : {"solver", "law", "step", "tolerance", "stabilisation", "integrator"})
    label += (label.empty() ? "" : ", ") + axis_text(setting, axis);
  return label;
}

std::string label_without_step(CompareSetting setting, const CompareSetting& first) {
  setting.step = first.step;
  return label_of(setting, first);
}

std::string simplifications_text(const CompareSetting& setting) {
  std::string text;
  for (const Simplification which : setting.simplifications)
    text += std::string(text.empty() ? "" : ";") + name_of(which);
  return text;
}

double coarsest_step(const std::vector<CompareSetting>& settings) {
  double step = 0;
  for (const auto& setting : settings) step = std::max(step, setting.step);
  return step;
}

}  // namespace nilas::compare
