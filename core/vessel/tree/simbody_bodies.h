#pragma once
/// Vectors, poses and bodies in Simbody's terms. Include it in sources only, in place of <Simbody.h>.
#include "core/geometry/mass_properties.h"
#include "core/vessel/model/vessel_parts.h"
#include "core/vessel/tree/simbody.h"
#include "core/vessel/tree/vessel_tree.h"

namespace nilas {

inline SimTK::Vec3 to_simbody(const Vec3& a) { return {a.x(), a.y(), a.z()}; }
inline Vec3 from_simbody(const SimTK::Vec3& a) { return {a[0], a[1], a[2]}; }

SimTK::Transform to_simbody(const Pose& pose);
Pose from_simbody(const SimTK::Transform& X);

/// With its origin at the centre of mass; `inertia` about it [kg m^2].
SimTK::Body::Rigid rigid_body(double mass, const Mat3& inertia);

/// A massless carriage whose speeds (yaw rate, v_x, v_y) come first among all.
SimTK::MobilizedBody::Planar add_carriage(SimTK::SimbodyMatterSubsystem& matter, const TreeJoint& joint);
/// The vessel on it.
SimTK::MobilizedBody add_carried(SimTK::MobilizedBody& carriage, const SimTK::Body::Rigid& body,
                                 const TreeJoint& joint);

/// A part on its parent, where all joint coordinates are zero at the places in V of both.
SimTK::MobilizedBody add_part(SimTK::MobilizedBody& parent, const Pose& parent_in_V, const PartModel& part);

}  // namespace nilas
