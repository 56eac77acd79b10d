#pragma once
/// Checks of relations between the values of a scene, which the table cannot express. Each reports all faults that it
/// finds and skips values that are already known to be faulty.
#include <vector>

#include "core/scene/document/document.h"

namespace nilas::scene {

/// Runs all checks below on a resolved tree.
void cross_check(const SceneElement& root, std::vector<Fault>& faults);

void check_vessel(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults);
/// Each part must be connected to the hull or an earlier part, and the rest of the scene must allow parts.
void check_parts(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults);
/// Each rod must hold the hull or a part, of which some can move, and the rest of the scene must allow rods.
void check_rods(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults);
void check_ice(const SceneElement& ice, std::vector<Fault>& faults);
/// Ice that moves must lie between the tank's walls.
void check_tank(const SceneElement& root, const SceneElement& tank, std::vector<Fault>& faults);
/// Each property may vary once, by a distribution that it can have, and correlated with others that vary. The
/// correlations must form a positive definite matrix.
void check_vary(const SceneElement& ice, std::vector<Fault>& faults);
void check_body(const SceneElement& body, std::vector<Fault>& faults);
/// The solver must support the law, and the integrator everything in the scene.
void check_contact(const SceneElement& root, const SceneElement& contact, std::vector<Fault>& faults);
/// Each pair may be named once, of materials that exist, with static friction not below kinetic.
void check_friction(const SceneElement& root, const SceneElement& contact, std::vector<Fault>& faults);
/// An inertia tensor (xx yy zz xy xz yz) must be one that a mass distribution can have.
void check_inertia(const SceneElement& element, std::vector<Fault>& faults);

}  // namespace nilas::scene
