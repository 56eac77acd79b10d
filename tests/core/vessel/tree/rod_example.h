#pragma once
/// Vessels on rods, and the effects of a rod on them.
#include "core/vessel/tree/jointed_tree.h"
#include "core/vessel/tree/rods.h"
#include "tests/core/vessel/tree/jointed_example.h"

namespace nilas::example {

/// A hull whose inertia has no zero entry, on one rod at a point off its centre of mass.
inline vessel::VesselModel on_a_rod(std::optional<double> theta) {
  vessel::VesselModel model = vessel();
  model.theta = theta;
  model.rods.push_back({"tie", -1, model.mass.com + Vec3(0.5, -0.3, 0.2), Vec3(4, 3, 2), std::nullopt});
  return model;
}

/// The chain of jointed_example.h on two rods, one on the hull and one on its slider, at speeds that both allow.
inline vessel::VesselModel chain_on_rods(std::optional<double> theta) {
  vessel::VesselModel model = chain();
  model.theta = theta;
  model.rods.push_back({"fore", -1, model.mass.com + Vec3(1.5, 0.2, -0.1), Vec3(6, 4, 1), std::nullopt});
  model.rods.push_back({"aft", 2, model.parts[2].in_V.p + Vec3(0.1, 0.2, -0.3), Vec3(2, -5, -3), std::nullopt});
  vessel::JointedTree tree(model);
  for (int k = 0; k < 2; ++k) tree.set_rod_length(k, tree.rod_distance(k));
  MatX jacobian = tree.rod_jacobian();
  jacobian.middleCols<3>(7).setZero();  // a ball starts at rest
  const VecX change = jacobian.transpose() * (jacobian * jacobian.transpose()).llt().solve(tree.rod_rates());
  tree.set_speeds(tree.speeds() - change);
  const Vec6 hull = tree.twist(0);
  model.v = hull.head<3>();
  model.w = hull.tail<3>();
  for (std::size_t k = 0; k < model.parts.size(); ++k) {
    const VecX rates = tree.part_rates(static_cast<int>(k));
    if (rates.size() == 1) model.parts[k].rate = rates[0];
  }
  return model;
}

/// The vessel's end of a rod, in G.
inline Vec3 rod_end(const vessel::VesselModel& model, const vessel::VesselSystem& system, std::size_t rod = 0) {
  const vessel::RodModel& one = model.rods[rod];
  if (one.on < 0) return system.state().pose.p + system.state().pose.q * (one.at_V - model.mass.com);
  const auto k = static_cast<std::size_t>(one.on);
  const Pose &in_V = model.parts[k].in_V, &now = system.parts()[k].state.pose;
  return now.p + now.q * (in_V.q.conjugate() * (one.at_V - in_V.p));
}

inline double rod_length(const vessel::VesselModel& model, const vessel::VesselSystem& system, std::size_t rod = 0) {
  return (rod_end(model, system, rod) - model.rods[rod].to_G).norm();
}

/// Kinetic energy and that of the weight.
inline double energy(const vessel::VesselModel& model, const vessel::VesselSystem& system) {
  double sum = totals(model, system).kinetic + k_gravity * model.mass.mass * system.state().pose.p.z();
  for (std::size_t k = 0; k < model.parts.size(); ++k)
    sum += k_gravity * model.parts[k].mass * system.parts()[k].state.pose.p.z();
  return sum;
}

}  // namespace nilas::example
