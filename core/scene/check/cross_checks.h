#pragma once
/// What the table cannot say: relations between the values of a scene. Each reports all it finds and passes over what
/// is already known to be faulty.
#include <vector>

#include "core/scene/document/document.h"

namespace nilas {

/// All checks below, on a resolved tree.
void cross_check(const SceneElement& root, std::vector<Fault>& faults);

void check_vessel(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults);
/// Each part hangs on the hull or a part before it, and the rest of the scene is one that parts can be in.
void check_parts(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults);
/// Each rod holds the hull or a part, of which some can move, and the rest of the scene is one that rods can be in.
void check_rods(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults);
void check_ice(const SceneElement& ice, std::vector<Fault>& faults);
/// Ice that moves is laid out between the tank's walls.
void check_tank(const SceneElement& root, const SceneElement& tank, std::vector<Fault>& faults);
/// Each property varies once, by a distribution it can have, correlated with others that vary; the correlations make a
/// positive definite matrix.
void check_vary(const SceneElement& ice, std::vector<Fault>& faults);
void check_body(const SceneElement& body, std::vector<Fault>& faults);
/// The solver takes the law, and the integrator all that the scene has.
void check_contact(const SceneElement& root, const SceneElement& contact, std::vector<Fault>& faults);
/// Pairs named once, of materials that exist, static friction not below kinetic.
void check_friction(const SceneElement& root, const SceneElement& contact, std::vector<Fault>& faults);
/// An inertia tensor (xx yy zz xy xz yz) must be one that a mass distribution can have.
void check_inertia(const SceneElement& element, std::vector<Fault>& faults);

}  // namespace nilas
