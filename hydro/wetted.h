#pragma once
/// Exact submerged volume and wetted surface of a solid at any attitude.
#include <vector>

#include "core/base/math.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/shape.h"
#include "hydro/water_plane.h"

namespace nilas::hydro {

/// Submerged part of a solid below the water plane.
struct Submerged {
  double volume = 0;           ///< [m^3]
  Vec3 centre = Vec3::Zero();  ///< The centre of buoyancy in G [m]; the body's origin when dry.
};
/// The submerged part of a closed mesh with outward faces, given in the body frame, at the pose (R, p). It is exact at
/// any attitude, also with vertices on the water plane. Throws InputError for a mesh without triangles.
Submerged submerged_mesh(const geometry::TriangleMesh& mesh, const Mat3& R, const Vec3& p, double level);
/// The submerged part of a sphere with its centre at p: a spherical cap, or the whole.
Submerged submerged_sphere(double radius, const Vec3& p, double level);

/// One wet plane polygon of the surface.
struct WettedFace {
  double area = 0;               ///< [m^2]
  Vec3 centroid = Vec3::Zero();  ///< Centroid in G [m].
  Vec3 normal = Vec3::UnitZ();   ///< Outward unit normal in G.
};
/// Appends to `out` the parts of all faces below the water plane. A face that lies in the water plane counts as wet
/// only where the whole solid is below the plane. Throws InputError for a mesh without triangles.
void wetted_faces(const geometry::TriangleMesh& mesh, const Mat3& R, const Vec3& p, double level,
                  std::vector<WettedFace>& out);

/// The geometry of a floe, prepared once. It has the outline's moments for the closed form that holds when the water
/// plane cuts only the sides.
class PrismWater {
 public:
  /// Takes a prism; throws ContractError for another shape.
  explicit PrismWater(const geometry::Shape& prism);
  /// The submerged part, exact at any attitude. It needs no clipping when both caps are uncut.
  Submerged submerged(const Mat3& R, const Vec3& p, double level) const;
  /// Appends to `out` one face per wet cap and one per wet side. Separate wet parts of a concave cap count as one face.
  void wetted_faces(const Mat3& R, const Vec3& p, double level, std::vector<WettedFace>& out) const;
  /// Calls visit(area, centroid_B, normal_B) for every wet face; defined in hydro/prism_faces.h.
  template <class Visit>
  void for_each_wet_face(const WaterPlane& plane, const Visit& visit) const;

 private:
  /// A side of the floe, over one edge of the outline.
  struct Side {
    Vec2 start, end;    ///< [m]
    Vec2 normal;        ///< Outward unit normal.
    double length = 0;  ///< [m]
  };
  enum class Cut { dry, submerged, sides_only, caps };

  Cut cut(const WaterPlane& plane) const;
  /// The deepest vertex, or the middle of all that are equally deep.
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
  geometry::PolygonMoments moments_;
  double half_ = 0;   ///< half the thickness [m]
  double reach_ = 0;  ///< largest distance of an outline vertex from the axis [m]
};

/// The waterplane of a solid, for GM: area, centroid, and second moments about the centroid. All are zero unless the
/// plane cuts the solid.
struct Waterplane {
  double area = 0;                ///< [m^2]
  Vec2 centroid = Vec2::Zero();   ///< Centroid in G [m].
  double xx = 0, yy = 0, xy = 0;  ///< Integrals of x^2, y^2 and x y about the centroid, axes of G [m^4].
};
Waterplane waterplane(const geometry::TriangleMesh& mesh, const Mat3& R, const Vec3& p, double level);

}  // namespace nilas::hydro
