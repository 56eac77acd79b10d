#include "contact/detect/round_axes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nilas {

namespace {

/// What the directions of an arc separate, by angle. It is smooth where the directions stay on one side of the
/// cylinder's caps.
class ArcSeparation {
 public:
  ArcSeparation(const Arc& arc, const Vec3& p, const RoundBody& body)
      : w_start_(arc.start.dot(body.centre - p)),
        w_side_(arc.side.dot(body.centre - p)),
        k_start_(arc.start.dot(body.axis)),
        k_side_(arc.side.dot(body.axis)),
        body_(body) {}

  double operator()(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    const double up = c * k_start_ + s * k_side_;
    return c * w_start_ + s * w_side_ - body_.radius * std::sqrt(std::max(0.0, 1 - up * up)) -
           body_.half_height * std::abs(up);
  }
  /// Its derivative where the directions look towards the cap on side `cap` (1 or -1) of the cylinder.
  double slope(double angle, double cap) const {
    const double c = std::cos(angle), s = std::sin(angle);
    const double up = c * k_start_ + s * k_side_, turn = c * k_side_ - s * k_start_;
    const double across = std::sqrt(std::max(1e-24, 1 - up * up));
    return c * w_side_ - s * w_start_ + (body_.radius * up / across - cap * body_.half_height) * turn;
  }
  double cap(double angle) const { return std::cos(angle) * k_start_ + std::sin(angle) * k_side_ < 0 ? -1 : 1; }
  /// Angle in [0, pi) where the directions pass from one cap to the other.
  double turning() const {
    const double angle = std::atan2(-k_start_, k_side_);
    return angle < 0 ? angle + k_pi : angle;
  }

 private:
  double w_start_, w_side_, k_start_, k_side_;
  const RoundBody& body_;
};

/// Angle of the top of f between low and high, where it has one, by halving: by the slope, since the top itself is
/// flat.
double top_between(const ArcSeparation& f, double low, double high) {
  const double cap = f.cap(0.5 * (low + high));
  constexpr int k_steps = 55;
  for (int step = 0; step < k_steps; ++step) {
    const double middle = 0.5 * (low + high);
    (f.slope(middle, cap) > 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The best angle of a smooth stretch: around each sample that is no lower than its neighbours.
void search_stretch(const ArcSeparation& f, double low, double high, double& best, double& best_angle) {
  // Seen along the edge a cap is an ellipse, which has at most two tops in half a turn.
  constexpr int k_samples = 12;
  std::array<double, k_samples + 1> at{};
  const auto angle_of = [&](int k) { return low + (high - low) * k / k_samples; };
  for (int k = 0; k <= k_samples; ++k) at[static_cast<std::size_t>(k)] = f(angle_of(k));
  const auto offer = [&](double angle, double s) {
    if (s <= best) return;
    best = s;
    best_angle = angle;
  };
  for (int k = 0; k <= k_samples; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const bool lower = (k > 0 && at[i - 1] > at[i]) || (k < k_samples && at[i + 1] > at[i]);
    if (lower) continue;
    offer(angle_of(k), at[i]);
    const double angle = top_between(f, angle_of(std::max(k - 1, 0)), angle_of(std::min(k + 1, k_samples)));
    offer(angle, f(angle));
  }
}

Vec3 direction(const Arc& arc, double angle) { return std::cos(angle) * arc.start + std::sin(angle) * arc.side; }

/// Extent of a cylinder with its derivatives by n, n not along the axis.
struct ExtentDerivatives {
  Vec3 point;  ///< the supporting point, which is the gradient
  Mat3 curvature;
};

ExtentDerivatives differentiate(const RoundBody& body, const Vec3& n) {
  const double up = n.dot(body.axis);
  const Vec3 across = n - up * body.axis;
  const double length = std::max(across.norm(), 1e-12);
  const Vec3 out = across / length;
  return {body.radius * out + (up < 0 ? -body.half_height : body.half_height) * body.axis,
          body.radius / length * (Mat3::Identity() - out * out.transpose() - body.axis * body.axis.transpose())};
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
  double best_angle = 0, best = f(0);
  search_stretch(f, 0, turning, best, best_angle);
  search_stretch(f, turning, arc.angle, best, best_angle);
  return {direction(arc, best_angle), best};
}

RoundAxis climb_between_rims(const RoundBody& a, const RoundBody& b, const Vec3& n) {
  const Vec3 between = b.centre - a.centre;
  const auto separation = [&](const Vec3& x) { return x.dot(between) - a.extent(x) - b.extent(x); };
  RoundAxis at{n, separation(n)};
  constexpr int k_most_steps = 60;
  double reach = 0.1;  // [rad], how far a step may go
  for (int step = 0; step < k_most_steps && reach > 1e-9; ++step) {
    const ExtentDerivatives of_a = differentiate(a, at.n), of_b = differentiate(b, at.n);
    Eigen::Matrix<double, 3, 2> tangents;
    tangents.col(0) = at.n.unitOrthogonal();
    tangents.col(1) = at.n.cross(tangents.col(0));
    const Vec2 gradient = tangents.transpose() * (between - of_a.point - of_b.point);
    const Eigen::Matrix2d curvature =
        -(tangents.transpose() * (of_a.curvature + of_b.curvature) * tangents) - at.s * Eigen::Matrix2d::Identity();
    Vec2 way = gradient;
    if (curvature(0, 0) < 0 && curvature.determinant() > 0) way = -curvature.inverse() * gradient;
    if (way.norm() > reach) way *= reach / way.norm();
    const Vec3 next = (at.n + tangents * way).normalized();
    const double s = separation(next);
    if (s > at.s) {
      at = {next, s};
      reach *= 2;
    } else {
      reach = 0.25 * std::min(reach, way.norm());
    }
  }
  return at;
}

}  // namespace nilas
