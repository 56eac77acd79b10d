#include "apps/compare/scenes/setting.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"

namespace nilas {

namespace {

/// Sweeps of the older tool.
constexpr int k_fixed_sweeps = 50;

struct SimplificationText {
  Simplification which;
  const char* name;
  const char* meaning;
};

const std::vector<SimplificationText>& texts() {
  static const std::vector<SimplificationText> all{
      {Simplification::pyramid, "pyramid", "friction as a pyramid of two directions, not a cone"},
      {Simplification::equal_friction, "mu_s = mu_k", "static friction no higher than kinetic friction"},
      {Simplification::no_gyroscopic, "no gyroscopic torque", "the gyroscopic torque of spinning bodies left out"},
      {Simplification::split_impulse, "split impulse",
       "penetration taken back by pseudo velocities, not by projection"},
      {Simplification::discrete, "discrete detection",
       "contacts only where bodies are near at the step's start, not on their way"},
      {Simplification::fixed_sweeps, "50 sweeps", "50 sweeps of projected Gauss-Seidel, whatever error is left"},
      {Simplification::prismatic, "prismatic joint", "one prismatic joint in place of the six load cells"},
  };
  return all;
}

const SimplificationText& text_of(Simplification which) {
  return *std::find_if(texts().begin(), texts().end(), [&](const auto& t) { return t.which == which; });
}

/// Of all pairs with more static than kinetic friction.
Overrides equal_friction(const Scene& scene) {
  Overrides changes;
  for (std::size_t k = 0; k < scene.contact.friction.size(); ++k) {
    const FrictionScene& pair = scene.contact.friction[k];
    if (pair.static_ > pair.kinetic)
      changes.emplace_back(fmt::format("contact/friction[{}]/@static", k + 1), fmt::format("{}", pair.kinetic));
  }
  return changes;
}

void turn_on(Simplification which, const Scene& scene, CompareSetting& setting) {
  const auto set = [&](const char* path, const std::string& value) { setting.more.emplace_back(path, value); };
  switch (which) {
    case Simplification::pyramid:
      setting.law = "pyramid";
      break;
    case Simplification::equal_friction:
      for (const auto& change : equal_friction(scene)) setting.more.push_back(change);
      break;
    case Simplification::no_gyroscopic:
      set("contact/@gyroscopic", "false");
      break;
    case Simplification::split_impulse:
      setting.stabilisation = "split-impulse";
      break;
    case Simplification::discrete:
      set("contact/@detection", "discrete");
      break;
    case Simplification::fixed_sweeps:
      setting.solver = "pgs";
      setting.tolerance = 0;
      set("contact/@max_iterations", std::to_string(k_fixed_sweeps));
      break;
    case Simplification::prismatic:
      set("vessel/carriage/force_balance/@kind", "prismatic");
      break;
  }
}

}  // namespace

const char* name_of(Simplification simplification) { return text_of(simplification).name; }
const char* meaning_of(Simplification simplification) { return text_of(simplification).meaning; }

const std::vector<Simplification>& all_simplifications() {
  static const std::vector<Simplification> all = [] {
    std::vector<Simplification> list;
    for (const auto& text : texts()) list.push_back(text.which);
    return list;
  }();
  return all;
}

std::string no_effect(Simplification simplification, const Scene& scene) {
  if (simplification == Simplification::equal_friction && equal_friction(scene).empty())
    return "no pair of materials has more static than kinetic friction";
  if (simplification == Simplification::prismatic && !(scene.vessel && scene.vessel->carriage))
    return "the scene has no towing carriage";
  return "";
}

Overrides CompareSetting::overrides() const {
  Overrides all{{"contact/@solver", solver},
                {"contact/@law", law},
                {"time/@step", fmt::format("{}", step)},
                {"contact/@tolerance", fmt::format("{}", tolerance)},
                {"contact/@integrator", integrator},
                {"contact/@stabilisation", stabilisation}};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

CompareSetting setting_of(const Scene& scene) {
  const ContactScene& contact = scene.contact;
  return {contact.solver, contact.law, contact.integrator, contact.stabilisation, scene.time.step, contact.tolerance};
}

CompareSetting without_simplifications(const Scene& scene) {
  constexpr double k_tolerance = 1e-6;  // [m/s]
  constexpr int k_iterations = 1000;    // the default of <contact>
  CompareSetting setting = setting_of(scene);
  setting.law = "coulomb";
  if (setting.solver == "pgs") setting.solver = "auto";
  if (setting.tolerance == 0) setting.tolerance = k_tolerance;
  setting.stabilisation = "projection";
  // a preset's fixed number of sweeps is a simplification, too
  setting.more = {{"contact/@gyroscopic", "true"},
                  {"contact/@detection", "continuous"},
                  {"contact/@max_iterations", std::to_string(std::max(k_iterations, scene.contact.max_iterations))}};
  if (scene.vessel && scene.vessel->carriage)
    setting.more.emplace_back("vessel/carriage/force_balance/@kind", "six-cells");
  return setting;
}

CompareSetting with_simplifications(const Scene& scene, const std::vector<Simplification>& on) {
  CompareSetting setting = without_simplifications(scene);
  setting.simplifications = on;
  for (const Simplification which : on) turn_on(which, scene, setting);
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

/// An ablation turns them on singly, then all together.
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

}  // namespace nilas
