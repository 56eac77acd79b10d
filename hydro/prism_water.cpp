#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "hydro/prism_faces.h"
#include "hydro/pyramid_sum.h"

namespace nilas::hydro {

PrismWater::PrismWater(const geometry::Shape& prism)
    : moments_(geometry::polygon_moments(prism.outline)), half_(0.5 * prism.thickness) {
  NILAS_DEMAND(prism.kind == geometry::ShapeKind::prism && prism.outline.size() > 2);
  const std::vector<Vec2>& outline = prism.outline;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& start = outline[i];
    const Vec2& end = outline[(i + 1) % outline.size()];
    const Vec2 edge = end - start;
    const double length = edge.norm();
    sides_.push_back({start, end, Vec2(edge.y(), -edge.x()) / length, length});
    reach_ = std::max(reach_, start.norm());
  }
}

PrismWater::Cut PrismWater::cut(const WaterPlane& plane) const {
  const double rise = std::abs(plane.up.z()) * half_;
  const auto judge = [&](double lowest, double highest) {
    if (lowest - rise >= 0) return Cut::dry;
    if (highest + rise <= 0) return Cut::submerged;
    return highest - rise <= 0 && lowest + rise >= 0 ? Cut::sides_only : Cut::caps;
  };
  const double span = plane.up.head<2>().norm() * reach_;
  const Cut bounded = judge(plane.offset - span, plane.offset + span);
  if (bounded != Cut::caps) return bounded;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Side& s : sides_) {
    const double height = plane.offset + plane.up.head<2>().dot(s.start);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  return judge(lowest, highest);
}

Vec3 PrismWater::deepest_point(const WaterPlane& plane) const {
  double deepest = std::numeric_limits<double>::infinity();
  Vec2 low = Vec2::Zero(), high = low;
  for (const Side& s : sides_) {
    const double height = plane.up.head<2>().dot(s.start);
    if (height > deepest) continue;
    low = height < deepest ? s.start : low.cwiseMin(s.start);
    high = height < deepest ? s.start : high.cwiseMax(s.start);
    deepest = height;
  }
  return {0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()), plane.up.z() > 0 ? -half_ : half_};
}

/// The submerged part when the plane cuts only the sides. The wet length over (x, y) is linear, half - low z_w(x, y),
/// so that volume and first moments follow from the outline's moments.
Submerged PrismWater::between_caps(const WaterPlane& plane) const {
  const double low = plane.up.z() > 0 ? -1 : 1;
  const Vec2 slope = -plane.up.head<2>() / plane.up.z();
  const geometry::PolygonMoments& m = moments_;
  // z of the water plane at the outline's centroid.
  const double z = -plane.offset / plane.up.z() + slope.dot(m.centroid);
  const double length = half_ - low * z;
  const double volume = m.area * length;
  if (!(volume > 0)) return {};
  const Vec2 second(m.xx * slope.x() + m.xy * slope.y(), m.xy * slope.x() + m.yy * slope.y());
  const Vec2 shift = -low / volume * second;
  // The mean of z over the wet columns: (z_w + cap)(z_w - cap) / 2 per unit area.
  const double centre_z = 0.5 * (low * half_ + z) - 0.5 * low * slope.dot(second) / volume;
  return {volume, Vec3(m.centroid.x() + shift.x(), m.centroid.y() + shift.y(), centre_z)};
}

Submerged PrismWater::submerged(const Mat3& R, const Vec3& p, double level) const {
  const WaterPlane plane = water_plane(R, p, level);
  Submerged in_body;
  switch (cut(plane)) {
    case Cut::dry:
      break;
    case Cut::submerged:
      in_body = {2 * half_ * moments_.area, Vec3(moments_.centroid.x(), moments_.centroid.y(), 0)};
      break;
    case Cut::sides_only:
      in_body = between_caps(plane);
      break;
    case Cut::caps: {
      PyramidSum sum(plane.foot(deepest_point(plane)));
      visit_clipped(plane,
                    [&](double area, const Vec3& centroid, const Vec3& normal) { sum.add(area, centroid, normal); });
      if (sum.volume() > 0) in_body = {sum.volume(), sum.centre()};
    }
  }
  return {in_body.volume, p + R * in_body.centre};
}

void PrismWater::wetted_faces(const Mat3& R, const Vec3& p, double level, std::vector<WettedFace>& out) const {
  for_each_wet_face(water_plane(R, p, level), [&](double area, const Vec3& centroid, const Vec3& normal) {
    out.push_back({area, p + R * centroid, R * normal});
  });
}

}  // namespace nilas::hydro
