#pragma once
/// Bodies that hang on a vessel's hull by joints: azimuth pods, rudders, hinged barges, turrets; and rods that hold
/// hull and parts to fixed points.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/choices/vessel_choices.h"

namespace nilas {

/// A body and the joint that holds it to the hull or to a part before it. V: the frame of the vessel.
struct PartModel {
  double mass = 0;                    ///< [kg]
  Mat3 inertia_B = Mat3::Identity();  ///< about the centre of mass, along the part's own axes [kg m^2]
  Pose in_V;                          ///< of its axes and centre of mass while all joint coordinates are zero
  int to = -1;                        ///< the part that it hangs on, lower than its own index; -1: the hull
  JointKind joint = JointKind::hinge;
  Vec3 point_V = Vec3::Zero();  ///< of the joint while all joint coordinates are zero [m]
  Vec3 axis_V = Vec3::UnitZ();  ///< unit, of a hinge or slider, then too
  double stiffness = 0;         ///< hinge, ball [N m/rad], slider [N/m]
  double damping = 0;           ///< hinge, ball [N m s/rad], slider [N s/m]
  double rest = 0;              ///< coordinate of a hinge [rad] or slider [m] at which its spring is slack
  double coordinate = 0;        ///< of a hinge or slider at the start [rad, m]
  double rate = 0;              ///< its rate then [rad/s, m/s]
};

/// A rigid link without mass, with ball ends, between the vessel and a fixed point.
struct RodModel {
  std::string name;
  int on = -1;                   ///< the part that it holds; -1: the hull
  Vec3 at_V = Vec3::Zero();      ///< its end on the vessel, of a part while all joint coordinates are zero [m]
  Vec3 to_G = Vec3::Zero();      ///< its fixed end in G [m]
  std::optional<double> length;  ///< [m]; none: the distance of its ends at the start
};

}  // namespace nilas
