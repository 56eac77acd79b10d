#pragma once
/// Natural periods of a scene's vessel on its force balance, its mooring and the water. docs/reference/scales.md
#include <string>
#include <vector>

#include "core/sim/world/world.h"

namespace nilas::sim {

/// Steps per period below which the stiff block of a vessel damps modes on its cells.
constexpr double k_least_steps_on_cells = 4;

struct NaturalPeriod {
  std::string motion;       ///< name of the dominant motion: surge, sway, heave, roll, pitch or yaw
  bool on_cells = false;    ///< true if the load cells hold more of its energy than the water does
  bool on_mooring = false;  ///< true if the mooring lines hold more of its energy than the water does
  double period = 0;        ///< [s]

  /// "the load cells", "the mooring" or "the water".
  std::string held_by() const;
};

/// Periods of small motions about the vessel's initial pose, undamped and with the hull's added mass, shortest first.
/// Modes without stiffness and unstable modes are left out. Empty without a vessel that can move.
std::vector<NaturalPeriod> natural_periods(const scene::Scene& scene, const WorldParts& parts);

/// The greatest rate at which the damping of the mooring lines slows a motion of the vessel, from its mass with added
/// mass [1/s]; 0 without damped lines. A step that is longer than its inverse overshoots, and beyond twice the inverse
/// the explicit damping makes velocities grow.
double mooring_damping_rate(const WorldParts& parts);

/// Heave period of a floating floe of mean thickness, without added mass [s]; 0 without floating ice.
double floe_heave_period(const scene::Scene& scene, const WorldParts& parts);

}  // namespace nilas::sim
