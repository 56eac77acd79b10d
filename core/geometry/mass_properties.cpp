#include "core/geometry/mass_properties.h"

#include <Eigen/Eigenvalues>

#include "core/base/error.h"
#include "core/base/mirror_order.h"
#include "core/base/order_free_sum.h"

namespace nilas::geometry {

namespace {

constexpr double k_slab = 1.0 / 12.0;  // integral of x^2 over [-1/2, 1/2]

/// Volume and its first and second moments about a reference point.
struct VolumeMoments {
  double volume = 0;           ///< [m^3]
  Vec3 first = Vec3::Zero();   ///< integral of x [m^4]
  Mat3 second = Mat3::Zero();  ///< integral of x x^T [m^5]
};

VolumeMoments moments_about(const TriangleMesh& mesh, const Vec3& reference) {
  // over the tetrahedron (0, a, b, c) with s = a + b + c: V s / 4 and V / 20 (s s^T + a a^T + b b^T + c c^T)
  constexpr double k_volume = 1.0 / 6.0, k_first = 1.0 / 4.0, k_second = 1.0 / 20.0;
  OrderFreeSum volume;
  OrderFreeVectorSum first, second_x, second_y, second_z;
  for (const auto& triangle : mesh.triangles) {
    const auto t = from_first(triangle, mesh.vertices);
    const auto corner = [&](std::size_t k) -> Vec3 { return mesh.vertices[t[k]] - reference; };
    const Vec3 a = corner(0), b = corner(1), c = corner(2), s = a + (b + c);
    const double v = k_volume * a.dot(b.cross(c));
    volume.add(v);
    first.add(k_first * v * s);
    const Mat3 second =
        k_second * v * ((s * s.transpose() + a * a.transpose()) + (b * b.transpose() + c * c.transpose()));
    second_x.add(second.col(0));
    second_y.add(second.col(1));
    second_z.add(second.col(2));
  }
  VolumeMoments m{volume.value(), first.value(), Mat3::Zero()};
  m.second << second_x.value(), second_y.value(), second_z.value();
  return m;
}

/// Shoelace area times two, and the centroid, both relative to `reference`.
PolygonMoments area_and_centroid(const std::vector<Vec2>& outline, const Vec2& reference) {
  OrderFreeSum twice_area, first_x, first_y;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i] - reference, b = outline[(i + 1) % outline.size()] - reference;
    const double c = a.x() * b.y() - a.y() * b.x();
    twice_area.add(c);
    first_x.add(c * (a.x() + b.x()));
    first_y.add(c * (a.y() + b.y()));
  }
  PolygonMoments m;
  m.area = 0.5 * twice_area.value();
  m.centroid = reference;
  if (m.area != 0) m.centroid += Vec2(first_x.value(), first_y.value()) / (6 * m.area);
  return m;
}

}  // namespace

PolygonMoments polygon_moments(const std::vector<Vec2>& outline) {
  if (outline.empty()) return {};
  // about the middle of the bounding box first, then about the centroid itself, so that far-off outlines lose no digits
  Vec2 low = outline.front(), high = low;
  for (const Vec2& x : outline) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  PolygonMoments m = area_and_centroid(outline, 0.5 * (low + high));
  constexpr double k_square = 1.0 / 12.0, k_product = 1.0 / 24.0;
  OrderFreeSum xx, yy, xy;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i] - m.centroid, b = outline[(i + 1) % outline.size()] - m.centroid;
    const double c = a.x() * b.y() - a.y() * b.x();
    xx.add(c * (a.x() * a.x() + b.x() * b.x() + a.x() * b.x()));
    yy.add(c * (a.y() * a.y() + b.y() * b.y() + a.y() * b.y()));
    xy.add(c * (a.x() * b.y() + b.x() * a.y() + 2 * (a.x() * a.y() + b.x() * b.y())));
  }
  m.xx = k_square * xx.value();
  m.yy = k_square * yy.value();
  m.xy = k_product * xy.value();
  return m;
}

MassProperties prism_properties(const std::vector<Vec2>& outline, double thickness, double density) {
  const PolygonMoments m = polygon_moments(outline);
  NILAS_DEMAND(m.area > 0 && thickness > 0 && density > 0);
  const double per_area = density * thickness, zz = k_slab * m.area * thickness * thickness;
  MassProperties p;
  p.mass = per_area * m.area;
  p.com = {m.centroid.x(), m.centroid.y(), 0};
  p.inertia << per_area * (m.yy + zz), -per_area * m.xy, 0,  //
      -per_area * m.xy, per_area * (m.xx + zz), 0,           //
      0, 0, per_area * (m.xx + m.yy);
  return p;
}

MassProperties box_properties(const Vec3& size, double mass) {
  NILAS_DEMAND(size.minCoeff() > 0 && mass > 0);
  const Vec3 s = k_slab * mass * size.cwiseProduct(size);
  MassProperties p;
  p.mass = mass;
  p.inertia = Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()).asDiagonal();
  return p;
}

MassProperties sphere_properties(double radius, double mass) {
  NILAS_DEMAND(radius > 0 && mass > 0);
  constexpr double k_sphere = 2.0 / 5.0;  // inertia of a solid sphere over m r^2
  MassProperties p;
  p.mass = mass;
  p.inertia = k_sphere * mass * radius * radius * Mat3::Identity();
  return p;
}

MassProperties cylinder_properties(double radius, double height, double mass) {
  NILAS_DEMAND(radius > 0 && height > 0 && mass > 0);
  const double disc = mass * radius * radius, across = disc / 4 + k_slab * mass * height * height;
  MassProperties p;
  p.mass = mass;
  p.inertia = Vec3(across, across, 0.5 * disc).asDiagonal();
  return p;
}

MassProperties mesh_properties(const TriangleMesh& mesh, double density) {
  NILAS_DEMAND(!mesh.triangles.empty() && density > 0);
  // first about the middle of the bounding box, then about the centroid found, so that a far-off mesh loses no digits
  Vec3 low = mesh.vertices.front(), high = low;
  for (const Vec3& x : mesh.vertices) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const Vec3 near = 0.5 * (low + high);
  const VolumeMoments rough = moments_about(mesh, near);
  NILAS_DEMAND(rough.volume > 0);
  const Vec3 reference = near + rough.first / rough.volume;
  const VolumeMoments m = moments_about(mesh, reference);
  const Vec3 shift = m.first / m.volume;
  const Mat3 second = m.second - m.volume * shift * shift.transpose();
  MassProperties p;
  p.mass = density * m.volume;
  p.com = reference + shift;
  p.inertia = density * (second.trace() * Mat3::Identity() - second);
  return p;
}

bool physically_valid_inertia(const Mat3& inertia) {
  if (!inertia.allFinite()) return false;
  constexpr double k_rounding = 1e-9;  // of the largest moment; a flat plate sits on the limit of the sum itself
  if ((inertia - inertia.transpose()).norm() > k_rounding * inertia.norm()) return false;
  const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  return moments[0] > k_rounding * moments[2] && moments[0] + moments[1] >= moments[2] * (1 - k_rounding);
}

}  // namespace nilas::geometry
