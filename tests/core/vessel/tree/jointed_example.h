#pragma once
/// Vessels of several bodies with known motion, and oracles for them.
#include <gtest/gtest.h>

#include "core/vessel/vessel_system.h"
#include "tests/core/vessel/example_vessel.h"

namespace nilas::example {

constexpr double k_gravity = 9.81;  ///< [m/s^2]

/// A part of 20 kg whose inertia has no zero entry, hanging by `joint` at a point that its centre of mass is not in.
inline vessel::PartModel part(JointKind joint, int to = -1) {
  vessel::PartModel model;
  model.mass = 20;
  model.inertia_B << 3, 0.1, -0.2, 0.1, 4, 0.3, -0.2, 0.3, 5;
  model.joint = joint;
  model.to = to;
  model.point_V = {0.5 - 0.4 * to, 0.2, -0.5};
  model.axis_V = Vec3(0.1, 0.9, 0.3).normalized();
  model.in_V.p = model.point_V + Vec3(0.3, -0.2, -0.4);
  model.in_V.q = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  return model;
}

/// A free hull in gravity-free space with a chain of a hinge, a ball and a slider, all in motion.
inline vessel::VesselModel chain() {
  vessel::VesselModel model = vessel();
  model.v = {0.4, -0.2, 0.1};
  model.w = {0.2, -0.3, 0.25};
  model.parts = {part(JointKind::hinge), part(JointKind::ball, 0), part(JointKind::slider, 1), part(JointKind::weld, 0),
                 part(JointKind::hinge)};
  model.parts[0].rate = 0.8;
  model.parts[2].rate = -0.3;
  model.parts[2].coordinate = 0.1;
  model.parts[4].coordinate = -0.6;
  return model;
}

/// Weight of hull and parts.
inline std::vector<Wrench> weights(const vessel::VesselModel& model) {
  const auto weight = [](double mass) { return Wrench{{0, 0, -k_gravity * mass}, Vec3::Zero()}; };
  std::vector<Wrench> loads{weight(model.mass.mass)};
  for (const vessel::PartModel& one : model.parts) loads.push_back(weight(one.mass));
  return loads;
}

/// One step under loads on hull and parts, with impulses on them.
inline vessel::VesselBlock step(vessel::VesselSystem& system, const std::vector<Wrench>& loads, double h,
                                const std::vector<Wrench>& impulses = {}) {
  const auto rest = [](const std::vector<Wrench>& all) { return std::vector<Wrench>(all.begin() + 1, all.end()); };
  const std::vector<Wrench> none(loads.size()), &given = impulses.empty() ? none : impulses;
  system.move_before_impulses(h);
  vessel::VesselBlock block = system.begin(loads.front(), h, rest(loads));
  system.finish(given.front(), rest(given));
  return block;
}

/// Linear and angular momentum about G's origin, (P; L), and kinetic energy of all bodies.
struct Totals {
  Vec6 momentum = Vec6::Zero();
  double kinetic = 0;
};
inline Totals totals(const vessel::VesselModel& model, const vessel::VesselSystem& system) {
  Totals sum;
  const auto add = [&](double mass, const Mat3& inertia, const vessel::VesselState& state) {
    const Mat3 R = state.pose.q.toRotationMatrix();
    const Vec3 p = mass * state.v, spin = R * inertia * R.transpose() * state.w;
    sum.momentum.head<3>() += p;
    sum.momentum.tail<3>() += state.pose.p.cross(p) + spin;
    sum.kinetic += 0.5 * p.dot(state.v) + 0.5 * spin.dot(state.w);
  };
  if (!model.fixed) add(model.mass.mass, model.mass.inertia, system.state());
  for (std::size_t k = 0; k < model.parts.size(); ++k)
    add(model.parts[k].mass, model.parts[k].inertia_B, system.parts()[k].state);
  return sum;
}

/// A fixed hull with two hinged bars that swing in its x-z plane; `theta`: of the scheme.
inline vessel::VesselModel double_pendulum(std::optional<double> theta) {
  vessel::VesselModel model;
  model.fixed = true;
  model.theta = theta;
  model.pose_V.p = {3, -1, 2};
  model.pose_V.q = Quat(Eigen::AngleAxisd(0.6, Vec3::UnitZ()));
  vessel::PartModel bar;
  bar.axis_V = Vec3::UnitY();
  bar.mass = 3;
  bar.inertia_B = Vec3(0.2, 0.3, 0.1).asDiagonal();
  bar.in_V.p = {0, 0, -0.4};
  bar.coordinate = 0.9;
  bar.rate = -0.5;
  model.parts.push_back(bar);
  bar.to = 0;
  bar.mass = 2;
  bar.inertia_B = Vec3(0.1, 0.15, 0.07).asDiagonal();
  bar.point_V = {0, 0, -1};
  bar.in_V.p = {0, 0, -1.3};
  bar.coordinate = -0.4;
  bar.rate = 1.5;
  model.parts.push_back(bar);
  return model;
}

/// Rates of (angle 1, angle 2 against bar 1, and their rates) of the double pendulum above: Lagrange's equations in the
/// bars' angles to the vertical, as of any textbook.
inline void double_pendulum_rates(const vessel::VesselModel& model, const VecX& y, VecX& dy) {
  const vessel::PartModel &one = model.parts[0], &two = model.parts[1];
  const double c1 = -one.in_V.p.z(), l = -two.point_V.z(), c2 = -(two.in_V.p.z() - two.point_V.z());
  const double a = y[0], b = y[0] + y[1], da = y[2], db = y[2] + y[3];
  const double coupling = two.mass * l * c2;
  Eigen::Matrix2d mass;
  mass << one.inertia_B(1, 1) + one.mass * c1 * c1 + two.mass * l * l, coupling * std::cos(a - b),
      coupling * std::cos(a - b), two.inertia_B(1, 1) + two.mass * c2 * c2;
  const double joint2 = -two.stiffness * (y[1] - two.rest) - two.damping * y[3];
  const double joint1 = -one.stiffness * (y[0] - one.rest) - one.damping * y[2];
  const Vec2 force(
      joint1 - joint2 - coupling * std::sin(a - b) * db * db - (one.mass * c1 + two.mass * l) * k_gravity * std::sin(a),
      joint2 + coupling * std::sin(a - b) * da * da - two.mass * c2 * k_gravity * std::sin(b));
  const Vec2 acceleration = mass.inverse() * force;
  dy.resize(4);
  dy << y[2], y[3], acceleration[0], acceleration[1] - acceleration[0];
}

}  // namespace nilas::example
