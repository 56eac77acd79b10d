#pragma once
/// Detection in time: when two parts first touch on their way through a step.
#include "contact/detect/broad/part.h"
#include "contact/detect/search/axis_search.h"

namespace nilas {

/// A body's way through a step: its origin goes straight, its attitude turns evenly about one axis.
struct BodyMotion {
  Vec3 p = Vec3::Zero();  ///< of the body's frame in G at the start [m]
  Mat3 R = Mat3::Identity();
  Vec3 way = Vec3::Zero();   ///< of p over the step, in G [m]
  Vec3 turn = Vec3::Zero();  ///< rotation vector over the step, in G [rad]

  Vec3 position(double t) const { return p + t * way; }
  Mat3 attitude(double t) const;  ///< t: share of the step
};

struct TimeOfImpact {
  bool hit = false;
  double t = 1;              ///< share of the step; 0: they touch (or overlap that deep) at the start. No hit: 1
  Vec3 n = Vec3::UnitX();    ///< unit normal from A to B there, in G
  Vec3 on_a = Vec3::Zero();  ///< the points that meet, in G
  Vec3 on_b = Vec3::Zero();  ///< [m]
  double distance = 0;       ///< of the parts there, at most the resolution of lengths unless they overlap at t = 0 [m]
  int advances = 0;          ///< that it took
  AxisSearchCounts search;
};

/// Depth to which parts overlap.
struct SoughtOverlap {
  double deeper = 0;  ///< than at the start, where they may overlap already; 0: the first contact is sought [m]
  double most = 0;    ///< parts that overlap as deep at the start are a hit at t = 0 [m]
};

/// Conservative advancement: along an axis that separates the parts, the time before which they cannot touch follows
/// from the places, velocities and accelerations of their vertices; there the next axis is sought. FCL gives the axis
/// while the parts are well apart, judged by the separation along it alone, the pair's own axis search when they are
/// near or FCL fails: no answer of the library can lose a contact. A contact is a distance below four times the pair's
/// tolerance. A plane must not turn, or it is never hit.
/// `overlap`: in place of a contact, an overlap is sought.
TimeOfImpact time_of_impact(const Part& a, const BodyMotion& motion_a, const Part& b, const BodyMotion& motion_b,
                            FclShapes& fcl, AxisSearchRoom& room, const SoughtOverlap& overlap = {});

}  // namespace nilas
