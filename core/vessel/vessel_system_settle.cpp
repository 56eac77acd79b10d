/// Searches the vessel's rest on its carriage, where cells, weight and buoyancy balance, and the carriage's load there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/numerics/nonlinear_solve.h"
#include "core/vessel/tree/carriage_changes.h"
#include "core/vessel/tree/carried_vessel.h"

namespace nilas::vessel {

std::vector<int> CarriedVessel::settling_coordinates(bool afloat) const {
  std::vector<int> settling;
  for (int i = 0; i < tree_.size(); ++i) {
    const bool held = std::find(free_coordinates_.begin(), free_coordinates_.end(), i) == free_coordinates_.end();
    const int axis = axes_[i];
    if (held || (afloat && (axis == k_roll || axis == k_pitch || axis == k_heave))) settling.push_back(i);
  }
  return settling;
}

VecX CarriedVessel::static_force(const RestModel& rest, const VecX& q) {
  tree_.set_coordinates(q);
  tree_.set_carriage(stopped(now_));
  tree_.set_speeds(VecX::Zero(tree_.size()));
  return tree_.force(rest.loads({tree_.pose()}).front(), {}) + tree_.cell_force();
}

VecX CarriedVessel::equilibrium(const RestModel& rest) {
  const std::vector<int> settling = settling_coordinates(rest.afloat);
  const auto n = static_cast<Eigen::Index>(settling.size());
  if (n == 0) return q_;
  // Scales: one unit is a large force and a large displacement; for held coordinates the deflection under the weight.
  VecX force(n), move(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const int i = settling[k];
    const bool shifts = axes_[i] >= k_first_translation;
    force[k] = shifts ? rest.weight : rest.weight * rest.length;
    move[k] = shifts ? rest.length : 1;
    if (stiffness_(i, i) > 0) move[k] = std::min(move[k], force[k] / stiffness_(i, i));
  }
  const auto at = [&](const VecX& x) {
    VecX q = q_;
    q(settling) += VecX(move.cwiseProduct(x));
    return q;
  };
  const numerics::NonlinearEquations balance = [&](const VecX& x, VecX& f) {
    f = static_force(rest, at(x))(settling).cwiseQuotient(force);
  };
  numerics::NonlinearSolution found = numerics::solve_nonlinear(balance, VecX::Zero(n));
  if (!found.converged && rest.heave != 0) {  // above the water, the forces do not show the direction
    VecX start = VecX::Zero(n);
    for (Eigen::Index k = 0; k < n; ++k)
      if (axes_[settling[k]] == k_heave) start[k] = rest.heave / move[k];
    found = numerics::solve_nonlinear(balance, start);
  }
  if (!found.converged)
    throw InputError(fmt::format("the vessel finds no rest on its carriage: {:.1e} of its weight stays unbalanced ({})",
                                 found.residual, found.message));
  return at(found.x);
}

VesselRest CarriedVessel::settle(const RestModel& rest, bool start_there) {
  NILAS_DEMAND(h_ == 0);
  if (rest.weight == 0) return {CarriageLoads{}, {}};
  const VecX q = [&] {
    try {
      return equilibrium(rest);
    } catch (...) {
      place(now_, u_);  // the search left the tree where it failed
      throw;
    }
  }();
  const VecX left = static_force(rest, q);
  bool rests = true;
  for (const int i : free_coordinates_) {
    const double lever = axes_[i] < k_first_translation ? rest.length : 1;
    rests = rests && std::abs(left[i]) <= k_unbalanced * rest.weight * lever;
  }
  // The tree is at q: the carriage balances all loads there.
  const Pose pose = tree_.pose();
  const Wrench load = rest.loads({pose}).front();
  Vec6 reaction = Vec6::Zero();
  reaction.head<3>() -= load.force;
  reaction.tail<3>() -= load.torque;
  const CarriageLoads before = loads_;
  read_loads(reaction, pose.p, now_);
  const CarriageLoads carried = loads_;
  const bool moves = rests && start_there;
  if (moves)
    q_ = q;
  else
    loads_ = before;
  place(now_, u_);
  if (!rests) return {};
  return {carried, {}};
}

}  // namespace nilas::vessel
