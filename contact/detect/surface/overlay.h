#pragma once
/// Two convex polygons of surface seen along the contact normal, one cut by the other.
#include <vector>

#include "contact/detect/broad/contact_key.h"
#include "core/base/math.h"

namespace nilas::detect {

/// Corner of a polygon in the contact plane.
struct LoopCorner {
  double u = 0, v = 0;  ///< coordinates along the two tangents [m]
  int vertex = -1;      ///< index of the vertex within its part
  int edge = -1;        ///< index of the edge to the next corner
};

/// A flat piece of surface of one part: its outline, and the height of its plane along the normal, h = h0 + hu u + hv
/// v.
struct SurfaceLoop {
  std::vector<LoopCorner> corners;
  double h0 = 0, hu = 0, hv = 0;
  double alignment = 0;  ///< cosine between the plane's outward normal and the part's outward contact direction
  double height(double u, double v) const { return h0 + hu * u + hv * v; }
};

/// Inclination of a tangent plane against the contact plane: height rises by u per metre along t1, v along t2.
struct Slope {
  double u = 0, v = 0;
};

/// A point of the common area of two loops.
struct OverlayPoint {
  double u = 0, v = 0;
  Feature feature;      ///< features that meet there
  double height_a = 0;  ///< height of A's surface there [m]
  double gap = 0;       ///< distance from A's surface to B's along the normal [m]
  Slope slope{};        ///< slope of the tangent plane there: of the other side's face, or of both crossing edges
};

/// Work space of clip(): corners that remember which side of the window made them.
struct ClipBuffers {
  struct Corner {
    double u = 0, v = 0;
    Feature feature;
    Slope slope;
    int edge = -1;   ///< the subject's edge to the next corner
    int place = -1;  ///< index, in its loop, of the subject's corner where that edge begins
    int side = -1;   ///< side of the window on which the edge to the next corner lies; -1: on the subject's own edge
    double distance = 0;  ///< distance to the inside of the side that cuts [m]
  };
  std::vector<Corner> now, next;
};

/// Appends to `points` the corners of the common area. `a_is_window` states which loop cuts the other; it should be the
/// one whose plane faces the normal more. Corners within `tolerance` [m] of a side of the window count as lying on it.
/// Of corners that close to each other one is kept.
void clip(const SurfaceLoop& loop_a, const SurfaceLoop& loop_b, bool a_is_window, double tolerance,
          ClipBuffers& buffers, std::vector<OverlayPoint>& points);

}  // namespace nilas::detect
