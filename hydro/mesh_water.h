#pragma once
/// A closed mesh prepared for water forces at many poses. It keeps area, centroid and normal of each face, and storage
/// for the heights of the vertices.
#include <array>
#include <vector>

#include "core/geometry/mesh.h"
#include "hydro/cut_triangle.h"
#include "hydro/water_plane.h"
#include "hydro/wetted.h"

namespace nilas::hydro {

class MeshWater {
 public:
  /// Takes a closed mesh with outward faces, in the body frame. Throws InputError when it has no triangles.
  explicit MeshWater(geometry::TriangleMesh mesh);
  /// The volume below the water `level` [m] and its centre in G, at the pose (R, p).
  Submerged submerged(const Mat3& R, const Vec3& p, double level);
  /// Calls visit(area, centroid_B, normal_B) for the wet part of every face.
  template <class Visit>
  void for_each_wet_face(const WaterPlane& plane, const Visit& visit) {
    visit_wet(read_heights(plane), visit);
  }
  /// Calls visit(cut) with the CutTriangle of every face that the plane cuts.
  template <class Visit>
  void for_each_cut(const WaterPlane& plane, const Visit& visit);
  /// The least and the greatest height of the vertices above the plane [m].
  std::array<double, 2> height_range(const WaterPlane& plane);

 private:
  struct Face {
    Vec3 centroid, normal;  ///< Centroid [m] and outward unit normal, in B.
    double area = 0;        ///< [m^2]
  };
  /// The range of the vertices' heights above the water plane.
  struct Heights {
    double lowest = 0, highest = 0;  ///< [m]
    Vec3 deepest = Vec3::Zero();     ///< The lowest vertex, or the middle of all equally low ones.
  };

  Heights read_heights(const WaterPlane& plane);
  template <class Visit>
  void visit_wet(const Heights& heights, const Visit& visit) const;
  int wet_corners(std::size_t triangle) const;
  CutTriangle cut_triangle(std::size_t triangle) const;

  geometry::TriangleMesh mesh_;
  std::vector<Face> faces_;     ///< One face per triangle.
  std::vector<double> height_;  ///< The heights of the vertices above the plane read last [m].
};

inline int MeshWater::wet_corners(std::size_t triangle) const {
  const auto& [a, b, c] = mesh_.triangles[triangle];
  const auto wet = [&](int vertex) { return static_cast<int>(height_[vertex] < 0); };
  return wet(a) + wet(b) + wet(c);
}

inline CutTriangle MeshWater::cut_triangle(std::size_t triangle) const {
  std::array<Vec3, 3> corners;
  std::array<double, 3> heights{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto vertex = static_cast<std::size_t>(mesh_.triangles[triangle][k]);
    corners[k] = mesh_.vertices[vertex];
    heights[k] = height_[vertex];
  }
  return {corners, heights};
}

template <class Visit>
void MeshWater::visit_wet(const Heights& heights, const Visit& visit) const {
  if (heights.lowest >= 0) return;
  const bool submerged = heights.highest <= 0;
  for (std::size_t t = 0; t < faces_.size(); ++t) {
    const Face& face = faces_[t];
    const int wet = submerged ? 3 : wet_corners(t);
    if (wet == 3) {
      visit(face.area, face.centroid, face.normal);
    } else if (wet > 0) {
      cut_triangle(t).visit_wet(face.normal, visit);
    }
  }
}

template <class Visit>
void MeshWater::for_each_cut(const WaterPlane& plane, const Visit& visit) {
  const Heights heights = read_heights(plane);
  if (heights.lowest >= 0 || heights.highest <= 0) return;
  for (std::size_t t = 0; t < faces_.size(); ++t) {
    const int wet = wet_corners(t);
    if (wet == 1 || wet == 2) visit(cut_triangle(t));
  }
}

}  // namespace nilas::hydro
