#include "contact/detect/surface/round_axes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nilas::detect {

namespace {

Vec3 direction(const Arc& arc, double angle) { return std::cos(angle) * arc.start + std::sin(angle) * arc.side; }

/// The separation along the directions of an arc, as a function of the angle. It is smooth where the directions stay on
/// one side of the cylinder's caps.
class ArcSeparation {
 public:
  ArcSeparation(const Arc& arc, const Vec3& p, const RoundBody& body)
      : w_start_(arc.start.dot(body.centre - p)),
        w_side_(arc.side.dot(body.centre - p)),
        k_start_(arc.start.dot(body.axis)),
        k_side_(arc.side.dot(body.axis)),
        k_square_(arc.start.cross(arc.side).dot(body.axis)),
        body_(body) {}

  double operator()(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return c * w_start_ + s * w_side_ - body_.radius * across(c, s) -
           body_.half_height * std::abs(c * k_start_ + s * k_side_);
  }
  /// Its derivative where the directions look towards the cap on side `cap` (1 or -1) of the cylinder.
  double slope(double angle, double cap) const {
    const double c = std::cos(angle), s = std::sin(angle);
    const double up = c * k_start_ + s * k_side_, turn = c * k_side_ - s * k_start_;
    return c * w_side_ - s * w_start_ +
           (body_.radius * up / std::max(across(c, s), 1e-12) - cap * body_.half_height) * turn;
  }
  double cap(double angle) const { return std::cos(angle) * k_start_ + std::sin(angle) * k_side_ < 0 ? -1 : 1; }
  /// Angle in [0, pi) where the directions pass from one cap to the other.
  double turning() const {
    const double angle = std::atan2(-k_start_, k_side_);
    return angle < 0 ? angle + k_pi : angle;
  }
  /// Angles on both sides of `middle`, between which the stretch that looks towards the cap has at most one top each.
  std::array<double, 3> divisions(double cap) const;

 private:
  /// Sine of the direction's angle to the cylinder's axis.
  double across(double c, double s) const { return std::hypot(k_square_, c * k_side_ - s * k_start_); }

  double w_start_, w_side_;             ///< components of the vector from p to the centre [m]
  double k_start_, k_side_, k_square_;  ///< components of the axis, along and perpendicular to the arc
  const RoundBody& body_;
};

// With t from the angle that looks most towards the cap, and tan t = e tan u, e the sine of the axis to the arc, the
// slope has the sign of Q cos u - P e sin u - radius (1 - e^2) sin u cos u: the cap is seen as an ellipse, of which the
// angle u is the parameter. Divided by sin u cos u, its first two terms change their trend at 0 and where
// tan^3 u = |Q / (P e)| only.
std::array<double, 3> ArcSeparation::divisions(double cap) const {
  const double middle = std::atan2(cap * k_side_, cap * k_start_);
  const double c = std::cos(middle), s = std::sin(middle);
  const double p = c * w_start_ + s * w_side_ - body_.half_height * std::hypot(k_start_, k_side_);
  const double q = c * w_side_ - s * w_start_;
  const double aside = std::atan2(std::cbrt(k_square_ * k_square_ * std::abs(q)), std::cbrt(std::abs(p)));
  return {middle - aside, middle, middle + aside};
}

/// Returns the angle of the maximum of f between low and high by bisection, where f rises from low and falls to high.
/// The slope is used, since the maximum itself is flat.
double top_between(const ArcSeparation& f, double cap, double low, double high) {
  constexpr int k_steps = 55;
  for (int step = 0; step < k_steps; ++step) {
    const double middle = 0.5 * (low + high);
    (f.slope(middle, cap) > 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The best angle of a smooth stretch: one of its ends, or a top between two of its divisions.
void search_stretch(const ArcSeparation& f, double low, double high, RoundAxis& best, const Arc& arc) {
  const double cap = f.cap(0.5 * (low + high));
  std::array<double, 5> at{low, low, low, low, high};
  std::size_t k = 1;
  for (const double angle : f.divisions(cap))
    at[k++] = std::clamp(angle - 2 * k_pi * std::round((angle - 0.5 * (low + high)) / (2 * k_pi)), low, high);
  std::sort(at.begin(), at.end());
  const auto offer = [&](double angle) {
    const double s = f(angle);
    if (s > best.s) best = {direction(arc, angle), s};
  };
  offer(low);
  offer(high);
  for (k = 0; k + 1 < at.size(); ++k)
    if (at[k] < at[k + 1] && f.slope(at[k], cap) > 0 && f.slope(at[k + 1], cap) < 0)
      offer(top_between(f, cap, at[k], at[k + 1]));
}
}  // namespace

double RoundBody::extent(const Vec3& n) const {
  const double up = n.dot(axis);
  return radius * (n - up * axis).norm() + half_height * std::abs(up);
}

Arc arc_between(const Vec3& from, const Vec3& to) {
  const Vec3 side = to - to.dot(from) * from;
  return {from, side.normalized(), std::atan2(side.norm(), to.dot(from))};
}

double most_over_arc(const Arc& arc, const Vec3& p, double inner_radius, const RoundBody& body) {
  const double start = arc.start.dot(body.centre - p), side = arc.side.dot(body.centre - p);
  const double angle = std::atan2(side, start);
  const double end = std::cos(arc.angle) * start + std::sin(arc.angle) * side;
  return (angle >= 0 && angle <= arc.angle ? std::hypot(start, side) : std::max(start, end)) - inner_radius;
}

RoundAxis best_over_arc(const Arc& arc, const Vec3& p, const RoundBody& body) {
  const ArcSeparation f(arc, p, body);
  const double turning = std::min(f.turning(), arc.angle);
  RoundAxis best{arc.start, f(0)};
  search_stretch(f, 0, turning, best, arc);
  search_stretch(f, turning, arc.angle, best, arc);
  return best;
}

}  // namespace nilas::detect
