#pragma once
/// The mooring of a free vessel: its lines at the start, and the place where the vessel is at rest on them.
#include <string>

#include "core/sim/world/world.h"

namespace nilas::sim {

/// Builds parts.mooring from <mooring> and, unless the vessel starts as placed, moves model.pose_V to its rest under
/// weight, buoyancy and lines, turret included. `fluid`: the hull in V. The search is Newton's method with differences.
/// A motion that nothing restores, such as the heading of a vessel whose lines all end on a free turret, stays as it
/// is. Does nothing without <mooring>. Throws InputError, with the line of the scene file, for a mooring line whose
/// fairlead is below the bed, or that is so short that it would break or be strained beyond reason; and where no rest
/// is found.
void moor_vessel(const scene::Scene& scene, const geometry::TriangleMesh& fluid, vessel::VesselModel& model,
                 WorldParts& parts);

/// The mooring at the start, at rest.
struct MooringAtStart {
  vessel::MooringLoads loads;
  Mat6 stiffness;  ///< for small motions (translation; rotation) of the centre of mass, in G; symmetric part
  Mat6 damping;    ///< likewise for small velocities, with all lines under tension
};
/// `parts` has a mooring.
MooringAtStart mooring_at_start(const WorldParts& parts);

/// Lines, tensions, load and stiffness of the start in one line of text, for the list of what was built.
std::string mooring_reason(const WorldParts& parts);

}  // namespace nilas::sim
