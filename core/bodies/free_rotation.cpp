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
      path_ = 1.0 / 6 - angle * angle / 120;
    } else {
      const double half = std::sin(0.5 * angle) / angle;
      along_ = std::sin(angle) / angle;
      across_ = 2 * half * half;
      path_ = (1 - along_) / (angle * angle);
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
  /// The way of a point that goes `x` along the axes of a body while these turn: the integral of exp(s turn) x over s
  /// from 0 to 1, in the axes at the start.
  Vec3 way(const Vec3& x) const {
    const Vec3 once = turn_.cross(x);
    return x + across_ * once + path_ * turn_.cross(once);
  }
  /// (1 - sin(a)/a) times what of x is across the axis.
  Vec3 missing_way(const Vec3& x) const { return -path_ * turn_.cross(turn_.cross(x)); }

 private:
  Vec3 turn_;
  double along_ = 0, across_ = 0, path_ = 0;  ///< sin(a)/a, (1 - cos(a))/a^2, (1 - sin(a)/a)/a^2
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

/// Moves body and water over h in the axes of the flow. In body axes, (P; L) = M (v; w), and m = ((v; w) + (v;
/// w)_end)/2 is the mean twist. With the rotation X = exp(h m_w) and the way d, both in the axes at the start, P_end =
/// X^T P and L_end = X^T (L - d x P). So P and L + p x P are kept in G. The energy changes by m . (change of P; L).
/// This is zero where P . (X m_v - m_v - m_w x d) = 0, as for the way of the screw m. A part of d along P_t, what of P
/// is across m_w, changes nothing in this. It is chosen so that the way is straight where the mass is the same in all
/// directions.
class FreeStep {
 public:
  FreeStep(const Mat6& mass_B, const Mat6& mass_inverse_B, double h)
      : mass_(mass_B), inverse_(mass_inverse_B), h_(h), mean_mass_(mass_B.topLeftCorner<3, 3>().trace() / 3) {}

  void take(Vec3& p, Quat& q, Vec3& v, Vec3& w) {
    const Mat3 R = q.toRotationMatrix();
    twist_ << R.transpose() * v, R.transpose() * w;
    momentum_ = mass_ * twist_;
    solve();
    const Vec3 turn = h_ * (twist_ + 0.5 * change_).tail<3>();
    p += R * way_;
    const TurnChange in_G(R * turn);
    const Vec3 v_end = v + R * change_.head<3>(), w_end = w + R * change_.tail<3>();
    v = v_end + in_G.of(v_end);
    w = w_end + in_G.of(w_end);
    q = (q * exponential(turn)).normalized();
  }

 private:
  /// The mean twist is a fixed point, as in turn_once().
  void solve() {
    const Vec3 linear = momentum_.head<3>(), angular = momentum_.tail<3>();
    Vec6 of_momentum = Vec6::Zero();
    constexpr int k_most_passes = 50;
    double last_move = std::numeric_limits<double>::infinity();
    for (int pass = 0; pass < k_most_passes; ++pass) {
      const TurnChange turn(h_ * (twist_ + 0.5 * change_).tail<3>());
      of_momentum.head<3>() = turn.backwards(linear);
      // The velocity follows the turn at once, so that the lever is small where the mass is nearly the same in all
      // directions.
      const Vec3 mean = twist_.head<3>() + 0.5 * (inverse_.topRows<3>() * of_momentum);
      way_ = turn.way(h_ * mean) + h_ / mean_mass_ * turn.missing_way(linear);
      const Vec3 lever = way_.cross(linear);
      of_momentum.tail<3>() = turn.backwards(angular - lever) - lever;
      const Vec6 next = inverse_ * of_momentum, step = next - change_;
      const double move = step.dot(mass_ * step);
      change_ = next;
      if (!(move < last_move)) break;
      last_move = move;
    }
  }

  const Mat6 &mass_, &inverse_;
  double h_, mean_mass_;
  Vec6 twist_, momentum_, change_ = Vec6::Zero();  ///< at the start, and the change of the twist, in body axes
  Vec3 way_ = Vec3::Zero();                        ///< in the axes at the start [m]
};

}  // namespace

void move_freely(Vec3& p, Quat& q, Vec3& v, Vec3& w, const Mat6& mass_B, const Mat6& mass_inverse_B, const Vec3& flow,
                 double h) {
  v -= flow;
  // The Munk moment turns a body at a rate of about its speed times the root of the difference of masses over inertia.
  const Vec3 masses = mass_B.diagonal().head<3>();
  const double difference = masses.maxCoeff() - masses.minCoeff();
  const double rate = w.norm() + v.norm() * std::sqrt(difference / mass_B.diagonal().tail<3>().minCoeff());
  constexpr double k_largest_turn = 0.25;  // [rad] up to which the mean is found quickly
  const double turn = h * rate;
  const int parts = turn > k_largest_turn ? static_cast<int>(std::ceil(std::min(turn / k_largest_turn, 1e4))) : 1;
  for (int part = 0; part < parts; ++part) FreeStep(mass_B, mass_inverse_B, h / parts).take(p, q, v, w);
  v += flow;
  p += h * flow;
}

void turn_freely(Quat& q, Vec3& w, const Mat3& inertia_B, const Mat3& inertia_inverse_B, double h) {
  constexpr double k_largest_turn = 0.5;  // [rad] up to which the mean is found quickly
  const double turn = h * w.norm();
  const int parts = turn > k_largest_turn ? static_cast<int>(std::ceil(std::min(turn / k_largest_turn, 1e4))) : 1;
  for (int part = 0; part < parts; ++part) turn_once(q, w, inertia_B, inertia_inverse_B, h / parts);
}

}  // namespace nilas::bodies
