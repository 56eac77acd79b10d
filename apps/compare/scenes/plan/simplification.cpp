#include "apps/compare/scenes/plan/simplification.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/log.h"
#include "core/sim/simulation.h"

namespace nilas::compare {

namespace {

/// The number of sweeps that replaces a tolerance.
constexpr int k_fixed_sweeps = 50;
/// The coefficient of variation of strength if a scene draws none. Strengths scatter by 20 to 30 % in nature
/// (docs/reference/scales.md).
constexpr double k_cov = 0.25;
/// The correlation length of strength in thicknesses. It is not measured, but is about the length of a broken piece.
constexpr double k_correlation_thicknesses = 10;

struct SimplificationText {
  Simplification which;
  const char* name;
  const char* meaning;
};

const std::vector<SimplificationText>& texts() {
  using enum Simplification;
  static const std::vector<SimplificationText> all{
      {pyramid, "pyramid", "friction is a pyramid of two directions, not a cone"},
      {fixed_sweeps, "50 sweeps", "the solver makes 50 sweeps of projected Gauss-Seidel, whatever error is left"},
      {crushing_limit, "crushing by a limit",
       "the crushing force is at most strength times the contact area at the step's start; its growth within the "
       "step is left out"},
      {geometric_splitting, "splitting by geometry",
       "a floe splits where its chord is short, not where the forces reach its fracture toughness"},
      {straight_cracks, "straight cracks", "cracks run straight, whatever weak ice lies next to their path"},
      {uniform_ice, "uniform ice", "all ice is of the same thickness, density and strength"},
      {rigid_floes, "rigid floes", "floes crush at the hull, but not each other"},
      {no_extrusion, "no extrusion", "crushed ice leaves the outline of its floe as it is"},
      {split_impulse, "split impulse", "penetration is corrected by pseudo velocities, not by projection"},
      {discrete, "discrete detection",
       "contacts are found only where bodies are near at the step's start, not along their path"},
      {library_contacts, "FCL's contacts",
       "contacts are those of the collision library FCL, not those of an exact search"},
      {equal_friction, "mu_s = mu_k", "static friction is no higher than kinetic friction"},
      {rigid_contacts, "rigid contacts", "contacts are rigid, not springs"},
      {no_rolling, "no rolling friction", "rolling and spinning friction are left out"},
      {no_gyroscopic, "no gyroscopic torque", "the gyroscopic torque of spinning bodies is left out"},
      {uniform_inertia, "uniform inertia", "the vessel's inertia is that of uniform density, not the one given"},
      {prismatic, "prismatic joint", "one prismatic joint replaces the six load cells"},
  };
  return all;
}

const SimplificationText& entry_of(Simplification which) {
  return *std::find_if(texts().begin(), texts().end(), [&](const auto& t) { return t.which == which; });
}

std::string friction_path(std::size_t k, const char* attribute) {
  return fmt::format("contact/friction[{}]/@{}", k + 1, attribute);
}

/// The overrides that lower static to kinetic friction for all pairs that have more of it.
scene::Overrides static_as_kinetic(const scene::Scene& scene) {
  scene::Overrides changes;
  for (std::size_t k = 0; k < scene.contact.friction.size(); ++k) {
    const scene::FrictionScene& pair = scene.contact.friction[k];
    if (pair.static_ > pair.kinetic) changes.emplace_back(friction_path(k, "static"), fmt::format("{}", pair.kinetic));
  }
  return changes;
}

scene::Overrides without_moments(const scene::Scene& scene) {
  scene::Overrides changes;
  for (std::size_t k = 0; k < scene.contact.friction.size(); ++k) {
    const scene::FrictionScene& pair = scene.contact.friction[k];
    if (pair.rolling > 0) changes.emplace_back(friction_path(k, "rolling"), "0");
    if (pair.spinning > 0) changes.emplace_back(friction_path(k, "spinning"), "0");
  }
  return changes;
}

/// The overrides that make the elastic pairs rigid.
scene::Overrides without_springs(const scene::Scene& scene) {
  scene::Overrides changes;
  for (std::size_t k = 0; k < scene.contact.friction.size(); ++k)
    if (scene.contact.friction[k].elastic) changes.emplace_back(friction_path(k, "elastic"), "false");
  return changes;
}

const scene::CrushingScene* crushing_of(const scene::Scene& scene) {
  return scene.fracture && scene.fracture->crushing ? &*scene.fracture->crushing : nullptr;
}

/// Whether the scene has ice that breaks or splits by its strength.
bool breaks(const scene::Scene& scene) {
  return scene.ice && scene.fracture && (scene.fracture->bending || scene.fracture->splitting);
}

bool varies(const scene::Scene& scene) { return scene.ice && !scene.ice->vary.empty(); }

/// Whether ice is, or can be made, weaker in some places of a floe than in others.
bool has_weak_places(const scene::Scene& scene) {
  if (!varies(scene)) return breaks(scene);  // taking_out(uniform_ice) draws strengths within floes
  const scene::IceScene& ice = *scene.ice;
  return !ice.weak_lines.empty() || std::any_of(ice.fields.begin(), ice.fields.end(), [](const scene::FieldScene& f) {
    const auto* cells = std::get_if<scene::VoronoiFieldScene>(&f.form);
    return cells && cells->bond;
  }) || std::any_of(ice.vary.begin(), ice.vary.end(), [](const scene::VaryScene& v) {
    return v.correlation_length > 0;
  });
}

/// The inertia that `<vessel><mass>` has by default, as the attribute's text [kg m^2].
std::string inertia_by_default(const scene::Scene& scene) {
  scene::Scene bare = scene;
  bare.vessel->mass.inertia.reset();
  bare.ice.reset();
  bare.fracture.reset();
  WarningCounts warnings(make_logger("off", ""));
  const Mat3 I = sim::Simulation(bare, 1, warnings).info().vessel_mass.inertia;
  return fmt::format("{} {} {} {} {} {}", I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
}

/// The same as no_effect() for simplifications of the ice: crushing, splitting, cracks and their material.
std::string no_effect_on_ice(Simplification simplification, const scene::Scene& scene) {
  using enum Simplification;
  switch (simplification) {
    case crushing_limit:
    case rigid_floes:
    case no_extrusion:
      return crushing_of(scene) ? "" : "no ice of the scene crushes";
    case geometric_splitting:
      return scene.fracture && scene.fracture->splitting ? "" : "no ice of the scene splits";
    case straight_cracks:
      if (!breaks(scene)) return "no ice of the scene cracks";
      return has_weak_places(scene) ? "" : "no floe of the scene is weaker in some places than in others";
    case uniform_ice:
      return varies(scene) || breaks(scene) ? "" : "the ice of the scene neither varies nor cracks";
    default:
      return "";
  }
}

}  // namespace

const char* name_of(Simplification simplification) { return entry_of(simplification).name; }
const char* meaning_of(Simplification simplification) { return entry_of(simplification).meaning; }

const std::vector<Simplification>& all_simplifications() {
  static const std::vector<Simplification> all = [] {
    std::vector<Simplification> list;
    for (const auto& text : texts()) list.push_back(text.which);
    return list;
  }();
  return all;
}

std::string no_effect(Simplification simplification, const scene::Scene& scene) {
  using enum Simplification;
  if (simplification == equal_friction && static_as_kinetic(scene).empty())
    return "no pair of materials has more static than kinetic friction";
  if (simplification == no_rolling && without_moments(scene).empty())
    return "no pair of materials has rolling or spinning friction";
  if (simplification == rigid_contacts && without_springs(scene).empty()) return "no pair of materials is elastic";
  if (simplification == prismatic && !(scene.vessel && scene.vessel->carriage))
    return "the scene has no towing carriage";
  if (simplification == prismatic && !scene.vessel->rods.empty())
    return "rods tie the vessel, and a prismatic joint may not be able to take their forces";
  if (simplification == no_gyroscopic && scene.vessel && !(scene.vessel->parts.empty() && scene.vessel->rods.empty()))
    return "a vessel with parts or rods always has its gyroscopic torque";
  if (simplification == uniform_inertia && !(scene.vessel && scene.vessel->mass.inertia))
    return "the scene gives its vessel no inertia of its own";
  return no_effect_on_ice(simplification, scene);
}

scene::Overrides taking_out(Simplification simplification, const scene::Scene& scene) {
  using enum Simplification;
  if (!no_effect(simplification, scene).empty()) return {};
  switch (simplification) {
    case no_gyroscopic:
      return {{"contact/@gyroscopic", "true"}};
    case discrete:
      return {{"contact/@detection", "continuous"}};
    case library_contacts:
      return {{"contact/@narrow_phase", "nilas"}};
    case prismatic:
      return {{"vessel/carriage/force_balance/@kind", "six-cells"}};
    case crushing_limit:
      if (crushing_of(scene)->model != CrushingModel::explicit_area) return {};
      return {{"fracture/crushing/@model", "compliant"}};
    case rigid_floes:
      return {{"fracture/crushing/@between_floes", "true"}};
    case no_extrusion: {
      if (crushing_of(scene)->clear_volume) return {};
      const double thickness = scene.ice ? scene.ice->thickness : 0;
      return {{"fracture/crushing/@clear_volume", fmt::format("{}", thickness * thickness * thickness)}};
    }
    case geometric_splitting:
      return {{"fracture/splitting/@model", "lefm"}};
    case straight_cracks:
      return {{"fracture/cracks/@path", "curved"}};
    case uniform_ice:
      if (varies(scene)) return {};
      return {{"ice/vary[+]/@property", "flexural_strength"},
              {"ice/vary[+]/@cov", fmt::format("{}", k_cov)},
              {"ice/vary[+]/@correlation_length", fmt::format("{}", k_correlation_thicknesses * scene.ice->thickness)}};
    default:
      return {};
  }
}

scene::Overrides putting_in(Simplification simplification, const scene::Scene& scene) {
  using enum Simplification;
  switch (simplification) {
    case equal_friction:
      return static_as_kinetic(scene);
    case no_rolling:
      return without_moments(scene);
    case rigid_contacts:
      return without_springs(scene);
    case no_gyroscopic:
      return {{"contact/@gyroscopic", "false"}};
    case discrete:
      return {{"contact/@detection", "discrete"}};
    case library_contacts:
      return {{"contact/@narrow_phase", "fcl"}};
    case fixed_sweeps:
      return {{"contact/@max_iterations", std::to_string(k_fixed_sweeps)}};
    case prismatic:
      return {{"vessel/carriage/force_balance/@kind", "prismatic"}};
    case uniform_inertia:
      return {{"vessel/mass/@inertia", inertia_by_default(scene)}};
    case crushing_limit:
      return {{"fracture/crushing/@model", "explicit"}};
    case rigid_floes:
      return {{"fracture/crushing/@between_floes", "false"}};
    case no_extrusion:
      return {{"fracture/crushing/@clear_volume",
               "1e30"}};  // no floe is that large, and an override cannot unset an attribute
    case geometric_splitting:
      return {{"fracture/splitting/@model", "geometric"}};
    case straight_cracks:
      return {{"fracture/cracks/@path", "straight"}};
    case uniform_ice: {
      if (!varies(scene)) return {{"ice/vary[+]/@cov", "0"}};
      scene::Overrides changes;
      for (std::size_t k = 0; k < scene.ice->vary.size(); ++k)
        changes.emplace_back(fmt::format("ice/vary[{}]/@cov", k + 1), "0");
      return changes;
    }
    case pyramid:
    case split_impulse:
      break;
  }
  return {};
}

const std::vector<Inexpressible>& inexpressible_simplifications() {
  static const std::vector<Inexpressible> all{
      {"hydrodynamics", "no setting has added mass, wave damping, a moving free surface, or water between floes"},
      {"creep", "ice does not creep in any setting"},
      {"instantaneous cracks", "cracks run through a floe within one step in every setting"},
      {"a second contact search for breaking", "one search finds impacts and another finds the area that crushes"}};
  return all;
}

}  // namespace nilas::compare
