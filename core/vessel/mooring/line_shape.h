#pragma once
/// Where a mooring line runs, for pictures.
#include <optional>
#include <vector>

#include "core/vessel/mooring/mooring_model.h"

namespace nilas::vessel {

/// Points along a line at rest from its anchor to a fairlead in G [m]. A spring is straight. A catenary follows its
/// closed form, with the stretch of the bed's friction left out. Throws SimulationError as line_force() does.
std::vector<Vec3> line_shape(const MooringLine& line, std::optional<double> bed, const Vec3& fairlead);

/// The same for all lines at a pose of the hull; empty for a line that is broken.
std::vector<std::vector<Vec3>> mooring_shapes(const MooringModel& model, const MooringState& state, const Pose& pose);

}  // namespace nilas::vessel
