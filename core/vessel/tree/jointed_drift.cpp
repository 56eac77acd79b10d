#include "core/vessel/tree/jointed_drift.h"

#include "core/vessel/tree/rods.h"

namespace nilas::vessel {

namespace {

constexpr double k_sixth = 1.0 / 6.0;

/// Linear and angular momentum (P; L) of all bodies, L about `point`.
Vec6 total_momentum(const JointedTree& tree, const Vec3& point) {
  Vec6 total = Vec6::Zero();
  for (int b = 0; b < tree.num_bodies(); ++b) {
    const Vec6 momentum = tree.momentum(b);
    total += momentum;
    total.tail<3>() += (tree.pose(b).p - point).cross(momentum.head<3>());
  }
  return total;
}

/// Matrix from the twist (v; w) at `point` of all bodies as one rigid body to their momentum (P; L) about it.
Mat6 locked_inertia(const JointedTree& tree, const Vec3& point) {
  Mat6 inertia = Mat6::Zero();
  for (int b = 0; b < tree.num_bodies(); ++b) {
    Mat6 motion = Mat6::Identity();  // maps the twist at `point` to that of the body
    motion.topRightCorner<3, 3>() = -skew(tree.pose(b).p - point);
    Mat6 mass = Mat6::Zero();
    mass.topLeftCorner<3, 3>() = tree.mass(b) * Mat3::Identity();
    mass.bottomRightCorner<3, 3>() = tree.inertia_G(b);
    inertia += motion.transpose() * mass * motion;
  }
  return inertia;
}

/// Gives all bodies the momentum `wanted` by a rigid motion: changes a free hull's speeds (w; v), which come first, and
/// keeps those of its joints.
void give_momentum(JointedTree& tree, const Vec6& wanted, const Vec3& about) {
  const Vec3 hull = tree.pose(0).p;
  Vec6 lack = wanted - total_momentum(tree, about);
  lack.tail<3>() -= (hull - about).cross(lack.head<3>());  // now about the hull's centre of mass
  const Vec6 twist = locked_inertia(tree, hull).ldlt().solve(lack);
  VecX u = tree.speeds();
  u.head<3>() += twist.tail<3>();
  u.segment<3>(3) += twist.head<3>();
  tree.set_speeds(u);
}

struct Rates {
  VecX q, u;
  VecX tensions;  ///< tensions of the rods
};

Rates rates_of(const JointedTree& tree) {
  const std::vector<Wrench> nothing(static_cast<std::size_t>(tree.num_bodies()));
  Rates rates{tree.coordinate_rates(), accelerations_under(tree, nothing), VecX()};
  if (tree.num_rods() == 0) return rates;
  const HeldByRods held = held_by_rods(tree.mass_matrix(), tree.rod_jacobian(), tree.rod_bias(), rates.u);
  rates.u = held.speeds;
  rates.tensions = held.tensions;
  return rates;
}

/// Impulse of the rods on all bodies over `time`, as a momentum (P; L), L about `point`.
Vec6 given_by_rods(const JointedTree& tree, double time, const VecX& tensions, const Vec3& point) {
  Vec6 given = Vec6::Zero();
  const std::vector<Wrench> loads = tree.rod_loads(tensions);
  for (int b = 0; b < tree.num_bodies(); ++b) {
    const Wrench& load = loads[b];
    given.head<3>() += time * load.force;
    given.tail<3>() += time * (load.torque + (tree.pose(b).p - point).cross(load.force));
  }
  return given;
}

CarriageMotion::State moved(CarriageMotion::State carriage, double time) {
  carriage.p += time * carriage.v;
  carriage.yaw += time * carriage.yaw_rate;
  return carriage;
}

}  // namespace

VecX accelerations_under(const JointedTree& tree, const std::vector<Wrench>& loads) {
  if (tree.num_speeds() == 0) return VecX(0);
  return tree.mass_matrix().llt().solve(tree.force(loads, {}));
}

VecX drift(JointedTree& tree, CarriageMotion::State& carriage, double time, const DriftSample& sample) {
  if (time == 0) return VecX::Zero(tree.num_rods());
  const VecX q = tree.coordinates(), u = tree.speeds();
  const Vec3 about = tree.pose(0).p;
  Vec6 momentum = total_momentum(tree, about);
  const CarriageMotion::State halfway = moved(carriage, 0.5 * time), end = moved(carriage, time);
  const auto place = [&](const CarriageMotion::State& there, const VecX& q_there, const VecX& u_there) {
    tree.set_carriage(there);
    tree.set_coordinates(q_there);
    tree.set_speeds(u_there);
  };
  const auto note = [&](const CarriageMotion::State& there, double weight, const Rates& rates) {
    sample(there, weight * time, rates.u, rates.tensions);
    if (tree.num_rods() > 0) momentum += given_by_rods(tree, weight * time, rates.tensions, about);
  };
  const Rates a = rates_of(tree);
  note(carriage, k_sixth, a);
  place(halfway, q + 0.5 * time * a.q, u + 0.5 * time * a.u);
  const Rates b = rates_of(tree);
  note(halfway, 2 * k_sixth, b);
  place(halfway, q + 0.5 * time * b.q, u + 0.5 * time * b.u);
  const Rates c = rates_of(tree);
  note(halfway, 2 * k_sixth, c);
  place(end, q + time * c.q, u + time * c.u);
  const Rates d = rates_of(tree);
  note(end, k_sixth, d);
  place(end, q + time * k_sixth * (a.q + 2 * b.q + 2 * c.q + d.q),
        u + time * k_sixth * (a.u + 2 * b.u + 2 * c.u + d.u));
  tree.normalise_quaternions();
  if (tree.num_rods() > 0) return_to_lengths(tree);
  if (tree.hull_is_free()) give_momentum(tree, momentum, about);
  carriage = end;
  return tree.num_rods() > 0 ? return_to_rates(tree) : VecX();
}

}  // namespace nilas::vessel
