#include "core/vessel/tree/rods.h"

#include <fmt/format.h>

#include <cmath>

namespace nilas::vessel {

namespace {

/// Distance of two ends below which their direction is undefined [length units of the model].
constexpr double k_shortest = 1e-6;
/// Largest difference between a given length and the distance of the placed ends; the start is moved onto the length
/// [length units of the model].
constexpr double k_length_tolerance = 5e-3;
/// Largest initial speed along a rod as a share of its end's speed, to admit rounded numbers in a scene.
constexpr double k_rate_tolerance = 1e-3;
/// Share of a free body's compliance below which a rod holds nothing. It is sine^2 of 3e-5 rad from a dead point.
constexpr double k_idle = 1e-9;

MatX response(const MatX& mass, const MatX& jacobian) { return mass.llt().solve(jacobian.transpose()); }

/// The first rod whose length error exceeds `share` of (its length + one length unit); empty if none.
std::optional<int> rod_off(const JointedTree& tree, const VecX& errors, double share) {
  for (int k = 0; k < errors.size(); ++k)
    if (!(std::abs(errors[k]) <= share * (tree.length_unit() + tree.rod_distance(k)))) return k;
  return std::nullopt;
}

JointedTree placed(const VesselModel& model, double t0) {
  JointedTree tree(model);
  if (model.carriage) tree.set_carriage(model.carriage->motion.at(t0));
  return tree;
}

std::optional<RodFault> length_fault(const VesselModel& model, const JointedTree& tree) {
  for (int k = 0; k < tree.num_rods(); ++k) {
    const double distance = tree.rod_distance(k);
    if (!(distance > k_shortest * model.length_unit))
      return RodFault{k, "both its ends are at one point; allowed: a length > 0 m"};
    const double length = model.rods[k].length.value_or(distance), allowed = k_length_tolerance * model.length_unit;
    if (std::abs(length - distance) > allowed)
      return RodFault{k,
                      fmt::format("its length is {:g} m, but its ends are placed {:.6g} m apart; allowed: within {:g} "
                                  "m of that, or no length=",
                                  length, distance, allowed)};
  }
  return std::nullopt;
}

/// The fault of initial speeds that the rods do not allow. Only for given speeds: those on a carriage follow from its
/// own.
std::optional<RodFault> start_fault(const VesselModel& model, const JointedTree& tree) {
  if (model.carriage) return std::nullopt;
  const VecX rates = tree.rod_rates();
  for (int k = 0; k < tree.num_rods(); ++k) {
    const RodModel& rod = model.rods[k];
    const Vec6 twist = tree.twist(rod.on + 1);
    const double fastest =
        twist.head<3>().norm() + twist.tail<3>().norm() * (rod.to_G - tree.pose(rod.on + 1).p).norm();
    if (std::abs(rates[k]) > k_rate_tolerance * fastest)
      return RodFault{k, fmt::format("at the start the vessel would stretch it at {:.3g} m/s; allowed: speeds at "
                                     "which its length stays",
                                     rates[k])};
  }
  return std::nullopt;
}

}  // namespace

HeldByRods held_by_rods(const MatX& mass, const MatX& jacobian, const VecX& imposed, const VecX& free) {
  if (free.size() == 0) return {free, VecX::Zero(jacobian.rows())};
  const MatX by_tension = response(mass, jacobian);
  HeldByRods held;
  const MatX compliance = jacobian * by_tension;
  held.tensions = compliance.llt().solve(jacobian * free + imposed);
  held.speeds = free - by_tension * held.tensions;
  return held;
}

bool obey_with(const MatX& jacobian, const std::vector<int>& some) {
  constexpr double k_idle = 1e-6;  // share of the motion of the rod that they move most
  if (static_cast<Eigen::Index>(some.size()) < jacobian.rows()) return false;
  Eigen::ColPivHouseholderQR<MatX> factors;
  factors.setThreshold(k_idle);
  factors.compute(MatX(jacobian(Eigen::all, some)).transpose());
  return factors.rank() == jacobian.rows();
}

VesselBlock block_on_rods(const VesselBlock& block, const MatX& jacobian, const VecX& imposed) {
  const Eigen::Index rods = jacobian.rows(), left = jacobian.cols() - rods;
  const Eigen::HouseholderQR<MatX> factors(jacobian.transpose());
  const MatX all = factors.householderQ() * MatX::Identity(jacobian.cols(), jacobian.cols());
  const MatX basis = all.rightCols(left);
  // jacobian^T = Q R, so that R^T (first columns of Q)^T speeds = -imposed
  const MatX upper = factors.matrixQR().topRows(rods);
  const VecX along = upper.triangularView<Eigen::Upper>().transpose().solve(-imposed);
  const VecX given = all.leftCols(rods) * along;
  const auto seen = [&](const BodyTwist& twist) -> BodyTwist {
    return {twist.jacobian * basis, twist.prescribed + twist.jacobian * given};
  };
  VesselBlock reduced;
  const MatX mass = basis.transpose() * block.mass * basis;
  reduced.mass = 0.5 * (mass + mass.transpose());
  reduced.f = basis.transpose() * (block.f - block.mass * given);
  reduced.hull = seen(block.hull);
  for (const BodyTwist& part : block.parts) reduced.parts.push_back(seen(part));
  return reduced;
}

void return_to_lengths(JointedTree& tree) {
  constexpr double k_rounding = 4e-16;
  constexpr int k_most = 8;  // Newton: quadratic convergence reaches rounding in two steps
  for (int k = 0; k < k_most; ++k) {
    const VecX errors = tree.rod_errors();
    if (!rod_off(tree, errors, k_rounding)) return;
    tree.displace(held_by_rods(tree.mass_matrix(), tree.rod_jacobian(), errors, VecX::Zero(tree.num_speeds())).speeds);
  }
}

VecX return_to_rates(JointedTree& tree) {
  const VecX u = tree.speeds();
  const MatX jacobian = tree.rod_jacobian();
  const VecX imposed = tree.rod_rates() - jacobian * u;
  const HeldByRods held = held_by_rods(tree.mass_matrix(), jacobian, imposed, u);
  tree.set_speeds(held.speeds);
  return held.tensions;
}

std::optional<int> failed_rod(const JointedTree& tree, const std::vector<RodModel>& rods) {
  constexpr double k_lost = 1e-9;
  if (const auto off = rod_off(tree, tree.rod_errors(), k_lost)) return off;
  return idle_rod(tree, rods);
}

std::optional<int> idle_rod(const JointedTree& tree, const std::vector<RodModel>& rods) {
  const MatX jacobian = tree.rod_jacobian();
  if (jacobian.cols() == 0) return jacobian.rows() > 0 ? std::optional<int>(0) : std::nullopt;
  const MatX compliance = jacobian * response(tree.mass_matrix(), jacobian);
  // Cholesky factorisation row by row. A pivot relative to its diagonal is the share that the earlier rods leave free.
  MatX factor = MatX::Zero(compliance.rows(), compliance.cols());
  for (int i = 0; i < compliance.rows(); ++i) {
    const double whole = compliance(i, i);
    if (!(whole * tree.mass(rods[i].on + 1) > k_idle)) return i;
    for (int j = 0; j <= i; ++j) {
      const double rest = compliance(i, j) - factor.row(i).head(j).dot(factor.row(j).head(j));
      if (j == i && !(rest > k_idle * whole)) return i;
      factor(i, j) = j == i ? std::sqrt(rest) : rest / factor(j, j);
    }
  }
  return std::nullopt;
}

void start_on_rods(const VesselModel& model, JointedTree& tree) {
  for (int k = 0; k < tree.num_rods(); ++k) tree.set_rod_length(k, model.rods[k].length.value_or(tree.rod_distance(k)));
  return_to_lengths(tree);
  return_to_rates(tree);
}

std::optional<RodFault> rod_fault(const VesselModel& model, double t0) {
  JointedTree tree = placed(model, t0);
  if (const auto fault = length_fault(model, tree)) return fault;
  for (int k = 0; k < tree.num_rods(); ++k) tree.set_rod_length(k, tree.rod_distance(k));
  if (const auto idle = idle_rod(tree, model.rods))
    return RodFault{*idle,
                    "it holds nothing: hull, joints, carriage and the rods before it leave no motion along it; "
                    "allowed: rods along which what they hold can move, each in a way of its own"};
  return start_fault(model, tree);
}

}  // namespace nilas::vessel
