#pragma once
/// The course of a towed vessel: what it meets there, and when the run must end early.
#include <optional>
#include <string>

#include "core/sim/world/world.h"

namespace nilas::sim {

/// Events on the course of a towed vessel, as far as known beforehand [s]. The hull is a rigid body on the carriage,
/// and the ice stays in place.
struct CourseForecast {
  std::optional<double> meets_wall;
  std::string wall;                   ///< "the tank's end wall (x = 27 m)"
  std::optional<double> reaches_ice;  ///< first overlap of hull and ice along both X and Y; empty: not within the run
  std::optional<double> leaves_ice;   ///< end of the last overlap
  bool has_ice_at_rest = false;       ///< true if the two above are meaningful
};
/// The forecast; empty without a vessel on a moving carriage.
std::optional<CourseForecast> course_forecast(const scene::Scene& scene, const WorldParts& parts);

/// Fills course_within with the tank of a towed vessel that starts within its walls.
void describe_course(const scene::Scene& scene, WorldParts& parts);

/// The reason why a run cannot take the step of length h [s] from time t [s], as a whole sentence: the carriage would
/// drive the hull into a wall of the tank, or its path has ended. Empty where the run can continue.
std::string end_of_course(const WorldParts& parts, double t, double h);

}  // namespace nilas::sim
