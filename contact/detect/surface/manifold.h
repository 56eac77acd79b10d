#pragma once
/// Finds the contact points of two parts along a chosen axis.
#include <span>
#include <vector>

#include "contact/detect/broad/pair_view.h"
#include "contact/detect/surface/overlay.h"
#include "contact/detect/surface/surface_patch.h"

namespace nilas::detect {

/// The surfaces that two parts show each other along an axis, laid over each other. The object is kept between pairs
/// for its storage.
struct FacingSurfaces {
  ContactPlane plane;
  SurfacePatch a, b;
  std::vector<OverlayPoint> points;  ///< corners of the common areas, all gaps
  std::vector<int> loop_ends;        ///< end of each common area's corners in `points`; they run around the area
  double smallest_gap = 0;           ///< smallest gap of the points [m]; infinite without any
  bool curved = false;               ///< a patch has several faces, so normals differ from point to point
  ClipBuffers buffers;
};

/// Lays the surfaces along `axis` over each other. Each point's gap is the distance of the two surfaces along the
/// normal at that place, so tilted parts get the true local gaps. gap >= axis.s up to rounding. With an axis between
/// crossing edges the crossing is one of the points.
void face_each_other(const PairView& pair, const Axis& axis, FacingSurfaces& facing);

/// Returns whether `axis` is proven to be the best axis of the pair (axis_proof.cpp). Parts that are apart: two points
/// on the surfaces are as near as the axis separates, so no other axis separates more. Overlap along a face: a deepest
/// point of the other part lies at least as deep under all other faces. Small overlap between crossing edges: their
/// face of the Minkowski difference reaches far.
bool is_proven(const PairView& pair, const Axis& axis, const FacingSurfaces& facing);

/// Leaves in facing.points the contact points: gaps below the margin, at most k_most_points, the deepest gap equal to
/// axis.s. Where the surfaces show no such point (two edges or corners), the nearest points of the supporting features
/// give it. `last`: the features of the pair's points kept at the last call. Returns how many of the first points are
/// to be kept for the next call (keep_spread_points).
std::size_t select_points(const PairView& pair, const Axis& axis, std::span<const Feature> last,
                          FacingSurfaces& facing);

}  // namespace nilas::detect
