#include "contact/solvers/enumerate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/problem/row_of.h"
#include "contact/solvers/shared/row_residual.h"
#include "core/base/error.h"

namespace nilas::solvers {

namespace {

constexpr int k_most_contacts = 8;
/// Starts tried per combination: impulses against the velocities without any, turned in equal parts.
constexpr int k_directions = 3;
constexpr int k_newton_steps = 30;
/// A step of this share of the impulses has converged.
constexpr double k_newton_accuracy = 1e-15;

enum class State { open, stick, slip, stick_at_limit, slip_at_limit };

/// One combination: the entries of r that it leaves free, and as many equations.
class Combination {
 public:
  Combination(const contact::LocalProblem& problem, const MatX& w, const std::vector<State>& states)
      : problem_(problem), w_(w), states_(states) {
    for (std::size_t c = 0; c < states.size(); ++c) {
      const bool limited = states[c] == State::stick_at_limit || states[c] == State::slip_at_limit;
      const int last = problem.law == Law::frictionless ? 1 : 3;
      for (int i = limited ? 1 : 0; i < last && states[c] != State::open; ++i) free_.push_back(row(c) + i);
    }
  }
  int size() const { return static_cast<int>(free_.size()); }

  /// Newton's method with least-squares steps from impulses `r`; false: it left finite numbers.
  bool solve(VecX& r) const {
    fix(r);
    for (int k = 0; k < k_newton_steps && size() > 0; ++k) {
      VecX value(r.size());
      const MatX jacobian = equations(r, value)(free_, free_);
      const VecX step = jacobian.completeOrthogonalDecomposition().solve(value(free_));
      r(free_) -= step;
      if (!r.allFinite()) return false;
      if (step.norm() <= k_newton_accuracy * r.norm()) break;
    }
    return true;
  }

 private:
  static Eigen::Index row(std::size_t c) { return contact::row_of(c); }

  /// Sets the entries that are not free.
  void fix(VecX& r) const {
    for (std::size_t c = 0; c < states_.size(); ++c) {
      if (states_[c] == State::open) r.segment<3>(row(c)).setZero();
      if (states_[c] == State::stick_at_limit || states_[c] == State::slip_at_limit)
        r[row(c)] = problem_.force_limit[c];
      if (problem_.law == Law::frictionless) r.segment<2>(row(c) + 1).setZero();
    }
  }

  /// Stick: u = 0. Slip: u_N = 0 (ccp: u_N = mu |u_T|) and mu r_N u_T + |u_T| r_T = 0. Returns the slopes by r.
  MatX equations(const VecX& r, VecX& value) const {
    value = w_ * r + problem_.q;
    MatX slopes = w_;
    for (std::size_t c = 0; c < states_.size(); ++c)
      if (states_[c] == State::slip || states_[c] == State::slip_at_limit) slide(c, r, value, slopes);
    return slopes;
  }

  void slide(std::size_t c, const VecX& r, VecX& value, MatX& slopes) const {
    const Eigen::Index n = row(c);
    const double mu = problem_.mu[c];
    const Vec2 u = value.segment<2>(n + 1), friction = r.segment<2>(n + 1);
    const double speed = u.norm();
    const Vec2 along = speed > 0 ? Vec2(u / speed) : Vec2(1, 0);
    const MatX slip_slopes = slopes.middleRows<2>(n + 1);
    if (problem_.law == Law::ccp) {
      value[n] -= mu * speed;
      slopes.row(n) -= mu * along.transpose() * slip_slopes;
    }
    value.segment<2>(n + 1) = mu * r[n] * u + speed * friction;
    slopes.middleRows<2>(n + 1) = mu * r[n] * slip_slopes + friction * (along.transpose() * slip_slopes);
    slopes.block<2, 1>(n + 1, n) += mu * u;
    slopes.block<2, 2>(n + 1, n + 1).diagonal().array() += speed;
  }

  const contact::LocalProblem& problem_;
  const MatX& w_;
  const std::vector<State>& states_;
  std::vector<Eigen::Index> free_;
};

std::vector<State> states_of(const contact::LocalProblem& problem, std::size_t c) {
  const bool friction = problem.law != Law::frictionless && problem.mu[c] > 0;
  const bool limited = std::isfinite(problem.force_limit[c]);
  std::vector<State> states{State::open};
  if (friction || problem.law == Law::frictionless) states.push_back(State::stick);
  if (problem.law != Law::frictionless) states.push_back(State::slip);
  if (limited && (friction || problem.law == Law::frictionless)) states.push_back(State::stick_at_limit);
  if (limited && problem.law != Law::frictionless) states.push_back(State::slip_at_limit);
  return states;
}

/// All combinations, those with more open contacts first.
std::vector<std::vector<State>> combinations(const contact::LocalProblem& problem) {
  std::vector<std::vector<State>> all{{}};
  for (std::size_t c = 0; c < problem.mu.size(); ++c) {
    std::vector<std::vector<State>> longer;
    for (const auto& head : all)
      for (const State state : states_of(problem, c)) {
        longer.push_back(head);
        longer.back().push_back(state);
      }
    all = std::move(longer);
  }
  const auto closed = [](const std::vector<State>& states) {
    return std::count_if(states.begin(), states.end(), [](State state) { return state != State::open; });
  };
  std::stable_sort(all.begin(), all.end(), [&](const auto& one, const auto& two) { return closed(one) < closed(two); });
  return all;
}

MatX dense_matrix(const contact::LocalProblem& problem) {
  MatX w = contact::sparse_matrix(problem);
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const double tangential = problem.tangential_compliance[c];
    w.diagonal().segment<3>(contact::row_of(c)) += Vec3(problem.compliance[c], tangential, tangential);
  }
  return w;
}

class Search {
 public:
  Search(const contact::LocalProblem& problem, double tolerance)
      : problem_(problem), tolerance_(tolerance), w_(dense_matrix(problem)) {
    best_.r = VecX::Zero(problem.q.size());
    best_.status = contact::SolveStatus::stalled;
  }

  contact::ContactSolution run() {
    for (const auto& states : combinations(problem_)) {
      ++best_.iterations;
      const Combination combination(problem_, w_, states);
      const bool linear = std::none_of(states.begin(), states.end(), slides);
      for (int turn = 0; turn < (linear ? 1 : k_directions); ++turn)
        if (try_start(combination, 2 * k_pi * turn / k_directions)) return best_;
    }
    return best_;
  }

 private:
  static bool slides(State state) { return state == State::slip || state == State::slip_at_limit; }

  /// Impulses that would stop each contact alone, with friction against its slip turned by `turn`.
  VecX start(double turn) const {
    VecX r = VecX::Zero(problem_.q.size());
    for (int c = 0; c < problem_.num_contacts(); ++c) {
      const Vec3 q = problem_.q.segment<3>(3 * c);
      const double normal = q.norm() / std::max(w_.block<3, 3>(3 * c, 3 * c).trace() / 3, k_smallest);
      const double angle = std::atan2(q[2], q[1]) + turn, mu = problem_.mu[c];
      r.segment<3>(3 * c) = normal * Vec3(1, -mu * std::cos(angle), -mu * std::sin(angle));
    }
    return r;
  }

  bool try_start(const Combination& combination, double turn) {
    VecX r = start(turn);
    if (!combination.solve(r)) return false;
    const double law_map = contact::measure(problem_, r).law_map_m_s;
    if (law_map < least_) {
      least_ = law_map;
      best_.r = r;
    }
    if (law_map <= tolerance_) best_.status = contact::SolveStatus::converged;
    return law_map <= tolerance_;
  }

  static constexpr double k_smallest = 1e-300;  ///< stands for the inverse mass of what cannot move [1/kg]

  const contact::LocalProblem& problem_;
  double tolerance_;
  MatX w_;
  contact::ContactSolution best_;
  double least_ = std::numeric_limits<double>::infinity();
};

contact::ContactSolution try_all(const contact::LocalProblem& island, double tolerance) {
  contact::ContactSolution solution;
  solution.r = VecX::Zero(island.q.size());
  if (island.num_contacts() > k_most_contacts) {
    solution.message = "solver 'enumerate' knows islands of up to " + std::to_string(k_most_contacts) +
                       " contacts, this one has " + std::to_string(island.num_contacts());
    return solution;
  }
  solution = Search(island, tolerance).run();
  const std::string culprit = find_culprit(island, solution.r, tolerance);
  if (culprit.empty()) return solution;
  solution.status = contact::SolveStatus::numerical_error;
  solution.message = culprit;
  return solution;
}

}  // namespace

void EnumerateSolver::demand_law(Law law) const { demand_known("enumerate", k_cone_laws, law); }

contact::ContactSolution EnumerateSolver::solve_island(const contact::LocalProblem& island, const VecX&,
                                                       const contact::SolverSettings& shared, const Budget&) const {
  return try_all(island, shared.tolerance);
}

}  // namespace nilas::solvers
