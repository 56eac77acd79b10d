#pragma once
/// The contact points of two parts along a chosen axis.
#include <span>
#include <vector>

#include "contact/detect/broad/pair_view.h"
#include "contact/detect/surface/overlay.h"
#include "contact/detect/surface/surface_patch.h"

namespace nilas {

/// The surfaces two parts show each other along an axis, laid over each other. Kept between pairs for its storage.
struct FacingSurfaces {
  ContactPlane plane;
  SurfacePatch a, b;
  std::vector<OverlayPoint> points;  ///< corners of the common areas, all gaps
  std::vector<int> loop_ends;        ///< each common area's corners end here in `points`, in turn around it
  double smallest_gap = 0;           ///< among points [m]; infinite without any
  bool curved = false;               ///< a patch of several faces: normals differ from point to point
  ClipBuffers buffers;
};

/// Lays the surfaces along `axis` over each other. Each point's gap is the distance along the normal between the two
/// surfaces at that place, so tilted parts get the true local gaps; gap >= axis.s up to rounding. With an axis between
/// crossing edges the crossing is one of the points.
void face_each_other(const PairView& pair, const Axis& axis, FacingSurfaces& facing);

/// True when `axis` is proven to be the best axis of the pair (axis_proof.cpp).
/// Apart: two points on the surfaces are as near as the axis separates, so no other axis separates more.
/// Overlapping along a face: the other part has a point under it that lies deeper under all other faces.
/// Overlapping between crossing edges, by little: the face of the Minkowski difference that belongs to them reaches
/// far.
bool is_proven(const PairView& pair, const Axis& axis, const FacingSurfaces& facing);

/// Leaves in facing.points the contact points: gaps below the margin, at most k_most_points, the deepest gap equal to
/// axis.s. Where the surfaces show no such point (two edges or corners) the nearest points of the supporting features
/// give it. `last`: the features of what was kept of this pair before; returns how many of the first points are to be
/// that at the next call (keep_spread_points).
std::size_t select_points(const PairView& pair, const Axis& axis, std::span<const Feature> last,
                          FacingSurfaces& facing);

}  // namespace nilas
