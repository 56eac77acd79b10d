#include "core/vessel/tree/jointed_rest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/numerics/nonlinear_solve.h"
#include "core/vessel/model/cells.h"
#include "core/vessel/tree/carriage_changes.h"
#include "core/vessel/tree/carried_vessel.h"

namespace nilas::vessel {

namespace {

/// Restoring stiffness of a part below which it counts as zero [share of weight times lever per radian, or weight per
/// length].
constexpr double k_restoring = 1e-6;

/// A speed of the tree: its body, and the scales along it.
struct Along {
  int body = 0;
  bool held = false;      ///< true if cells or a spring hold it
  bool settles = false;   ///< true if held, or balanced by water
  bool left_out = false;  ///< true for a part that no joint holds
  double force = 0;       ///< scale of the force [N, N m]
  double move = 1;        ///< scale of the displacement [m, rad]
};

double lever_of(const PartModel& part) {
  return (part.in_V.p - part.point_V).norm() + std::sqrt(0.5 * part.inertia_B.trace() / part.mass);
}

class RestSearch {
 public:
  RestSearch(JointedTree& tree, const VesselModel& model, const RestModel& rest, const CarriageMotion::State& carriage);
  JointedRest find();

 private:
  void add_hull(const VesselModel& model);
  void add_parts(const VesselModel& model);
  VecX force_at(const VecX& along);
  MatX restored(const std::vector<int>& loose);
  void choose_directions();
  VecX balance(const VecX& start, numerics::NonlinearSolution& found);
  std::optional<int> who_moves(const VecX& along);
  Wrench carried_at(const VecX& along);
  std::vector<Pose> poses() const;

  JointedTree& tree_;
  const RestModel& rest_;
  CarriageMotion::State carriage_;
  VecX placed_;
  std::vector<Along> speeds_;
  std::vector<bool> left_out_;  ///< one entry per body
  double hull_mass_;
  std::optional<int> heave_;    ///< index of the hull's heave speed
  std::optional<int> started_;  ///< index of a body with an initial rate
  MatX directions_;  ///< columns: combinations of speeds, in units of their scales, along which the balance is sought
};

RestSearch::RestSearch(JointedTree& tree, const VesselModel& model, const RestModel& rest,
                       const CarriageMotion::State& carriage)
    : tree_(tree),
      rest_(rest),
      carriage_(stopped(carriage)),
      placed_(tree.coordinates()),
      speeds_(static_cast<std::size_t>(tree.num_speeds())),
      left_out_(static_cast<std::size_t>(tree.num_bodies()), false),
      hull_mass_(model.mass.mass) {
  tree_.set_carriage(carriage_);
  tree_.set_speeds(VecX::Zero(tree.num_speeds()));
  add_hull(model);
  add_parts(model);
  choose_directions();
}

void RestSearch::add_hull(const VesselModel& model) {
  const CarriageModel& carriage = *model.carriage;
  const bool on_cells = carriage.balance == BalanceKind::six_cells;
  const std::vector<int> free = free_axes(carriage);
  MatX stiffness = MatX::Zero(6, 6);
  if (on_cells) stiffness = condensed_stiffness(cell_wrenches(carriage.cells), carriage.stiffness, free);
  const std::vector<int> axes = on_cells ? std::vector<int>{0, 1, 2, 3, 4, 5} : free;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const int axis = axes[i];
    if (axis == k_heave) heave_ = static_cast<int>(i);
    const bool shifts = axis >= k_first_translation;
    Along& along = speeds_[i];
    along.held = stiffness(axis, axis) > 0;
    along.settles = along.held || (rest_.afloat && (axis == k_roll || axis == k_pitch || axis == k_heave));
    along.force = shifts ? rest_.weight : rest_.weight * rest_.length;
    along.move = shifts ? rest_.length : 1;
    if (!along.held) continue;
    if (along.force == 0) along.force = stiffness(axis, axis) * along.move;
    along.move = std::min(along.move, along.force / stiffness(axis, axis));
  }
}

void RestSearch::add_parts(const VesselModel& model) {
  for (std::size_t k = 0; k < model.parts.size(); ++k) {
    const PartModel& part = model.parts[k];
    const int body = static_cast<int>(k) + 1;
    left_out_[k + 1] = part.joint == JointKind::free || left_out_[part.to + 1];
    const auto [first, count] = tree_.speeds_of(body);
    if (part.rate != 0 && !left_out_[k + 1] && !started_) started_ = body;
    const double weight = part.mass * rest_.weight / hull_mass_, lever = lever_of(part);
    for (int i = first; i < first + count; ++i) {
      Along& along = speeds_[i];
      along.body = body;
      along.left_out = left_out_[k + 1];
      along.held = along.settles = part.stiffness > 0 && !along.left_out;
      const bool shifts = part.joint == JointKind::slider;
      along.force = shifts ? weight : weight * lever;
      along.move = shifts ? lever : 1;
      if (along.held && along.force == 0) along.force = part.stiffness * along.move;
    }
  }
}

std::vector<Pose> RestSearch::poses() const {
  std::vector<Pose> poses;
  for (int b = 0; b < tree_.num_bodies(); ++b) poses.push_back(tree_.pose(b));
  return poses;
}

/// Generalised force along the speeds, with the vessel displaced by `along` from its initial place.
VecX RestSearch::force_at(const VecX& along) {
  tree_.set_coordinates(tree_.moved(placed_, along));
  return tree_.force(rest_.loads(poses()), {}) + tree_.cell_force() - tree_.stiffness().cwiseProduct(tree_.stretch());
}

/// Combinations of coordinates without a spring that weight and water restore: columns in units of their scales.
MatX RestSearch::restored(const std::vector<int>& loose) {
  const auto n = static_cast<Eigen::Index>(loose.size());
  constexpr double k_probe = 1e-5;
  MatX stiffness(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    VecX along = VecX::Zero(tree_.num_speeds());
    const int moved = loose[j];
    along[moved] = k_probe * speeds_[moved].move;
    const VecX ahead = force_at(along), behind = force_at(-along);
    for (Eigen::Index i = 0; i < n; ++i) {
      const int felt = loose[i];
      stiffness(i, j) = (behind[felt] - ahead[felt]) / (2 * k_probe) / speeds_[felt].force;
    }
  }
  const Eigen::SelfAdjointEigenSolver<MatX> eigen(0.5 * (stiffness + stiffness.transpose()));
  const Eigen::Index first = (eigen.eigenvalues().array() <= k_restoring).count();
  return eigen.eigenvectors().rightCols(n - first);
}

void RestSearch::choose_directions() {
  std::vector<int> settling, loose;
  for (int i = 0; i < tree_.num_speeds(); ++i) {
    const Along& along = speeds_[i];
    if (along.settles)
      settling.push_back(i);
    else if (along.body > 0 && !along.left_out && along.force > 0)
      loose.push_back(i);
  }
  const auto n = static_cast<Eigen::Index>(settling.size());
  const MatX back = loose.empty() ? MatX(0, 0) : restored(loose);
  directions_ = MatX::Zero(tree_.num_speeds(), n + back.cols());
  for (Eigen::Index j = 0; j < n; ++j) directions_(settling[j], j) = 1;
  if (back.cols() > 0) directions_(loose, Eigen::seqN(n, back.cols())) = back;
}

/// Searches the balance from `start`. Returns the displacement along the speeds.
VecX RestSearch::balance(const VecX& start, numerics::NonlinearSolution& found) {
  VecX force(tree_.num_speeds()), move(tree_.num_speeds());
  for (int i = 0; i < tree_.num_speeds(); ++i) {
    const Along& along = speeds_[i];
    force[i] = along.force > 0 ? along.force : 1;  // a coordinate without scale does not take part
    move[i] = along.move;
  }
  const auto at = [&](const VecX& x) { return VecX(move.cwiseProduct(directions_ * x)); };
  const numerics::NonlinearEquations equations = [&](const VecX& x, VecX& f) {
    f = directions_.transpose() * force_at(at(x)).cwiseQuotient(force);
  };
  found = numerics::solve_nonlinear(equations, directions_.transpose() * start.cwiseQuotient(move));
  return at(found.x);
}

/// The body that moves although the balance was found; empty where everything rests.
std::optional<int> RestSearch::who_moves(const VecX& along) {
  if (started_) return started_;
  const VecX force = force_at(along);
  for (int i = 0; i < tree_.num_speeds(); ++i) {
    const Along& one = speeds_[i];
    if (!one.left_out && !one.held && std::abs(force[i]) > k_unbalanced * one.force) return one.body;
  }
  constexpr double k_probe = 1e-5;
  for (int i = 0; i < tree_.num_speeds(); ++i) {
    const Along& one = speeds_[i];
    if (one.body == 0 || !one.held) continue;
    VecX ahead = along;
    ahead[i] += k_probe * one.move;
    if (force_at(ahead)[i] > force[i]) return one.body;
  }
  return std::nullopt;
}

Wrench RestSearch::carried_at(const VecX& along) {
  tree_.set_coordinates(tree_.moved(placed_, along));
  const std::vector<Pose> where = poses();
  const std::vector<Wrench> loads = rest_.loads(where);
  Wrench carried;
  for (std::size_t b = 0; b < loads.size(); ++b) {
    if (left_out_[b]) continue;
    carried.force -= loads[b].force;
    carried.torque -= loads[b].torque + (where[b].p - carriage_.p).cross(loads[b].force);
  }
  return carried;
}

JointedRest RestSearch::find() {
  VecX along = VecX::Zero(tree_.num_speeds());
  if (directions_.cols() > 0) {
    numerics::NonlinearSolution found;
    along = balance(along, found);
    if (!found.converged && heave_ && rest_.heave != 0) {  // above the water, the forces do not show the direction
      VecX start = VecX::Zero(tree_.num_speeds());
      start[*heave_] = rest_.heave;
      along = balance(start, found);
    }
    if (!found.converged)
      throw InputError(
          fmt::format("the vessel finds no rest on its carriage: {:.1e} of its weight stays unbalanced ({})",
                      found.residual, found.message));
  }
  const std::optional<int> moving = who_moves(along);
  const Wrench carried = carried_at(along);
  return {tree_.moved(placed_, along), moving, carried};
}

}  // namespace

JointedRest jointed_rest(JointedTree& tree, const VesselModel& model, const RestModel& rest,
                         const CarriageMotion::State& carriage) {
  return RestSearch(tree, model, rest, carriage).find();
}

}  // namespace nilas::vessel
