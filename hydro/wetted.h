#pragma once
/// Exact submerged volume and wetted surface of a solid at any attitude.
#include <vector>

#include "core/base/math.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/shape.h"
#include "hydro/water_plane.h"

namespace nilas {

/// Submerged part of a solid below the water plane.
struct Submerged {
  double volume = 0;           ///< [m^3]
  Vec3 centre = Vec3::Zero();  ///< of buoyancy, in G [m]; the body origin when dry
};
/// Closed outward mesh in body frame at pose (R, p). Exact for any attitude, vertices on the plane included.
Submerged submerged_mesh(const TriangleMesh& mesh, const Mat3& R, const Vec3& p, double level);
/// Sphere with its centre at p: the spherical cap or segment.
Submerged submerged_sphere(double radius, const Vec3& p, double level);

/// One wet plane polygon of the surface.
struct WettedFace {
  double area = 0;               ///< [m^2]
  Vec3 centroid = Vec3::Zero();  ///< in G [m]
  Vec3 normal = Vec3::UnitZ();   ///< outward, in G
};
/// The parts of all faces below the water plane; a face that lies in the plane of a solid that is cut counts as dry.
/// Appends to `out`.
void wetted_faces(const TriangleMesh& mesh, const Mat3& R, const Vec3& p, double level, std::vector<WettedFace>& out);

/// Floe geometry prepared once: moments of the outline for the closed form when the water plane cuts only the sides.
class PrismWater {
 public:
  /// Reads outline and thickness of a prism shape.
  explicit PrismWater(const Shape& prism);
  /// Exact; O(1) when both caps are uncut, otherwise by clipping.
  Submerged submerged(const Mat3& R, const Vec3& p, double level) const;
  /// One face per cap (its two or more wet parts together when a concave cap is cut) and one per side.
  void wetted_faces(const Mat3& R, const Vec3& p, double level, std::vector<WettedFace>& out) const;
  /// Calls visit(area, centroid_B, normal_B) for every wet face; defined in hydro/prism_faces.h.
  template <class Visit>
  void for_each_wet_face(const WaterPlane& plane, const Visit& visit) const;

 private:
  /// One vertical side over an edge of the outline.
  struct Side {
    Vec2 start, end;    ///< [m]
    Vec2 normal;        ///< outward
    double length = 0;  ///< [m]
  };
  enum class Cut { dry, submerged, sides_only, caps };

  Cut cut(const WaterPlane& plane) const;
  /// A point as deep as any: the deepest vertex, or the middle of all that are.
  Vec3 deepest_point(const WaterPlane& plane) const;
  Submerged between_caps(const WaterPlane& plane) const;
  template <class Visit>
  void visit_whole(const Visit& visit) const;
  template <class Visit>
  void visit_between_caps(const WaterPlane& plane, const Visit& visit) const;
  template <class Visit>
  void visit_clipped(const WaterPlane& plane, const Visit& visit) const;
  template <class Visit>
  void visit_whole(const Side& s, const Visit& visit) const;
  template <class Visit>
  void visit_clipped(const Side& s, const WaterPlane& plane, const Visit& visit) const;

  std::vector<Side> sides_;
  PolygonMoments moments_;
  double half_ = 0;   ///< half thickness [m]
  double reach_ = 0;  ///< largest distance of an outline vertex from the axis [m]
};

/// Waterplane properties at still attitude, for GM: area, centroid and second moments about the centroid. All zero
/// unless the plane cuts the solid.
struct Waterplane {
  double area = 0;                ///< [m^2]
  Vec2 centroid = Vec2::Zero();   ///< in G [m]
  double xx = 0, yy = 0, xy = 0;  ///< integrals of x^2, y^2, x y about the centroid, axes of G [m^4]
};
Waterplane waterplane(const TriangleMesh& mesh, const Mat3& R, const Vec3& p, double level);

}  // namespace nilas
