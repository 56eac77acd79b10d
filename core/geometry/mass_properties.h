#pragma once
/// Exact mass properties of the solids Nilas knows.
#include <vector>

#include "core/base/math.h"
#include "core/geometry/mesh.h"

namespace nilas::geometry {

/// Mass, centre and inertia of a rigid body, all in one body frame.
struct MassProperties {
  double mass = 0;              ///< [kg]
  Vec3 com = Vec3::Zero();      ///< centre of mass [m]
  Mat3 inertia = Mat3::Zero();  ///< inertia about the centre of mass, axes of the body frame [kg m^2]
};

/// Area moments of a simple polygon (shoelace formulas); all integrals carry the sign of the area.
struct PolygonMoments {
  double area = 0;                ///< signed: positive counter-clockwise [m^2]
  Vec2 centroid = Vec2::Zero();   ///< [m]
  double xx = 0, yy = 0, xy = 0;  ///< integrals of x^2, y^2, x y over the polygon about its centroid [m^4]
};
PolygonMoments polygon_moments(const std::vector<Vec2>& outline);

/// The solids below throw ContractError when a size, density or mass is not positive or the volume is not.
/// Prism with mid-plane z = 0: `outline` (counter-clockwise, convex or concave) extruded by +-thickness/2.
MassProperties prism_properties(const std::vector<Vec2>& outline, double thickness, double density);
MassProperties box_properties(const Vec3& size, double mass);
MassProperties sphere_properties(double radius, double mass);
/// Axis along z.
MassProperties cylinder_properties(double radius, double height, double mass);
/// Closed outward mesh of uniform density (signed tetrahedra; Mirtich 1996).
MassProperties mesh_properties(const TriangleMesh& mesh, double density);

/// Symmetric, principal moments positive, and none exceeds the sum of the other two (within rounding).
bool physically_valid_inertia(const Mat3& inertia);

}  // namespace nilas::geometry
