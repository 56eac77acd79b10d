#include "core/vessel/tree/simbody_bodies.h"

#include <algorithm>

namespace nilas::vessel {

SimTK::Transform to_simbody(const Pose& pose) {
  return {SimTK::Rotation(SimTK::Quaternion(pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z())), to_simbody(pose.p)};
}

Pose from_simbody(const SimTK::Transform& X) {
  const SimTK::Quaternion q = X.R().convertRotationToQuaternion();
  return {Quat(q[0], q[1], q[2], q[3]).normalized(), from_simbody(X.p())};
}

SimTK::Body::Rigid rigid_body(double mass, const Mat3& I) {
  const SimTK::Inertia inertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
  return SimTK::Body::Rigid(SimTK::MassProperties(mass, SimTK::Vec3(0), inertia));
}

SimTK::MobilizedBody::Planar add_carriage(SimTK::SimbodyMatterSubsystem& matter, const TreeJoint& joint) {
  return {matter.updGround(), SimTK::Transform(SimTK::Vec3(0, 0, joint.height)), SimTK::Body::Massless(),
          SimTK::Transform()};
}

SimTK::MobilizedBody add_carried(SimTK::MobilizedBody& carriage, const SimTK::Body::Rigid& body,
                                 const TreeJoint& joint) {
  if (joint.axes.empty()) return SimTK::MobilizedBody::Weld(carriage, SimTK::Transform(), body, to_simbody(joint.in_B));
  SimTK::Array_<const SimTK::Function*> along;  // the mobilizer takes ownership
  SimTK::Array_<SimTK::Array_<int>> coordinates(6);
  for (int axis = 0; axis < 6; ++axis) {
    const auto found = std::find(joint.axes.begin(), joint.axes.end(), axis);
    if (found == joint.axes.end()) {
      along.push_back(new SimTK::Function::Constant(0, 0));
    } else {
      along.push_back(new SimTK::Function::Linear(SimTK::Vector(SimTK::Vec2(1, 0))));
      coordinates[axis].push_back(static_cast<int>(found - joint.axes.begin()));
    }
  }
  return SimTK::MobilizedBody::FunctionBased(carriage, SimTK::Transform(), body, to_simbody(joint.in_B),
                                             static_cast<int>(joint.axes.size()), along, coordinates);
}

/// Rotation from Simbody's joint axes to those of the part: its hinges turn about z, its sliders move along x.
static Quat joint_axes(const PartModel& part) {
  const Vec3 along = part.joint == JointKind::slider ? Vec3::UnitX() : Vec3::UnitZ();
  return Quat::FromTwoVectors(along, part.axis_V);
}

SimTK::MobilizedBody add_part(SimTK::MobilizedBody& parent, const Pose& parent_in_V, const PartModel& part) {
  Pose joint_V;
  if (part.joint == JointKind::hinge || part.joint == JointKind::slider) joint_V.q = joint_axes(part);
  joint_V.p = part.point_V;
  const auto seen_from = [&](const Pose& body) -> SimTK::Transform {
    const Quat back = body.q.conjugate();
    return to_simbody(Pose{back * joint_V.q, back * (joint_V.p - body.p)});
  };
  const SimTK::Transform on_parent = seen_from(parent_in_V), on_part = seen_from(part.in_V);
  const SimTK::Body::Rigid body = rigid_body(part.mass, part.inertia_B);
  switch (part.joint) {
    case JointKind::hinge:
      return SimTK::MobilizedBody::Pin(parent, on_parent, body, on_part);
    case JointKind::slider:
      return SimTK::MobilizedBody::Slider(parent, on_parent, body, on_part);
    case JointKind::ball:
      return SimTK::MobilizedBody::Ball(parent, on_parent, body, on_part);
    case JointKind::free:
      return SimTK::MobilizedBody::Free(parent, on_parent, body, on_part);
    case JointKind::weld:
      break;
  }
  return SimTK::MobilizedBody::Weld(parent, on_parent, body, on_part);
}

}  // namespace nilas::vessel
