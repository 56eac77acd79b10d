#pragma once
/// Cuts contact points of parts that are pieces of larger bodies back to the surface of those bodies.
#include "contact/detect/surface/manifold.h"

namespace nilas::detect {

/// One part of a pair, where it touches others of its body.
struct CoveredSide {
  const PairView& pair;
  bool of_a;

  const Part& part() const { return of_a ? pair.a : pair.b; }
  const PartCover& cover() const { return *part().cover; }
  bool owns(AxisKind kind) const { return kind == (of_a ? AxisKind::face_a : AxisKind::face_b); }
  /// The point on the part's surface, and the contact's outward normal, in the part's frame.
  Vec3 place(const ContactPlane& plane, const OverlayPoint& p) const;
  Vec3 outward(const Vec3& n) const;
  /// The point of the other part that meets it, in the same frame.
  Vec3 other_place(const ContactPlane& plane, const OverlayPoint& p) const;
};

/// Cuts the common areas back to where the side's other parts do not hide them: a corner inside another part is
/// replaced by the points where the area's outline comes out of it, with the gaps there. Call after face_each_other.
void cut_covered(const CoveredSide& side, const Axis& axis, FacingSurfaces& facing);

/// Removes points below the side's own face that lie so deep that another part of its body offers a nearer exit there.
/// That part has contacts of its own.
void drop_dominated(const CoveredSide& side, FacingSurfaces& facing);

/// Removes points made by internal edges and vertices of the side. The body's surface continues through them, and its
/// common area with the other body ends at points of other parts.
void drop_internal_features(const CoveredSide& side, FacingSurfaces& facing);

}  // namespace nilas::detect
