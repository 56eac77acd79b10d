#pragma once
/// The surface a part shows along a contact normal, as flat pieces projected on the contact plane.
#include <vector>

#include "contact/detect/broad/pair_view.h"
#include "contact/detect/surface/overlay.h"

namespace nilas::detect {

/// Right-handed axes of a contact in A's frame: normal from A to B and two tangents.
struct ContactPlane {
  Vec3 n = Vec3::UnitX(), t1 = Vec3::UnitY(), t2 = Vec3::UnitZ();
};

/// t1 is A's z axis, or its x axis for normals near z, as far as it lies in the plane: what is its own image in A's xz
/// plane, as ships are, shows a surface symmetric about t1. A pair mirrored in y = 0 has the mirrored t1 and the
/// opposite t2.
ContactPlane contact_plane(const Vec3& n);

/// Flat pieces of one part's surface; storage is kept between uses.
class SurfacePatch {
 public:
  void clear() { count_ = 0; }
  SurfaceLoop& add();
  int size() const { return count_; }
  const SurfaceLoop& operator[](int i) const { return loops_[i]; }

  std::vector<int> faces, vertices;  ///< work space

 private:
  std::vector<SurfaceLoop> loops_;
  int count_ = 0;
};

/// A part, its pose, and the side it shows.
struct PatchView {
  const Part& part;
  const RelativePose& in_a;  ///< the part's frame in A's
  double sign = 1;           ///< the part's contact direction is sign * n
  int face = -1;             ///< the polytope's face whose normal is that direction, or -1: unknown
  double slack = 0;          ///< surface that lies behind the support by more than this is beyond the margin [m]
  Vec3 other_centre = Vec3::Zero();  ///< centre of a ball around the other part, in this part's frame [m]
  double other_radius = 0;           ///< [m]
};

/// Polytope: the face at the support that looks most along the contact direction (all of them when several tie), and
/// all faces joined to it by gentle edges within k_grown_angle of the direction, within the slack and within reach of
/// the other part: a curved hull's small facets act as one surface, so a floe that slides over a seam keeps its points.
/// Cylinder: its cap, its line of contact, or its rim point. Faces seen from the side (beyond 85 degrees) are left out.
void show_surface(const PatchView& view, const ContactPlane& plane, double tolerance, SurfacePatch& patch);

}  // namespace nilas::detect
