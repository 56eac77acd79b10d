#pragma once
/// Natural periods of a scene's vessel, on the force balance that holds it and on the water. docs/reference/scales.md
#include <string>
#include <vector>

#include "core/sim/world/world.h"

namespace nilas {

/// The stiff block of a vessel damps modes on its cells with fewer steps per period.
constexpr double k_least_steps_on_cells = 4;

struct NaturalPeriod {
  std::string motion;     ///< the larger part of the mode: surge, sway, heave, roll, pitch or yaw
  bool on_cells = false;  ///< the load cells hold more of its energy than the water does
  double period = 0;      ///< [s]
};

/// Of small motions about the vessel's pose at the start, undamped and without added mass, shortest first. Modes that
/// nothing holds have no period and are left out, and so are unstable ones. Empty without a vessel that can move.
std::vector<NaturalPeriod> natural_periods(const Scene& scene, const WorldParts& parts);

/// Heave of a floe of mean thickness that floats, without added mass [s]; 0 without floating ice.
double floe_heave_period(const Scene& scene, const WorldParts& parts);

}  // namespace nilas
