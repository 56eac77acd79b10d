#include "contact/law/cone.h"

#include <algorithm>
#include <cmath>

namespace nilas::contact {

Vec3 project_cone(const Vec3& x, double mu) {
  const double n = x[0];
  const double t = tangential_norm(x);
  if (mu <= 1) {
    if (n >= 0 && t <= mu * n) return x;
    if (mu * t <= -n) return Vec3::Zero();
    const double height = (n + mu * t) / (1 + mu * mu);
    return {height, mu * height * (x[1] / t), mu * height * (x[2] / t)};
  }
  // a steep cone through the slope of its polar, so that mu may be as large as it likes
  const double k = 1 / mu;
  if (k * t <= n) return x;
  if (t <= -k * n) return Vec3::Zero();
  const double radius = (k * n + t) / (1 + k * k);
  return {k * radius, radius * (x[1] / t), radius * (x[2] / t)};
}

Vec3 project_cone(const Vec3& x, double mu, double cap) {
  const Vec3 y = project_cone(x, mu);
  if (y[0] <= cap) return y;
  // If the nearest point of the whole cone lies above the cap, that of the truncated one lies on the cap.
  const double t = tangential_norm(x);
  const double rim = cap > 0 ? mu * cap : 0;
  const double scale = t > rim ? rim / t : 1;
  return {cap, scale * x[1], scale * x[2]};
}

namespace {

/// The mirror sector of the polygon that a tangential vector lies in, with axes along and across its facet's normal.
struct Sector {
  Vec2 out;      ///< outward normal of the facet
  Vec2 along;    ///< unit vector along the facet
  double inner;  ///< distance of the facet from the centre of P
  double half;   ///< half length of the facet of P
};

Sector sector_of(const Vec2& t, int facets) {
  const double width = 2 * k_pi / facets;
  const double angle = (std::floor(std::atan2(t.y(), t.x()) / width) + 0.5) * width;
  const double c = std::cos(angle), s = std::sin(angle);
  return {{c, s}, {-s, c}, std::cos(0.5 * width), std::sin(0.5 * width)};
}

/// (height, out, along) of the nearest point of the endless pyramid for a point outside it, in its sector's axes.
Vec3 nearest_on_facet(double n, double s, double tau, double slope, double half) {
  const double height = (n + slope * s) / (1 + slope * slope);
  if (height >= 0 && std::abs(tau) <= half * height) return {height, slope * height, tau};
  const double side = std::copysign(1.0, tau);
  const double edge = std::max(0.0, (n + slope * s + half * side * tau) / (1 + slope * slope + half * half));
  return {edge, slope * edge, half * side * edge};
}

}  // namespace

Vec3 project_pyramid(const Vec3& x, double mu, int facets, double cap) {
  const Sector sector = sector_of(x.tail<2>(), facets);
  const double n = x[0], s = sector.out.dot(x.tail<2>()), tau = sector.along.dot(x.tail<2>());
  const double slope = mu * sector.inner, half = mu * sector.half;
  const bool inside = n >= 0 && s <= slope * n;
  if (inside && n <= cap) return x;
  Vec3 y = inside ? Vec3(n, s, tau) : nearest_on_facet(n, s, tau, slope, half);
  if (y[0] > cap) {
    const bool over_cap = s <= slope * cap;
    y = {cap, over_cap ? s : slope * cap, over_cap ? tau : std::clamp(tau, -half * cap, half * cap)};
  }
  const Vec2 tangential = y[1] * sector.out + y[2] * sector.along;
  return {y[0], tangential.x(), tangential.y()};
}

double pyramid_support(const Vec2& t, int facets) {
  const double width = 2 * k_pi / facets;
  const double angle = std::atan2(t.y(), t.x());
  return t.norm() * std::cos(angle - width * std::round(angle / width));
}

}  // namespace nilas::contact
