#include "contact/position_correction.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "contact/problem/islands.h"
#include "contact/problem/operators.h"
#include "contact/problem/prepared_problem.h"
#include "contact/problem/row_of.h"
#include "contact/solvers/body_ladder.h"
#include "contact/solvers/newton.h"
#include "contact/solvers/newton_order_free.h"
#include "core/base/error.h"

namespace nilas::contact {

namespace {

/// The step's contact graph without immovable bodies and without points that crush or are elastic, where bodies may
/// overlap.
ContactProblem movable_graph(const AssembledContacts& contacts, const std::vector<detect::ContactPoint>& points) {
  ContactProblem graph;
  graph.block_offset = contacts.problem.block_offset;
  graph.pairs = contacts.problem.pairs;
  graph.pairs.resize(static_cast<std::size_t>(contacts.problem.num_points()));  // moments follow the points
  for (auto& pair : graph.pairs) {
    if (pair.a >= contacts.first_articulated_block) pair.a = -1;
    if (pair.b >= contacts.first_articulated_block) pair.b = -1;
  }
  for (std::size_t c = 0; c < points.size(); ++c)
    if (points[c].crushes() || contacts.is_elastic(c)) graph.pairs[c] = {};
  return graph;
}

/// The groups that have a movable body and a depth above `smallest` [m].
std::vector<std::vector<int>> groups_to_correct(const ContactProblem& graph,
                                                const std::vector<detect::ContactPoint>& points, double smallest) {
  const auto is_deep = [&](const detect::ContactPoint& c) { return -c.gap > smallest; };
  if (std::none_of(points.begin(), points.end(), is_deep)) return {};
  auto groups = find_islands(graph);
  std::erase_if(groups, [&](const std::vector<int>& group) {
    const auto& first = graph.pairs[group.front()];
    return (first.a < 0 && first.b < 0) ||
           std::none_of(group.begin(), group.end(), [&](int c) { return is_deep(points[c]); });
  });
  return groups;
}

double least_speed(const detect::ContactPoint& point, const CorrectionSettings& settings) {
  const double depth = -point.gap;
  if (depth < 0) return depth / settings.h;
  if (depth <= settings.slop) return 0;
  return std::min(settings.erp * (depth - settings.slop) / settings.h, settings.max_speed);  // NaN for a NaN
}

constexpr int k_size = 6;  ///< number of velocities of a rigid body's block

/// The normal row of one contact on the mass-scaled velocities of its two bodies. The row of an immovable side is zero.
struct NormalRow {
  Vec6 a = Vec6::Zero(), b = Vec6::Zero();
  double w = 0;      ///< W_NN [1/kg]
  double least = 0;  ///< required speed of separation [m/s]
  double r = 0;      ///< [N s]
  int first_a = 0, first_b = 0;
};

/// Solves for the motion of one group, starting from rest.
class GroupCorrection {
 public:
  /// `z`: mass-scaled velocities of all blocks, followed by six entries that stay zero and stand for an immovable side.
  GroupCorrection(const ContactProblem& step, const MassInverse& masses, VecX& z)
      : step_(step), masses_(masses), z_(z) {}

  void add(int c, const ContactProblem::Pair& pair, double least) {
    NormalRow row;
    row.first_a = place(pair.a, step_.jacobian_a(c).data(), row.a);
    row.first_b = place(pair.b, step_.jacobian_b(c).data(), row.b);
    row.w = row.a.squaredNorm() + row.b.squaredNorm();
    row.least = least;
    rows_.push_back(row);
  }

  /// Sweeps once over all rows and returns the largest |dr| W [m/s].
  double sweep() {
    double largest = 0;
    for (NormalRow& row : rows_) {
      auto z_a = z_.segment<k_size>(row.first_a), z_b = z_.segment<k_size>(row.first_b);
      const double lack = row.least - (row.a.cwiseProduct(z_a) + row.b.cwiseProduct(z_b)).sum();
      const double change = std::max(lack / row.w, -row.r);
      if (change == 0) continue;
      row.r += change;
      z_a += change * row.a;
      z_b += change * row.b;
      if (!(std::abs(change) * row.w <= largest)) largest = std::abs(change) * row.w;  // a NaN stays
    }
    return largest;
  }

  /// Returns the largest |min(W r, u_N - least)|, the natural-map residual of the normal direction [m/s].
  double residual() const {
    double worst = 0;
    for (const NormalRow& row : rows_) {
      const double excess =
          row.a.dot(z_.segment<k_size>(row.first_a)) + row.b.dot(z_.segment<k_size>(row.first_b)) - row.least;
      const double map = std::abs(std::min(row.w * row.r, excess));
      if (!(map <= worst)) worst = map;
    }
    return worst;
  }

  double impulse(std::size_t place) const { return rows_[place].r; }

 private:
  int place(int block, const double* jacobian, Vec6& row) const {
    if (block < 0) return static_cast<int>(z_.size()) - k_size;
    NILAS_DEMAND(step_.block_size(block) == k_size && masses_.has_root(block));
    masses_.apply_root(block, jacobian, row.data());
    return step_.block_offset[block];
  }

  const ContactProblem& step_;
  const MassInverse& masses_;
  VecX& z_;
  std::vector<NormalRow> rows_;
};

/// The normal rows of the groups as a problem of their own: M v = H r and 0 <= u_N - least, perpendicular to r_N >= 0.
/// It covers the free bodies of the step's problem, whose blocks come first.
ContactProblem correction_problem(const AssembledContacts& contacts, const ContactProblem& graph,
                                  const std::vector<std::vector<int>>& groups,
                                  const std::vector<detect::ContactPoint>& points, const CorrectionSettings& settings) {
  const ContactProblem& step = contacts.problem;
  ContactProblem own;
  own.h = step.h;
  own.law = Law::frictionless;
  for (int k = 0; k < contacts.first_articulated_block; ++k) own.add_block(step.mass(k));
  const MatX none(3, 0);
  for (const auto& group : groups)
    for (const int c : group) {
      const auto i = static_cast<std::size_t>(c);
      const auto& pair = graph.pairs[i];
      const MatX a = pair.a < 0 ? none : MatX(step.jacobian_a(c)), b = pair.b < 0 ? none : MatX(step.jacobian_b(c));
      const int row = own.add_contact(pair.a, a, pair.b, b, step.key[i]);
      own.w[row_of(row)] = -least_speed(points[i], settings);
    }
  return own;
}

/// Most factorisations for one group: from the impulses of the sweeps newton takes one to three, rarely twenty.
constexpr int k_most_factorisations = 40;
/// Points of a group from which on it is finished on its bodies. A field of 1000 floes that touch on all sides takes
/// 0.3 s there and 15 s by newton, whose W has a block for every two points of a body.
constexpr int k_large_group = 300;
/// Most iterations there; such fields take three to six.
constexpr int k_most_on_bodies = 100;
/// Points of a group from which on newton on W is not tried after that.
constexpr int k_too_large_for_w = 3000;

/// Finishes the groups that the sweeps leave short.
class GroupFinish {
 public:
  GroupFinish(const AssembledContacts& contacts, const ContactProblem& graph,
              const std::vector<std::vector<int>>& groups, const std::vector<detect::ContactPoint>& points,
              const CorrectionSettings& settings)
      : contacts_(contacts), graph_(graph), groups_(groups), points_(points), settings_(settings) {}

  /// Continues from the impulses of the sweeps. Keeps them where it ends above the tolerance too, as with overlaps
  /// between bodies that cannot part. Returns whether it reached the tolerance.
  bool run(std::size_t place, VecX& impulses) {
    const std::vector<int>& group = groups_[place];
    const ContactProblem own = problem_of(place);
    VecX guess = VecX::Zero(row_of(own.num_contacts()));
    for (std::size_t k = 0; k < group.size(); ++k) guess[row_of(k)] = impulses[row_of(group[k])];
    const std::optional<VecX> found = solve(own, guess);
    if (!found) return false;
    for (std::size_t k = 0; k < group.size(); ++k) impulses[row_of(group[k])] = (*found)[row_of(k)];
    return true;
  }

 private:
  /// The problem of all groups is made when the first of them is short.
  ContactProblem problem_of(std::size_t place) {
    if (!all_) {
      all_.emplace(correction_problem(contacts_, graph_, groups_, points_, settings_));
      for (const auto& group : groups_) first_.push_back(first_.back() + static_cast<int>(group.size()));
    }
    std::vector<int> rows(groups_[place].size());
    std::iota(rows.begin(), rows.end(), first_[place]);
    return select(*all_, rows);
  }

  std::optional<VecX> solve(const ContactProblem& own, const VecX& guess) const {
    const PreparedProblem prepared(own);
    if (own.num_contacts() >= k_large_group) {
      const SolverSettings shared{.tolerance = settings_.tolerance, .max_iterations = k_most_on_bodies};
      const auto found = solvers::solve_on_bodies(prepared, guess, shared, solvers::Budget(shared));
      if (found && found->has_converged) return found->r;
      if (own.num_contacts() >= k_too_large_for_w) return {};
    }
    solvers::NewtonSettings newton;
    newton.shared.tolerance = settings_.tolerance;
    newton.max_factorisations = k_most_factorisations;
    const ContactSolution solution = solvers::NewtonSolver(newton).solve(prepared, guess);
    return solution.status == SolveStatus::converged ? std::optional(solution.r) : std::nullopt;
  }

  const AssembledContacts& contacts_;
  const ContactProblem& graph_;
  const std::vector<std::vector<int>>& groups_;
  const std::vector<detect::ContactPoint>& points_;
  const CorrectionSettings& settings_;
  std::optional<ContactProblem> all_;
  std::vector<int> first_ = {0};  ///< first row of each group in it
};

PositionCorrection order_free_correction(const AssembledContacts& contacts, const ContactProblem& graph,
                                         const std::vector<std::vector<int>>& groups,
                                         const std::vector<detect::ContactPoint>& points,
                                         const CorrectionSettings& settings) {
  const ContactProblem own = correction_problem(contacts, graph, groups, points, settings);
  SolverSettings shared;
  shared.tolerance = settings.tolerance;
  shared.max_iterations = settings.max_sweeps;
  const ContactSolution solution = solvers::OrderFreeNewtonSolver(shared).solve(own, {});
  PositionCorrection out;
  out.v = VecX::Zero(contacts.problem.num_velocities());
  out.v.head(own.num_velocities()) = solution.v;
  out.contacts = own.num_contacts();
  out.converged = solution.status == SolveStatus::converged;
  out.sweeps = solution.iterations;
  return out;
}

}  // namespace

PositionCorrection position_correction(const AssembledContacts& contacts,
                                       const std::vector<detect::ContactPoint>& points,
                                       const CorrectionSettings& settings) {
  const ContactProblem& step = contacts.problem;
  NILAS_DEMAND(settings.h > 0 && points.size() == static_cast<std::size_t>(step.num_points()));
  PositionCorrection out;
  out.v = VecX::Zero(step.num_velocities());
  const ContactProblem graph = movable_graph(contacts, points);
  // a speed below the tolerance is already reached at rest
  const double smallest = settings.slop + settings.tolerance * settings.h / settings.erp;
  const auto groups = settings.erp > 0 ? groups_to_correct(graph, points, smallest) : std::vector<std::vector<int>>{};
  if (groups.empty()) return out;
  if (settings.order_free) return order_free_correction(contacts, graph, groups, points, settings);

  const MassInverse masses(step);
  VecX z = VecX::Zero(step.num_velocities() + k_size);
  VecX impulses = VecX::Zero(row_of(step.num_contacts()));
  GroupFinish finish(contacts, graph, groups, points, settings);
  for (std::size_t place = 0; place < groups.size(); ++place) {
    const std::vector<int>& group = groups[place];
    GroupCorrection correction(step, masses, z);
    for (const int c : group) {
      const auto i = static_cast<std::size_t>(c);
      correction.add(c, graph.pairs[i], least_speed(points[i], settings));
    }
    int sweeps = 0;
    bool converged = false;
    while (!converged && sweeps < settings.max_sweeps) {
      ++sweeps;
      converged = correction.sweep() <= settings.tolerance && correction.residual() <= settings.tolerance;
    }
    out.contacts += static_cast<int>(group.size());
    out.sweeps = std::max(out.sweeps, sweeps);
    for (std::size_t k = 0; k < group.size(); ++k) impulses[row_of(group[k])] = correction.impulse(k);
    const bool finished = !converged && settings.finish && finish.run(place, impulses);
    out.finished += finished ? 1 : 0;
    out.converged = out.converged && (converged || finished);
  }
  // v = M^-1 H r of the free bodies follows from the impulses alone, without the rounding of the sweeps
  for (int c = 0; c < step.num_contacts(); ++c)
    if (impulses[row_of(c)] > 0) add_impulse(step, c, impulses.segment<3>(row_of(c)), out.v.data());
  for (int k = 0; k < contacts.first_articulated_block; ++k) {
    double* const block = out.v.data() + step.block_offset[k];
    masses.apply(k, block, block);
  }
  out.v.tail(step.num_velocities() - step.block_offset[contacts.first_articulated_block]).setZero();
  return out;
}

PositionCorrection correction_velocities(const AssembledContacts& contacts,
                                         const std::vector<detect::ContactPoint>& points,
                                         const CorrectionSettings& settings, std::vector<Vec3>& v,
                                         std::vector<Vec3>& w) {
  NILAS_DEMAND(v.size() == contacts.block_of_body.size() && w.size() == contacts.block_of_body.size());
  PositionCorrection out = position_correction(contacts, points, settings);
  for (std::size_t body = 0; body < contacts.block_of_body.size(); ++body) {
    const int block = contacts.block_of_body[body];
    if (block < 0 || block >= contacts.first_articulated_block) continue;
    const int first = contacts.problem.block_offset[block];
    v[body] = out.v.segment<3>(first);
    w[body] = out.v.segment<3>(first + 3);
  }
  return out;
}

}  // namespace nilas::contact
