#pragma once
/// Axes along which loads are told, and the structures that they are told of.
#include "core/sim/world/world.h"

namespace nilas {

/// Fills course, drift_course, ramp_end, rigid_contacts and structures of RunInfo from the scene and the built
/// bodies.
void describe_loads(const Scene& scene, WorldParts& parts);

/// A body that the scene holds fixed and tells loads of; a plane is the ground and no structure.
bool is_structure(const Bodies& bodies, std::size_t b);

/// Unit vector along the course of the vessel at time t [s]: of a towed vessel the direction in which its carriage
/// moves; of a fixed one in a drift the direction against it; else the vessel's heading.
Vec2 course_at(const WorldParts& parts, double t);

}  // namespace nilas
