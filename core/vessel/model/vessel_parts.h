#pragma once
/// Parts that joints connect to a vessel's hull (azimuth pods, rudders, hinged barges, turrets), and rods that connect
/// hull and parts to fixed points.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/choices/vessel_choices.h"

namespace nilas::vessel {

/// A body and the joint that connects it to the hull or to an earlier part. V: the frame of the vessel.
struct PartModel {
  double mass = 0;                    ///< [kg]
  Mat3 inertia_B = Mat3::Identity();  ///< about the centre of mass, in the part's own axes [kg m^2]
  Pose in_V;                          ///< pose of its axes and centre of mass at zero joint coordinates
  int to = -1;                        ///< index of its parent part, lower than its own; -1: the hull
  JointKind joint = JointKind::hinge;
  Vec3 point_V = Vec3::Zero();  ///< joint point at zero joint coordinates [m]
  Vec3 axis_V = Vec3::UnitZ();  ///< unit axis of a hinge or slider at zero joint coordinates
  double stiffness = 0;         ///< hinge, ball [N m/rad], slider [N/m]
  double damping = 0;           ///< hinge, ball [N m s/rad], slider [N s/m]
  double rest = 0;              ///< coordinate of a hinge [rad] or slider [m] without spring force
  double coordinate = 0;        ///< initial coordinate of a hinge [rad] or slider [m]
  double rate = 0;              ///< initial rate [rad/s, m/s]
};

/// A rigid link without mass, with ball ends, between the vessel and a fixed point.
struct RodModel {
  std::string name;
  int on = -1;                   ///< the part that it connects; -1: the hull
  Vec3 at_V = Vec3::Zero();      ///< its end on the vessel, for a part at zero joint coordinates [m]
  Vec3 to_G = Vec3::Zero();      ///< its fixed end in G [m]
  std::optional<double> length;  ///< [m]; empty: the initial distance of its ends
};

}  // namespace nilas::vessel
