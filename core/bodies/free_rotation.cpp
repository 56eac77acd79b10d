#include "core/bodies/free_rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nilas::bodies {

Quat exponential(const Vec3& turn) {
  const double angle = turn.norm();
  constexpr double k_small_angle = 1e-4;  // [rad] below it sin(x/2)/x differs from its series by less than rounding
  const double scale = angle < k_small_angle ? 0.5 - angle * angle / 48.0 : std::sin(0.5 * angle) / angle;
  return {std::cos(0.5 * angle), scale * turn.x(), scale * turn.y(), scale * turn.z()};
}

namespace {

/// The change of a vector by a rotation. The rounding of a change is a share of the change. Rotating the whole vector
/// by nearly the same small angle in every step would always round in the same direction, which shows after a million
/// steps.
class TurnChange {
 public:
  explicit TurnChange(const Vec3& turn) : turn_(turn) {
    const double angle = turn.norm();
    constexpr double k_small_angle = 1e-4;  // [rad]
    if (angle < k_small_angle) {
      along_ = 1 - angle * angle / 6;
      across_ = 0.5 - angle * angle / 24;
    } else {
      const double half = std::sin(0.5 * angle) / angle;
      along_ = std::sin(angle) / angle;
      across_ = 2 * half * half;
    }
  }
  Vec3 of(const Vec3& x) const {
    const Vec3 once = turn_.cross(x);
    return along_ * once + across_ * turn_.cross(once);
  }
  Vec3 backwards(const Vec3& x) const {
    const Vec3 once = turn_.cross(x);
    return across_ * turn_.cross(once) - along_ * once;
  }

 private:
  Vec3 turn_;
  double along_ = 0, across_ = 0;  ///< sin(a)/a, (1 - cos(a))/a^2
};

/// Rotates a body over h. In body axes, P = I w, m = (w + w_end)/2, R_end = R exp(h m), P_end = exp(-h m) P. Then R P
/// is kept, and 2 dE = P_end . w_end - P . w = (P_end - P) . 2 m = 0, since a rotation about m keeps the component
/// along m.
void turn_once(Quat& q, Vec3& w, const Mat3& inertia_B, const Mat3& inertia_inverse_B, double h) {
  const Mat3 R = q.toRotationMatrix();
  const Vec3 w_B = R.transpose() * w, momentum = inertia_B * w_B;
  Vec3 change = Vec3::Zero(), turn = h * w_B;  // of w_B
  // The mean of both ends is a fixed point: each pass reduces the error by a factor of about h |w|, until rounding
  // remains.
  constexpr int k_most_passes = 50;
  double last_move = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < k_most_passes; ++pass) {
    turn = h * (w_B + 0.5 * change);
    const Vec3 next = inertia_inverse_B * TurnChange(turn).backwards(momentum);
    const double move = (next - change).squaredNorm();
    change = next;
    if (!(move < last_move)) break;
    last_move = move;
  }
  const Vec3 w_end_in_old_axes = w + R * change;
  w = w_end_in_old_axes + TurnChange(R * turn).of(w_end_in_old_axes);
  q = (q * exponential(turn)).normalized();
}

}  // namespace

void turn_freely(Quat& q, Vec3& w, const Mat3& inertia_B, const Mat3& inertia_inverse_B, double h) {
  constexpr double k_largest_turn = 0.5;  // [rad] up to which the mean is found quickly
  const double turn = h * w.norm();
  const int parts = turn > k_largest_turn ? static_cast<int>(std::ceil(std::min(turn / k_largest_turn, 1e4))) : 1;
  for (int part = 0; part < parts; ++part) turn_once(q, w, inertia_B, inertia_inverse_B, h / parts);
}

}  // namespace nilas::bodies
