#pragma once
/// The pressure of waves on the surface of a body: Froude-Krylov loads.
#include <array>
#include <utility>
#include <vector>

#include "core/geometry/mesh.h"
#include "hydro/database/database.h"
#include "hydro/water.h"
#include "hydro/waves/wave_field.h"

namespace nilas::hydro {

/// The longest edge of a face that is at least partly below the plane z = level, at the pose (R, p) [m]; 0 when dry.
double longest_wet_edge(const geometry::TriangleMesh& mesh, const Mat3& R, const Vec3& p, double level);

/// A closed surface with outward faces in the body frame, cut fine enough for waves of a given length. The cuts lie in
/// the faces and halve whole edges, so that the surface stays closed and keeps its form.
///
/// Integrals over a wet polygon take the mean of the values at the middles of the edges of its triangles, which is
/// exact for pressures that vary linearly, torque included.
class WaveSurface {
 public:
  /// `longest_edge`: edges are halved until none is longer [m]. Throws InputError without triangles.
  WaveSurface(const geometry::TriangleMesh& surface, double longest_edge);
  std::size_t size() const { return faces_.size(); }

  /// The load of the waves beyond that of still water, about p, at the pose (R, p) and time t:
  ///   the integral of -(rho g (level - z) + p_wave) n over the surface below the waves,
  ///   less that of -rho g (level - z) n over the surface below still water.
  /// With hydrostatic buoyancy below still water this gives the pressure of the undisturbed waves on the actual wetted
  /// surface. Heights above the waves vary linearly along an edge. The sums do not depend on the order of faces.
  Wrench load(const Mat3& R, const Vec3& p, const Water& water, const WaveField& field, double t) const;

  /// The linear Froude-Krylov load of a wave of unit amplitude on the surface below the plane of still water, about the
  /// origin of a frame whose z = 0 is still water, at the pose (R, p) in that frame [N/m, N m/m]: the integral of
  /// -rho g exp(-i k x . direction) cosh k(z + h) / cosh kh n dA [Newman 1977, 6.16].
  ComplexVec6 linear_load(const Mat3& R, const Vec3& p, const Water& water, const Vec2& direction, double number,
                          double depth) const;

 private:
  struct Face {
    std::array<int, 3> corners{};
    std::array<int, 3> edges{};  ///< edge k begins at corner k
    Vec3 normal = Vec3::Zero();
    double area = 0;  ///< [m^2]
  };
  std::vector<Vec3> vertices_;
  std::vector<std::pair<int, int>> edges_;  ///< vertices at the ends
  std::vector<Face> faces_;
};

}  // namespace nilas::hydro
