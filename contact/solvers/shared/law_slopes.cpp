#include "contact/solvers/shared/law_slopes.h"

#include <algorithm>
#include <cmath>

#include "contact/law/cone.h"

namespace nilas::solvers {

namespace {

using Mat2 = Eigen::Matrix2d;

Mat2 along(const Vec2& e) { return e * e.transpose(); }

LawSlopes open_contact(const Vec3& r) {
  LawSlopes out;
  out.value = r;
  out.by_impulse.setIdentity();
  out.open = true;
  return out;
}

/// Row N of a closed contact.
void set_normal(double cap, const Vec3& r, const Vec3& u, LawSlopes& out) {
  const bool capped = r[0] - u[0] >= cap;
  out.value[0] = capped ? r[0] - cap : u[0];
  (capped ? out.by_impulse : out.by_velocity)(0, 0) = 1;
}

void set_sticking_row(int i, const Vec3& u, LawSlopes& out) {
  out.value[i] = u[i];
  out.by_velocity(i, i) = 1;
}

LawSlopes coulomb_slopes(double mu, double cap, const Vec3& r, const Vec3& u) {
  const Vec3 x = r - u;
  LawSlopes out;
  set_normal(cap, r, u, out);
  const double t = contact::tangential_norm(x), radius = mu * std::min(x[0], cap);
  if (t <= radius) {
    set_sticking_row(1, u, out);
    set_sticking_row(2, u, out);
    return out;
  }
  const Vec2 e = x.tail<2>() / t;
  const Mat2 turning = radius / t * (Mat2::Identity() - along(e));
  out.value.tail<2>() = r.tail<2>() - radius * e;
  out.by_velocity.bottomRightCorner<2, 2>() = turning;
  out.by_impulse.bottomRightCorner<2, 2>() = Mat2::Identity() - turning;
  if (x[0] < cap) {
    out.by_velocity.bottomLeftCorner<2, 1>() = mu * e;
    out.by_impulse.bottomLeftCorner<2, 1>() = -mu * e;
  }
  return out;
}

LawSlopes box_slopes(double mu, double cap, const Vec3& r, const Vec3& u) {
  LawSlopes out;
  set_normal(cap, r, u, out);
  const double bound = mu * std::max(r[0], 0.0);
  for (int i = 1; i < 3; ++i) {
    const double x = r[i] - u[i];
    if (std::abs(x) <= bound) {
      set_sticking_row(i, u, out);
      continue;
    }
    out.value[i] = r[i] - std::copysign(bound, x);
    out.by_impulse(i, i) = 1;
    if (r[0] > 0) out.by_impulse(i, 0) = -std::copysign(mu, x);
  }
  return out;
}

LawSlopes frictionless_slopes(double cap, const Vec3& r, const Vec3& u) {
  LawSlopes out;
  set_normal(cap, r, u, out);
  out.value.tail<2>() = r.tail<2>();
  out.by_impulse.bottomRightCorner<2, 2>().setIdentity();
  return out;
}

/// Derivative of the nearest point of the disc of radius `rim`.
Mat2 disc_slope(const Vec2& t, double rim) {
  const double length = t.norm();
  if (length <= rim) return Mat2::Identity();
  const Vec2 e = t / length;
  return rim / length * (Mat2::Identity() - along(e));
}

/// Derivative of project_cone(x, mu, cap).
Mat3 cone_slope(const Vec3& x, double mu, double cap) {
  Mat3 slope = Mat3::Zero();
  const Vec3 y = contact::project_cone(x, mu);
  const double t = contact::tangential_norm(x);
  if (y[0] > cap) {
    slope.bottomRightCorner<2, 2>() = disc_slope(x.tail<2>(), mu * cap);
  } else if (t <= mu * x[0]) {
    slope.setIdentity();
  } else if (y[0] > 0) {
    const Vec2 e = x.tail<2>() / t;
    const Vec3 ray = Vec3(1, mu * e[0], mu * e[1]) / std::sqrt(1 + mu * mu);
    slope = ray * ray.transpose();
    slope.bottomRightCorner<2, 2>() += mu * y[0] / t * (Mat2::Identity() - along(e));
  }
  return slope;
}

/// Derivative of project_pyramid(x, mu, facets, cap): the projection on the face that holds the nearest point.
Mat3 pyramid_slope(const Vec3& x, double mu, int facets, double cap) {
  const double width = 2 * k_pi / facets;
  const double middle = (std::floor(std::atan2(x[2], x[1]) / width) + 0.5) * width;
  const Vec3 out(0, std::cos(middle), std::sin(middle)), across(0, -out[2], out[1]);
  const double slope = mu * std::cos(0.5 * width), half = mu * std::sin(0.5 * width);
  const double s = out.dot(x), tau = across.dot(x);
  const bool inside = x[0] >= 0 && s <= slope * x[0];
  if (inside && x[0] <= cap) return Mat3::Identity();
  const Vec3 corner = Vec3(1, 0, 0) + slope * out + std::copysign(half, tau) * across;
  const double height = (x[0] + slope * s) / (1 + slope * slope);
  const bool on_facet = std::abs(tau) <= half * height;
  const double top = on_facet ? height : corner.dot(x) / corner.squaredNorm();
  if (inside || top > cap) {
    if (s <= slope * cap) return Vec3(0, 1, 1).asDiagonal();
    return std::abs(tau) < half * cap ? Mat3(across * across.transpose()) : Mat3(Mat3::Zero());
  }
  if (top <= 0) return Mat3::Zero();
  if (!on_facet) return corner * corner.transpose() / corner.squaredNorm();
  const Vec3 ray = (Vec3(1, 0, 0) + slope * out).normalized();
  return ray * ray.transpose() + across * across.transpose();
}

LawSlopes natural_slopes(const Vec3& r, const Vec3& nearest, const Mat3& slope) {
  LawSlopes out;
  out.value = r - nearest;
  out.by_velocity = slope;
  out.by_impulse = Mat3::Identity() - slope;
  out.open = slope.isZero(0) && nearest.isZero(0);
  return out;
}

LawSlopes ccp_slopes(double mu, double cap, const Vec3& r, const Vec3& u) {
  const Vec3 x = r - u;
  return natural_slopes(r, contact::project_cone(x, mu, cap), cone_slope(x, mu, cap));
}

LawSlopes pyramid_k_slopes(int facets, double mu, double cap, const Vec3& r, const Vec3& u) {
  const double width = 2 * k_pi / facets;
  const double angle = width * std::round(std::atan2(-u[2], -u[1]) / width);
  const Vec2 corner(std::cos(angle), std::sin(angle));
  const Vec3 x = r - u + Vec3(mu * corner.dot(u.tail<2>()), 0, 0);
  LawSlopes out = natural_slopes(r, contact::project_pyramid(x, mu, facets, cap), pyramid_slope(x, mu, facets, cap));
  out.by_velocity.rightCols<2>() -= out.by_velocity.col(0) * (mu * corner.transpose());
  return out;
}

}  // namespace

LawSlopes law_slopes(Law law, int facets, double mu, double cap, const Vec3& r, const Vec3& u) {
  if (law == Law::ccp) return ccp_slopes(mu, cap, r, u);
  if (law == Law::pyramid_k) return pyramid_k_slopes(facets, mu, cap, r, u);
  if (r[0] - u[0] <= 0) return open_contact(r);
  if (law == Law::pyramid) return box_slopes(mu, cap, r, u);
  if (law == Law::frictionless) return frictionless_slopes(cap, r, u);
  return coulomb_slopes(mu, cap, r, u);
}

}  // namespace nilas::solvers
