#include "core/sim/build/water_doubts.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"
#include "core/sim/build/natural_periods.h"
#include "core/vessel/mooring/moordyn_file.h"
#include "hydro/equilibrium.h"

namespace nilas::sim {

namespace {

void judge_added_mass(const scene::Scene& scene, std::vector<WaterDoubt>& doubts) {
  const auto& added = scene.hydro ? scene.hydro->added_mass : std::nullopt;
  if (added && added->vessel != VesselAddedMass::none && scene.vessel->fixed)
    doubts.push_back(
        {"hydro/added_mass/@vessel",
         "the vessel is fixed and never accelerates, so its added mass has no effect; take vessel=\"none\""});
}

/// The attitude at which the mesh floats beside the level one of the linear hydrostatics.
void judge_restoring(const scene::Scene& scene, const WorldParts& parts, std::vector<WaterDoubt>& doubts) {
  if (!scene.hydro || !scene.hydro->restoring || !parts.water) return;
  constexpr double k_level = 1 * k_deg;
  const auto b = static_cast<std::size_t>(parts.vessel_index);
  const Mat3& R = parts.bodies.R_GB[b];
  const Quat upright(Eigen::AngleAxisd(std::atan2(R(1, 0), R(0, 0)), Vec3::UnitZ()));
  try {
    const hydro::FloatingEquilibrium rest =
        hydro::floating_equilibrium(*parts.bodies.shape[b], parts.bodies.mass[b], upright, *parts.water);
    if (std::abs(rest.trim) <= k_level && std::abs(rest.heel) <= k_level) return;
    doubts.push_back(
        {"hydro/restoring",
         fmt::format(
             "the mesh of the hull floats with a trim of {:.3g} deg, positive by the bow, and "
             "a heel of {:.3g} deg, but the linear hydrostatics of the database hold about "
             "the level attitude; place the centre of mass on the vertical through the mesh's centre of buoyancy",
             rest.trim / k_deg, rest.heel / k_deg)});
  } catch (const InputError& error) {
    doubts.push_back({"hydro/restoring", std::string("the mesh of the hull has no rest afloat that the linear "
                                                     "hydrostatics could stand for: ") +
                                             error.what()});
  }
}

void judge_damping(const scene::Scene& scene, const WorldParts& parts, std::vector<WaterDoubt>& doubts) {
  const double rate = mooring_damping_rate(parts), product = rate * scene.time.step;
  constexpr double k_overshoots = 1, k_grows = 2;
  if (product > k_overshoots)
    doubts.push_back(
        {"vessel/mooring",
         fmt::format(
             "the damping of the lines slows the vessel at the rate of {:.3g} 1/s, and the step of {:g} s times "
             "this rate is {:.3g}; {}; take a step of at most {:.3g} s, or {:.3g} times the damping",
             rate, scene.time.step, product,
             product > k_grows ? "above 2 explicit damping makes velocities grow"
                               : "above 1 explicit damping overshoots",
             1 / rate, 1 / product)});
}

/// Depth of the scene's water where it states one [m].
std::optional<double> depth_of(const scene::Scene& scene) {
  if (scene.tank && scene.tank->floor) return scene.tank->depth;
  if (scene.water)
    for (const scene::WaveScene& waves : scene.water->waves)
      if (waves.depth) return waves.depth;
  return std::nullopt;
}

void judge_moordyn(const scene::Scene& scene, std::vector<WaterDoubt>& doubts) {
  const auto& mooring = scene.vessel->mooring;
  if (!mooring || mooring->model != MooringKind::moordyn) return;
  constexpr double k_alike = 0.02;  // share within which two values mean the same
  const auto compare = [&](const char* what, const char* unit, const std::optional<double>& stated,
                           const std::optional<double>& of_scene) {
    if (stated && of_scene && *of_scene > 0 && std::abs(*stated / *of_scene - 1) > k_alike)
      doubts.push_back(
          {"vessel/mooring/@file",
           fmt::format("the file of MoorDyn states the {} {:g}{}, but that of the scene is {:g}{}; the lines "
                       "take that of the file",
                       what, *stated, unit, *of_scene, unit)});
  };
  const vessel::MoordynWater file = vessel::moordyn_water(mooring->file);
  compare("depth", " m", file.depth, depth_of(scene));
  compare("density of the water", " kg/m^3", file.density,
          scene.water ? std::optional(scene.water->density) : std::nullopt);
  compare("gravity", " m/s^2", file.gravity, scene.gravity.norm());
}

}  // namespace

std::vector<WaterDoubt> water_doubts(const scene::Scene& scene, const WorldParts& parts) {
  std::vector<WaterDoubt> doubts;
  if (!scene.vessel) return doubts;
  judge_added_mass(scene, doubts);
  judge_restoring(scene, parts, doubts);
  judge_damping(scene, parts, doubts);
  judge_moordyn(scene, doubts);
  return doubts;
}

}  // namespace nilas::sim
