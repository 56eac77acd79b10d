#pragma once
/// The axes along which loads are reported, and the structures with reported loads.
#include "core/base/math.h"
#include "core/sim/world/world.h"

namespace nilas::sim {

/// Fills course, drift_course, ramp_end, rigid_contacts and structures of RunInfo from the scene and the built bodies.
void describe_loads(const scene::Scene& scene, WorldParts& parts);

/// Whether the loads on a body are reported as those of a structure: it is fixed, and no plane, which is the ground.
bool is_structure(const bodies::Bodies& bodies, std::size_t b);

/// Unit vector along the vessel's course at time t [s]: the direction of motion of the carriage for a towed vessel; the
/// direction against the drift for a fixed one; else the vessel's heading.
Vec2 course_at(const WorldParts& parts, double t);

}  // namespace nilas::sim
