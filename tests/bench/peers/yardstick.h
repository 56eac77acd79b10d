#pragma once
/// Converts a peer's contacts and impulses into our contact problem, so that `measure` finds the errors of all engines.
#include "contact/law/contact_frame.h"
#include "contact/measure/measure.h"
#include "tests/bench/peers/floe_scene.h"

namespace peers {

/// One contact of a step in a peer. Bodies: index of a floe, k_hull or k_wall.
struct Touching {
  int a = 0, b = 0;
  nilas::Vec3 p, n;     ///< Point and normal at the step's start; n points from a to b.
  nilas::Vec3 impulse;  ///< Impulse on b [N s].
  /// Speed of separation along n that the stabilisation demands [m/s]; negative where a gap allows approach.
  double speed_asked = 0;
};
constexpr int k_hull = -1, k_wall = -2;

inline nilas::Vec3 vec(const double* x) { return {x[0], x[1], x[2]}; }

/// Jacobian of floe k at p in the contact's frame, 3 x 6; no columns for other bodies.
inline nilas::MatX rows_of(const std::vector<BodyState>& before, int k, const nilas::Vec3& p, const nilas::Mat3& C,
                           double sign) {
  if (k < 0) return nilas::MatX(3, 0);
  const nilas::Vec3 arm = p - vec(before[k].p);
  nilas::MatX J(3, 6);
  for (int i = 0; i < 3; ++i) {
    const nilas::Vec3 axis = C.col(i), moment = arm.cross(axis);
    J.row(i) << sign * axis.transpose(), sign * moment.transpose();
  }
  return J;
}

/// Largest natural map of the step [m/s], from the states before and after it.
inline double natural_map(const FloeScene& s, const std::vector<BodyState>& before, const std::vector<BodyState>& after,
                          const std::vector<Touching>& touches) {
  nilas::contact::ContactProblem problem;
  problem.h = s.step;
  nilas::VecX v(6 * static_cast<Eigen::Index>(before.size()));
  for (std::size_t k = 0; k < before.size(); ++k) {
    nilas::Mat3 R;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) R(i, j) = before[k].R[i][j];
    nilas::MatX mass = nilas::MatX::Zero(6, 6);
    mass.topLeftCorner<3, 3>() = s.floes[k].mass * nilas::Mat3::Identity();
    mass.bottomRightCorner<3, 3>() = R * vec(s.floes[k].inertia.data()).asDiagonal() * R.transpose();
    mass = 0.5 * (mass + mass.transpose()).eval();
    problem.add_block(mass);
    v.segment<6>(6 * static_cast<Eigen::Index>(k)) << vec(after[k].v), vec(after[k].w);
  }
  nilas::VecX r(3 * static_cast<Eigen::Index>(touches.size()));
  for (std::size_t c = 0; c < touches.size(); ++c) {
    const Touching& t = touches[c];
    const nilas::Mat3 C = nilas::contact::contact_frame(t.n, nilas::Mat3::Identity(), 0);
    problem.add_contact(t.a < 0 ? -1 : t.a, rows_of(before, t.a, t.p, C, -1), t.b < 0 ? -1 : t.b,
                        rows_of(before, t.b, t.p, C, 1), c);
    problem.mu.back() = problem.mu_static.back() = s.friction;
    const nilas::Vec3 hull = C.transpose() * nilas::Vec3(s.hull_speed, 0, 0);
    const double hull_side = (t.b == k_hull ? 1 : 0) - (t.a == k_hull ? 1 : 0);
    problem.w.tail<3>() = hull_side * hull - nilas::Vec3(t.speed_asked, 0, 0);
    r.segment<3>(3 * static_cast<Eigen::Index>(c)) = C.transpose() * t.impulse;
  }
  problem.f = nilas::VecX::Zero(v.size());  // Only the natural map is used, which does not depend on f.
  return touches.empty() ? 0 : nilas::contact::measure(problem, r, v).natural_map_m_s;
}

}  // namespace peers
