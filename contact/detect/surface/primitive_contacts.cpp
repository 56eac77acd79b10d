#include "contact/detect/surface/primitive_contacts.h"

#include <array>
#include <cmath>

#include "contact/detect/surface/nearest_point.h"
#include "contact/detect/surface/point_reduction.h"

namespace nilas::detect {

namespace {

/// A cylinder that leans by less than this stands on fixed points of its rim, because rounding would choose the rim's
/// lowest point [rad].
constexpr double k_upright = 1e-9;

void keep_on_plane(const HostView& view, std::vector<OverlayPoint>& points, std::vector<LocalContact>& out) {
  keep_spread_points(k_length_resolution * view.guest.bounding_radius, view.margin, k_four_points_do, points,
                     view.last);
  for (const OverlayPoint& p : points) out.push_back({Vec3(p.u, p.v, 0.5 * p.gap), Vec3::UnitZ(), p.gap, p.feature});
}

void polytope_on_plane(const HostView& view, std::vector<LocalContact>& out) {
  std::vector<OverlayPoint> points;
  const auto& vertices = view.guest.facets->polytope->vertices;
  for (int v = 0; v < static_cast<int>(vertices.size()); ++v) {
    const Vec3 x = view.guest_in_host.point(vertices[v]);
    if (x.z() < view.margin) points.push_back({x.x(), x.y(), {FeatureKind::vertex_b, v, -1}, 0, x.z()});
  }
  keep_on_plane(view, points, out);
}

/// Adds four points of the lower rim a quarter turn apart, beginning with its lowest, and the upper rim's lowest point.
void cylinder_on_plane(const HostView& view, std::vector<LocalContact>& out) {
  const Part& guest = view.guest;
  const Vec3 down = -view.guest_in_host.R.row(2).transpose();
  const double lean = std::sqrt(down.x() * down.x() + down.y() * down.y());
  const Vec3 lowest = lean > k_upright ? Vec3(down.x() / lean, down.y() / lean, 0) : Vec3::UnitX();
  const Vec3 aside(-lowest.y(), lowest.x(), 0);
  const double cap = down.z() < 0 ? -guest.half_height : guest.half_height;
  const std::array<Vec3, 5> rim{lowest, aside, -lowest, -aside, lowest};
  std::vector<OverlayPoint> points;
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const double z = k + 1 < rim.size() ? cap : -cap;
    const Vec3 x = view.guest_in_host.point(guest.radius * rim[k] + z * Vec3::UnitZ());
    const int name = 2 * static_cast<int>(k) + (z > 0 ? 1 : 0);
    if (x.z() < view.margin) points.push_back({x.x(), x.y(), {FeatureKind::rim, name, -1}, 0, x.z()});
  }
  keep_on_plane(view, points, out);
}

}  // namespace

void plane_contacts(const HostView& view, std::vector<LocalContact>& out) {
  switch (view.guest.kind) {
    case PartKind::polytope:
      polytope_on_plane(view, out);
      return;
    case PartKind::cylinder:
      cylinder_on_plane(view, out);
      return;
    case PartKind::sphere: {
      const Vec3 centre = view.guest_in_host.point(view.guest.centre);
      const double gap = centre.z() - view.guest.radius;
      if (gap < view.margin) out.push_back({Vec3(centre.x(), centre.y(), 0.5 * gap), Vec3::UnitZ(), gap, {}});
      return;
    }
    case PartKind::plane:
      return;
  }
}

void sphere_contacts(const HostView& view, std::vector<LocalContact>& out) {
  const Vec3 centre = view.guest_in_host.point(view.guest.centre);
  const NearestPoint nearest = nearest_point(view.host, centre);
  const double gap = nearest.distance - view.guest.radius;
  if (!(gap < view.margin)) return;
  out.push_back({nearest.point + 0.5 * gap * nearest.normal, nearest.normal, gap, nearest.feature});
}

}  // namespace nilas::detect
