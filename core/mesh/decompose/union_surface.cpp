#include "core/mesh/decompose/union_surface.h"

#include "core/geometry/mesh_box.h"

namespace nilas::mesh {

namespace {

/// A convex piece as planes and box.
struct Region {
  Region(const geometry::TriangleMesh& part, double grown) : box(geometry::box_of(part)) {
    constexpr double k_same = 1e-9;  // share of the normal: triangles of one plane
    for (const auto& c : corners_of(part)) {
      const Vec3 n = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
      const HalfSpace plane{n, n.dot(c[0]) + grown};
      const auto same = [&](const HalfSpace& q) {
        return (q.normal - n).norm() < k_same && std::abs(q.height(c[0]) + grown) < k_same * box.diagonal().norm();
      };
      if (n.allFinite() && std::none_of(planes.begin(), planes.end(), same)) planes.push_back(plane);
    }
  }
  std::vector<HalfSpace> planes;
  Eigen::AlignedBox3d box;
};

/// The part of the loop on the side of the plane that `sign` names.
Loop clipped(const Loop& loop, const std::vector<double>& heights, double sign) {
  Loop out;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::size_t j = (i + 1) % loop.size();
    const double a = sign * heights[i], b = sign * heights[j];
    if (a >= 0) out.push_back(loop[i]);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) out.push_back(loop[i] + (loop[j] - loop[i]) * (a / (a - b)));
  }
  return out;
}

bool apart(const Loop& polygon, const Region& region, double skin) {
  Eigen::AlignedBox3d box;
  for (const auto& p : polygon) box.extend(p);
  return ((box.min().array() > region.box.max().array() + skin) ||
          (box.max().array() < region.box.min().array() - skin))
      .any();
}

}  // namespace

void subtract(const Loop& polygon, const Vec3& shift, const std::vector<HalfSpace>& region,
              std::vector<Loop>& outside) {
  Loop rest = polygon;
  std::vector<Loop> pieces;
  for (const auto& plane : region) {
    std::vector<double> heights;
    bool some_out = false, some_in = false;
    for (const auto& p : rest) {
      heights.push_back(plane.height(p + shift));
      some_out = some_out || heights.back() > 0;
      some_in = some_in || heights.back() < 0;
    }
    if (!some_out) continue;
    if (!some_in) {
      outside.push_back(polygon);
      return;
    }
    pieces.push_back(clipped(rest, heights, 1));
    rest = clipped(rest, heights, -1);
    if (rest.size() < 3) break;
  }
  for (auto& piece : pieces)
    if (piece.size() >= 3) outside.push_back(std::move(piece));
}

std::vector<Corners> union_surface(const std::vector<geometry::TriangleMesh>& parts, double skin) {
  constexpr double k_out = 3;
  std::vector<Region> regions;
  for (const auto& part : parts) regions.emplace_back(part, skin);
  std::vector<Corners> surface;
  for (std::size_t k = 0; k < parts.size(); ++k)
    for (const auto& c : corners_of(parts[k])) {
      // just outside its own face a point is inside the other part where the two touch, but not where both end there;
      // the other one is grown by less, so that cracks between several are no surface
      const Vec3 normal = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
      if (!normal.allFinite()) continue;
      std::vector<Loop> left{{c[0], c[1], c[2]}};
      for (std::size_t other = 0; other < regions.size() && !left.empty(); ++other) {
        if (other == k) continue;
        std::vector<Loop> next;
        for (const auto& loop : left)
          if (apart(loop, regions[other], k_out * skin))
            next.push_back(loop);
          else
            subtract(loop, k_out * skin * normal, regions[other].planes, next);
        left = std::move(next);
      }
      for (const auto& loop : left)
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) surface.push_back({loop[0], loop[i], loop[i + 1]});
    }
  return surface;
}

Deviation deviation_of(const std::vector<geometry::TriangleMesh>& parts, const geometry::TriangleMesh& mesh,
                       double precision) {
  constexpr double k_skin = 1e-6;  // of the size: some times the rounding of coordinates in STL files
  const double skin = k_skin * geometry::box_of(mesh).sizes().maxCoeff();
  const auto whole = corners_of(mesh), united = union_surface(parts, skin);
  const SurfaceDistance from_mesh(whole), from_union(united);
  const Deviation outwards = from_mesh.largest(from_mesh.without_shared_faces(united, skin), {.precision = precision});
  Deviation back = from_union.largest(from_union.without_shared_faces(whole, skin),
                                      {.precision = precision, .floor = outwards.largest});
  const double unmeasured = std::max(outwards.unmeasured, back.unmeasured);
  if (outwards.largest >= back.largest) back = outwards;
  back.unmeasured = unmeasured + 4 * skin;
  return back;
}

}  // namespace nilas::mesh
