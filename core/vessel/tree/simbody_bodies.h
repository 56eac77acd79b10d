#pragma once
/// Conversion of vectors, poses and bodies to those of Simbody. Include it in sources only, in place of <Simbody.h>.
#include "core/geometry/mass_properties.h"
#include "core/vessel/model/vessel_parts.h"
#include "core/vessel/tree/simbody.h"
#include "core/vessel/tree/vessel_tree.h"

namespace nilas::vessel {

inline SimTK::Vec3 to_simbody(const Vec3& a) { return {a.x(), a.y(), a.z()}; }
inline Vec3 from_simbody(const SimTK::Vec3& a) { return {a[0], a[1], a[2]}; }

SimTK::Transform to_simbody(const Pose& pose);
Pose from_simbody(const SimTK::Transform& X);

/// A rigid body with its origin at the centre of mass; `inertia` is about it [kg m^2].
SimTK::Body::Rigid rigid_body(double mass, const Mat3& inertia);

/// Adds a massless carriage. Its speeds (yaw rate, v_x, v_y) come first among all.
SimTK::MobilizedBody::Planar add_carriage(SimTK::SimbodyMatterSubsystem& matter, const TreeJoint& joint);
/// Adds the vessel on its carriage.
SimTK::MobilizedBody add_carried(SimTK::MobilizedBody& carriage, const SimTK::Body::Rigid& body,
                                 const TreeJoint& joint);

/// Adds a part to its parent. At zero joint coordinates both have their places in V.
SimTK::MobilizedBody add_part(SimTK::MobilizedBody& parent, const Pose& parent_in_V, const PartModel& part);

}  // namespace nilas::vessel
