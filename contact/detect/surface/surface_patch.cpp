#include "contact/detect/surface/surface_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/detect/surface/axis_choice.h"

namespace nilas::detect {

namespace {

/// Faces more inclined than this have no useful height over the contact plane.
const double k_steep_cosine = std::cos(85.0 * k_deg);
const double k_smooth_cosine = std::cos(k_patch_angle);
const double k_grown_cosine = std::cos(k_grown_angle);
/// A cylinder's cap or side line within this angle of the contact plane touches with all of it; beyond, a second point
/// within the margin would lie less than six margins away from the first.
const double k_flat_sine = std::sin(10.0 * k_deg);
/// A patch of more faces than this is cut off, where a large part lies on a hull of very small facets.
constexpr std::size_t k_most_faces = 1000;
constexpr int k_rim_corners = 8;

/// A part's frame seen through the contact plane: u, v and height of its points are affine in their coordinates.
struct Projection {
  Vec3 u, v, h;  ///< tangents and normal in the part's frame
  double u0, v0, h0;

  Projection(const PatchView& view, const ContactPlane& plane)
      : u(view.in_a.R.transpose() * plane.t1),
        v(view.in_a.R.transpose() * plane.t2),
        h(view.in_a.R.transpose() * plane.n),
        u0(plane.t1.dot(view.in_a.p)),
        v0(plane.t2.dot(view.in_a.p)),
        h0(plane.n.dot(view.in_a.p)) {}

  LoopCorner corner(const Vec3& x, int vertex, int edge) const { return {u0 + u.dot(x), v0 + v.dot(x), vertex, edge}; }
  /// The plane n . x = offset of the part's frame as a height over the contact plane.
  void set_plane(const Vec3& n, double offset, SurfaceLoop& loop) const {
    const double along = n.dot(h);
    loop.hu = -n.dot(u) / along;
    loop.hv = -n.dot(v) / along;
    loop.h0 = offset / along + h0 - loop.hu * u0 - loop.hv * v0;
    loop.alignment = std::abs(along);
  }
};

double highest_corner(const FacetedGeometry& facets, int f, const Vec3& direction) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const FaceCorner& corner : facets.face_corners[f])
    highest = std::max(highest, facets.vertex(corner.vertex).dot(direction));
  return highest;
}

/// Returns false only for faces of which all points lie farther from the other part's centre than its ball reaches.
bool within_reach(const PatchView& view, int f) {
  const FacetedGeometry& facets = *view.part.facets;
  const auto corners = facets.face_corners[f];
  const Vec3 first = facets.vertex(corners.front().vertex);
  double size = 0;
  for (const FaceCorner& corner : corners) size = std::max(size, (facets.vertex(corner.vertex) - first).norm());
  return (first - view.other_centre).norm() <= view.other_radius + size;
}

/// Adds the faces joined to those of the patch by gentle edges.
void grow_patch(const PatchView& view, const Vec3& direction, SurfacePatch& patch) {
  const FacetedGeometry& facets = *view.part.facets;
  if (facets.smooth_neighbours.items().empty() || patch.faces.empty()) return;
  if (facets.smooth_neighbours[patch.faces.front()].empty()) return;
  const double least = highest_corner(facets, patch.faces.front(), direction) - view.slack;
  for (std::size_t i = 0; i < patch.faces.size() && patch.faces.size() < k_most_faces; ++i)
    for (int f : facets.smooth_neighbours[patch.faces[i]]) {
      const bool known = std::find(patch.faces.begin(), patch.faces.end(), f) != patch.faces.end();
      if (known || facets.normal(f).dot(direction) < k_grown_cosine) continue;
      if (highest_corner(facets, f, direction) >= least && within_reach(view, f)) patch.faces.push_back(f);
    }
}

void collect_faces(const PatchView& view, const Vec3& direction, double tolerance, SurfacePatch& patch) {
  const FacetedGeometry& facets = *view.part.facets;
  const auto alignment = [&](int f) { return facets.normal(f).dot(direction); };
  patch.faces.clear();
  if (view.face >= 0) {
    patch.faces.push_back(view.face);
  } else {
    support_vertices(facets, direction, tolerance, patch.vertices);
    // the best face at each support vertex; along a supporting ridge of many facets it is a face next to each edge of
    // the ridge
    for (int v : patch.vertices) {
      double best = k_steep_cosine;
      for (int f : facets.vertex_faces[v]) best = std::max(best, alignment(f));
      const double least = std::min(best - k_alignment_tie, k_smooth_cosine);
      for (int f : facets.vertex_faces[v])
        if (alignment(f) >= least && std::find(patch.faces.begin(), patch.faces.end(), f) == patch.faces.end())
          patch.faces.push_back(f);
    }
  }
  grow_patch(view, direction, patch);
}

void show_polytope(const PatchView& view, const Projection& projection, double tolerance, SurfacePatch& patch) {
  collect_faces(view, view.sign * projection.h, tolerance, patch);
  const FacetedGeometry& facets = *view.part.facets;
  for (int f : patch.faces) {
    SurfaceLoop& loop = patch.add();
    projection.set_plane(facets.normal(f), facets.offsets[f], loop);
    for (const FaceCorner& corner : facets.face_corners[f])
      loop.corners.push_back(projection.corner(facets.vertex(corner.vertex), corner.vertex, corner.edge));
  }
}

/// Horizontal part of a direction as a unit vector; the x axis when there is none.
Vec3 across_axis(const Vec3& direction) {
  const Vec3 across(direction.x(), direction.y(), 0);
  constexpr double k_least_lean = 1e-9;  // below it the lowest point of the rim is rounding
  const double length = across.norm();
  return length > k_least_lean ? Vec3(across / length) : Vec3::UnitX();
}

/// The cosine of k eighths of a turn. Corners that are images of each other have the same numbers to the last bit.
double rim_cosine(int k) {
  constexpr double k_root = std::numbers::sqrt2 / 2;
  constexpr std::array<double, k_rim_corners> k_cosines{1, k_root, 0, -k_root, -1, -k_root, 0, k_root};
  return k_cosines[k % k_rim_corners];
}

void show_cylinder(const PatchView& view, const Projection& projection, SurfacePatch& patch) {
  const Part& part = view.part;
  const Vec3 direction = view.sign * projection.h;
  const Vec3 across = across_axis(direction);
  const double cap = direction.z() < 0 ? -part.half_height : part.half_height;
  SurfaceLoop& loop = patch.add();
  const int first_name = cap < 0 ? k_rim_corners : 0;
  const auto add = [&](const Vec3& x, int k) {
    loop.corners.push_back(projection.corner(x, first_name + k, first_name + k));
  };
  if (std::sqrt(direction.x() * direction.x() + direction.y() * direction.y()) <= k_flat_sine) {
    projection.set_plane(cap < 0 ? Vec3(-Vec3::UnitZ()) : Vec3::UnitZ(), part.half_height, loop);
    const Vec3 beside(-across.y(), across.x(), 0);
    for (int k = 0; k < k_rim_corners; ++k)
      add(part.radius * (rim_cosine(k) * across + rim_cosine(k + 6) * beside) + cap * Vec3::UnitZ(), k);
    return;
  }
  projection.set_plane(across, part.radius, loop);
  add(part.radius * across + cap * Vec3::UnitZ(), 0);
  if (std::abs(direction.z()) <= k_flat_sine) {
    add(part.radius * across - cap * Vec3::UnitZ(), 1);
    loop.corners[1].edge = loop.corners[0].edge;
  }
}

}  // namespace

ContactPlane contact_plane(const Vec3& n) {
  constexpr double k_near_z = 0.9;  // [cosine]
  const Vec3 axis = std::abs(n.z()) < k_near_z ? Vec3::UnitZ() : Vec3::UnitX();
  ContactPlane plane;
  plane.n = n;
  plane.t1 = (axis - axis.dot(n) * n).normalized();
  plane.t2 = n.cross(plane.t1);
  return plane;
}

SurfaceLoop& SurfacePatch::add() {
  if (count_ == static_cast<int>(loops_.size())) loops_.emplace_back();
  SurfaceLoop& loop = loops_[count_++];
  loop.corners.clear();
  return loop;
}

void show_surface(const PatchView& view, const ContactPlane& plane, double tolerance, SurfacePatch& patch) {
  patch.clear();
  const Projection projection(view, plane);
  if (view.part.facets)
    show_polytope(view, projection, tolerance, patch);
  else
    show_cylinder(view, projection, patch);
}

}  // namespace nilas::detect
