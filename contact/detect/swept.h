#pragma once
/// Detection in time: finds when two parts first touch along their paths through a step.
#include "contact/detect/broad/part.h"
#include "contact/detect/search/axis_search.h"

namespace nilas::detect {

/// A body's path through a step: its origin moves straight, and its attitude turns evenly about one axis.
struct BodyMotion {
  Vec3 p = Vec3::Zero();  ///< origin of the body's frame in G at the start [m]
  Mat3 R = Mat3::Identity();
  Vec3 way = Vec3::Zero();   ///< displacement of p over the step, in G [m]
  Vec3 turn = Vec3::Zero();  ///< rotation vector over the step, in G [rad]

  Vec3 position(double t) const { return p + t * way; }
  Mat3 attitude(double t) const;  ///< t: share of the step
};

struct TimeOfImpact {
  bool hit = false;
  double t = 1;  ///< share of the step; 0 where they touch (or overlap that deep) at the start, 1 without a hit
  Vec3 n = Vec3::UnitX();    ///< unit normal from A to B there, in G
  Vec3 on_a = Vec3::Zero();  ///< the points that meet, in G [m]
  Vec3 on_b = Vec3::Zero();  ///< the point on B's surface, in G [m]
  double distance =
      0;  ///< distance of the parts there; at most the resolution of lengths unless they overlap at t = 0 [m]
  int advances = 0;  ///< number of advances
  AxisSearchCounts search;
};

/// The depth of overlap that a search in time seeks.
struct SoughtOverlap {
  double deeper =
      0;  ///< depth beyond that of the start, where they may overlap already; 0: the first contact is sought [m]
  double most = 0;  ///< parts that overlap this deep at the start are a hit at t = 0 [m]
};

/// Finds the first contact by conservative advancement. Along an axis that separates the parts, the positions,
/// velocities and accelerations of their vertices bound the time before which they cannot touch. The axis stays in G,
/// or turns with one of two polytopes; the longest time counts. At that time the next axis is sought. Between polytopes
/// it comes from faces and edges, so that the time of a mirror image is the same to the last bit. For cylinders FCL
/// gives it while the parts are well apart, and else the pair's own search. The separation along it is computed here,
/// so no answer of the library can lose a contact. A contact is a distance below four times the pair's tolerance. A
/// plane must not turn, or it is never hit. `overlap`: an overlap is sought in place of a contact.
TimeOfImpact time_of_impact(const Part& a, const BodyMotion& motion_a, const Part& b, const BodyMotion& motion_b,
                            FclShapes& fcl, AxisSearchRoom& room, const SoughtOverlap& overlap = {});

}  // namespace nilas::detect
