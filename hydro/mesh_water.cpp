#include "hydro/mesh_water.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/mirror_order.h"
#include "hydro/pyramid_sum.h"

namespace nilas::hydro {

MeshWater::MeshWater(geometry::TriangleMesh mesh) : mesh_(std::move(mesh)), height_(mesh_.vertices.size()) {
  if (mesh_.triangles.empty()) throw InputError("a mesh without triangles displaces no water");
  constexpr double k_third = 1.0 / 3.0;  // centroid of a triangle
  faces_.reserve(mesh_.triangles.size());
  for (auto& triangle : mesh_.triangles) {
    triangle = from_first(triangle, mesh_.vertices);
    const auto& [i, j, k] = triangle;
    const Vec3& a = mesh_.vertices[i];
    const Vec3& b = mesh_.vertices[j];
    const Vec3& c = mesh_.vertices[k];
    const Vec3 doubled = (b - a).cross(c - a);
    const double length = doubled.norm();
    // A triangle without area carries no force, so that its normal does not matter.
    const Vec3 normal = length > 0 ? Vec3(doubled / length) : Vec3::Zero();
    faces_.push_back({k_third * (a + (b + c)), normal, 0.5 * length});
  }
}

MeshWater::Heights MeshWater::read_heights(const WaterPlane& plane) {
  Heights heights;
  Vec3 low = Vec3::Zero(), high = low;
  for (std::size_t v = 0; v < height_.size(); ++v) {
    const Vec3& x = mesh_.vertices[v];
    height_[v] = plane.height(x);
    const bool lower = v == 0 || height_[v] < heights.lowest;
    heights.highest = v == 0 ? height_[v] : std::max(heights.highest, height_[v]);
    if (!lower && height_[v] > heights.lowest) continue;
    low = lower ? x : Vec3(low.cwiseMin(x));
    high = lower ? x : Vec3(high.cwiseMax(x));
    heights.lowest = height_[v];
  }
  heights.deepest = 0.5 * (low + high);
  return heights;
}

std::array<double, 2> MeshWater::height_range(const WaterPlane& plane) {
  const Heights heights = read_heights(plane);
  return {heights.lowest, heights.highest};
}

Submerged MeshWater::submerged(const Mat3& R, const Vec3& p, double level) {
  const WaterPlane plane = water_plane(R, p, level);
  const Heights heights = read_heights(plane);
  // The apex is near the wet part, lest its volume be a small difference of large pyramids. Where the plane cuts the
  // mesh, the apex is on the plane.
  PyramidSum sum(heights.highest <= 0 ? heights.deepest : plane.foot(heights.deepest));
  visit_wet(heights, [&](double area, const Vec3& centroid, const Vec3& normal) { sum.add(area, centroid, normal); });
  if (!(sum.volume() > 0)) return {0, p};
  return {sum.volume(), p + R * sum.centre()};
}

}  // namespace nilas::hydro
