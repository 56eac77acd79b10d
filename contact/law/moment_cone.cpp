#include "contact/law/moment_cone.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/law/cone.h"

namespace nilas::contact {

namespace {

double rolling_norm(const Vec3& moment) { return tangential_norm(moment); }

/// The parts of a cone over the normal, each a disc of radius slope * r_N.
struct Disc {
  double length;  ///< length of the vector to be projected
  double slope;
};

/// n >= 0 that minimises (n - x_N)^2 + sum max(0, length - slope n)^2: the discs that n leaves outside pull it up,
/// those with the largest length/slope first.
double nearest_height(double x_n, std::array<Disc, 3> discs) {
  const auto reach = [](const Disc& d) { return d.slope > 0 ? d.length / d.slope : 0; };
  std::sort(discs.begin(), discs.end(), [&](const Disc& a, const Disc& b) { return reach(a) > reach(b); });
  double rhs = x_n, weight = 1, n = x_n;
  for (const Disc& disc : discs) {
    if (n >= reach(disc)) break;
    rhs += disc.slope * disc.length;
    weight += disc.slope * disc.slope;
    n = rhs / weight;
  }
  return std::max(n, 0.0);
}

double shrink(double length, double radius) { return length > radius ? radius / length : 1; }

}  // namespace

ForceAndMoment project_moment_cone(const ForceAndMoment& x, double mu, double cap) {
  const double friction = tangential_norm(x.force), spin = std::abs(x.moment[0]), roll = rolling_norm(x.moment);
  const double n = std::min(nearest_height(x.force[0], {Disc{friction, mu}, {spin, 1}, {roll, 1}}), cap);
  const double t = shrink(friction, mu * n), s = shrink(spin, n), m = shrink(roll, n);
  return {{n, t * x.force[1], t * x.force[2]}, {s * x.moment[0], m * x.moment[1], m * x.moment[2]}};
}

static ForceAndMoment cone_residual(const ContactScale& scale, const ForceAndMoment& r, const ForceAndMoment& u,
                                    double shift) {
  const Vec3 u_hat(u.force[0] + shift, u.force[1], u.force[2]);
  const ForceAndMoment nearest =
      project_moment_cone({r.force - u_hat / scale.d, r.moment - u.moment / scale.d}, scale.mu, scale.force_limit);
  return {r.force - nearest.force, r.moment - nearest.moment};
}

static double length(const ForceAndMoment& x) { return std::sqrt(x.force.squaredNorm() + x.moment.squaredNorm()); }

/// u_hat - u of exact Coulomb in force and moment.
static double coulomb_shift(const ContactScale& scale, const ForceAndMoment& u) {
  return scale.mu * tangential_norm(u.force) + std::abs(u.moment[0]) + rolling_norm(u.moment);
}

double natural_map(const ContactScale& scale, const ForceAndMoment& r, const ForceAndMoment& u) {
  if (scale.d == 0) return natural_map(scale, r.force, u.force);
  return scale.d * length(cone_residual(scale, r, u, coulomb_shift(scale, u)));
}

double ccp_map(const ContactScale& scale, const ForceAndMoment& r, const ForceAndMoment& u) {
  return scale.d == 0 ? ccp_map(scale, r.force, u.force) : scale.d * length(cone_residual(scale, r, u, 0));
}

Vec3 natural_residual(const ContactScale& scale, const ForceAndMoment& r, const ForceAndMoment& u) {
  return scale.d == 0 ? Vec3::Zero() : cone_residual(scale, r, u, coulomb_shift(scale, u)).force;
}

/// The laws that take moments: the box's force rows stand by themselves.
Vec3 law_residual(Law law, const ContactScale& scale, const ForceAndMoment& r, const ForceAndMoment& u) {
  if (law == Law::coulomb) return natural_residual(scale, r, u);
  if (law == Law::ccp) return scale.d == 0 ? Vec3::Zero() : cone_residual(scale, r, u, 0).force;
  return law_residual(law, 0, scale, r.force, u.force);
}

double law_map(Law law, const ContactScale& scale, const ForceAndMoment& r, const ForceAndMoment& u) {
  if (law == Law::coulomb || scale.d == 0) return natural_map(scale, r, u);
  if (law == Law::ccp) return ccp_map(scale, r, u);
  const double bound = std::max(r.force[0], 0.0);
  Vec3 step;
  for (int i = 0; i < 3; ++i) step[i] = r.moment[i] - std::clamp(r.moment[i] - u.moment[i] / scale.d, -bound, bound);
  return std::hypot(law_map(law, 0, scale, r.force, u.force), scale.d * step.norm());
}

}  // namespace nilas::contact
