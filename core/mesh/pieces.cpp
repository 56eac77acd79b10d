#include "core/mesh/pieces.h"

#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/convex_hull_3.h>

namespace nilas {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

bool has_flat_faces(const SurfaceMesh& mesh) {
  const auto faces = mesh.faces();
  return std::any_of(faces.begin(), faces.end(),
                     [&](const auto f) { return PMP::is_degenerate_triangle_face(f, mesh); });
}

/// How far inside a plane a piece is cut: where faces of the piece lie in the plane itself, clip() may close the cut
/// over them as well, and leaves a membrane.
double inset(const SurfaceMesh& piece) {
  constexpr double k_share = 1e-9;
  const auto box = PMP::bbox(piece);
  return k_share * std::max({box.x_span(), box.y_span(), box.z_span()});
}

double height(const Kernel::Point_3& p, const Plane& plane) {
  return plane.a() * p.x() + plane.b() * p.y() + plane.c() * p.z() + plane.d();
}

/// Puts what lies in the plane of the cut back on the one that was meant; both have normals of length 1.
void move_cap(SurfaceMesh& side, const Plane& lower, const Plane& plane, double depth) {
  constexpr double k_same = 1e-2;
  for (const auto v : side.vertices()) {
    Kernel::Point_3& p = side.point(v);
    if (std::abs(height(p, lower)) < k_same * depth) p = p - height(p, plane) * plane.orthogonal_vector();
  }
}

/// Slivers below this share of the whole piece are rounding.
constexpr double k_least_share = 1e-9;

}  // namespace

bool can_be_cut(const SurfaceMesh& piece) { return !crosses_itself(piece) && !has_flat_faces(piece); }

SurfaceMesh convex_hull(const std::vector<Kernel::Point_3>& points) {
  SurfaceMesh hull;
  if (points.size() < 4) return hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  if (!CGAL::is_closed(hull) || hull.num_faces() < 4) hull.clear();
  return hull;
}

std::vector<Kernel::Point_3> points_of(const SurfaceMesh& mesh) {
  std::vector<Kernel::Point_3> points;
  for (const auto v : mesh.vertices()) points.push_back(mesh.point(v));
  return points;
}

std::vector<SurfaceMesh> below(const SurfaceMesh& piece, const Plane& through) {
  const double length = std::sqrt(through.orthogonal_vector().squared_length()), depth = inset(piece);
  const Plane plane(through.a() / length, through.b() / length, through.c() / length, through.d() / length),
      lower(plane.a(), plane.b(), plane.c(), plane.d() + depth);
  SurfaceMesh side = piece;
  std::vector<SurfaceMesh> parts;
  try {
    PMP::clip(side, lower, CGAL::parameters::clip_volume(true).throw_on_self_intersection(true));
    PMP::remove_degenerate_faces(side);
    side.collect_garbage();
    if (side.is_empty() || !CGAL::is_closed(side)) return {};
    move_cap(side, lower, plane, depth);
    PMP::split_connected_components(side, parts);
  } catch (const std::exception&) {
    return {};
  }
  const double least = k_least_share * PMP::volume(piece);
  std::erase_if(parts, [&](const SurfaceMesh& part) { return !(PMP::volume(part) > least); });
  return parts;
}

std::vector<SurfaceMesh> cut(const SurfaceMesh& piece, const Plane& plane) {
  std::vector<SurfaceMesh> pieces = below(piece, plane), above = below(piece, plane.opposite());
  if (pieces.empty() || above.empty()) return {};
  for (auto& part : above) pieces.push_back(std::move(part));
  double volume = 0;
  for (const auto& part : pieces) volume += PMP::volume(part);
  constexpr double k_lost = 1e-6;  // of the volume: a cut that loses more has failed
  if (std::abs(volume - PMP::volume(piece)) > k_lost * PMP::volume(piece)) return {};
  return pieces;
}

}  // namespace nilas
