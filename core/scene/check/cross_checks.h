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
/// Thrusters need a free vessel, and dynamic positioning needs thrusters that give surge, sway and yaw.
void check_thrusters(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults);
/// The vessel's <wind_area> must name what its model needs.
void check_wind_area(const SceneElement& vessel, std::vector<Fault>& faults);
/// Jets need a vessel, one thrust and a direction each, and an integrator with substeps.
void check_propeller_wash(const SceneElement& root, const SceneElement& hydro, std::vector<Fault>& faults);
/// <manoeuvring> needs coefficients and a free vessel in water, and <manoeuvre> needs <manoeuvring>.
void check_manoeuvring(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults);
/// Mooring lines must hold a free vessel, from anchors that the bed allows.
void check_mooring(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults);
/// Control from outside needs a free vessel, a path that the system takes and an integrator that keeps its state.
void check_remote_control(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults);
void check_ice(const SceneElement& ice, std::vector<Fault>& faults);
/// Ice that moves must lie between the tank's walls.
void check_tank(const SceneElement& root, const SceneElement& tank, std::vector<Fault>& faults);
/// Each property may vary once, by a distribution that it can have, and correlated with others that vary. The
/// correlations must form a positive definite matrix.
void check_vary(const SceneElement& ice, std::vector<Fault>& faults);
/// The added mass of a vessel needs a vessel, and a matrix or a database that can be one.
void check_added_mass(const SceneElement& root, std::vector<Fault>& faults);
/// Waves must have what their spectrum and attenuation need, and their loads waves, buoyancy and a database.
void check_waves(const SceneElement& root, std::vector<Fault>& faults);
/// A database needs a vessel; files of WAMIT need the length, density and gravity by which they were divided.
void check_database(const SceneElement& root, std::vector<Fault>& faults);
void check_body(const SceneElement& body, std::vector<Fault>& faults);
/// The solver must support the law, and the integrator everything in the scene.
void check_contact(const SceneElement& root, const SceneElement& contact, std::vector<Fault>& faults);
/// Each pair may be named once, of materials that exist, with static friction not below kinetic.
void check_friction(const SceneElement& root, const SceneElement& contact, std::vector<Fault>& faults);
/// An inertia tensor (xx yy zz xy xz yz) must be one that a mass distribution can have.
void check_inertia(const SceneElement& element, std::vector<Fault>& faults);

}  // namespace nilas::scene
