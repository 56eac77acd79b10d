#pragma once
/// Where a towed vessel goes: what it meets on its prescribed course, and where a run must end before its time.
#include <optional>
#include <string>

#include "core/sim/world/world.h"

namespace nilas {

/// What the course of a towed vessel meets within the run, as far as it is known beforehand: the hull as a rigid body
/// that the carriage moves, and ice that stays where it is. [s]
struct CourseForecast {
  std::optional<double> meets_wall;
  std::string wall;                   ///< "the tank's end wall (x = 27 m)"
  std::optional<double> reaches_ice;  ///< hull and ice overlap as seen along X and along Y; nothing: not within the run
  std::optional<double> leaves_ice;   ///< from then on no more
  bool has_ice_at_rest = false;       ///< the two above mean something
};
/// Nothing without a vessel on a carriage that moves.
std::optional<CourseForecast> course_forecast(const Scene& scene, const WorldParts& parts);

/// Fills course_within: the tank of a towed vessel that starts within its walls.
void describe_course(const Scene& scene, WorldParts& parts);

/// Why a run cannot take the step of length h [s] from time t [s]: the carriage would drive the hull into a wall of the
/// tank, or its path has ended. A whole sentence; empty where the run can go on.
std::string end_of_course(const WorldParts& parts, double t, double h);

}  // namespace nilas
