#include "contact/solvers/admm.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "contact/law/cone.h"
#include "contact/problem/row_of.h"
#include "contact/solvers/linear/block_cholesky.h"
#include "contact/solvers/shared/anderson.h"
#include "contact/solvers/shared/best_impulses.h"
#include "contact/solvers/shared/mass_scaled.h"
#include "core/base/error.h"

namespace nilas::solvers {

namespace {

/// e as a share of L, and the exponent k: its step, its bounds.
constexpr double k_regularisation = 1e-6;
constexpr double k_exponent_step = 0.05;
constexpr double k_largest_exponent = 1;
/// The penalty moves when one residual is this many times the other.
constexpr double k_imbalance = 10;
/// Iterations between looks at the balance; fewer would judge a penalty before it acts.
constexpr int k_balance_period = 10;
/// Iterations between measurements.
constexpr int k_measure_period = 5;
constexpr int k_power_iterations = 20;
/// Growth of the fixed-point residual that ends an accelerated sequence.
constexpr double k_growth = 2;
/// Plain iterations after that; doubled each time, since acceleration that fails once tends to fail again.
constexpr int k_first_pause = 10;
constexpr double k_fall = 0.9;

/// Largest eigenvalue, from a start that no symmetry of a scene makes orthogonal to it.
double largest_eigenvalue(const Eigen::SparseMatrix<double>& w) {
  VecX v(w.rows());
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = 1 + 0.5 * std::sin(static_cast<double>(i + 1));
  double value = 0;
  for (int k = 0; k < k_power_iterations; ++k) {
    v = w * (v / v.norm());
    value = v.norm();
  }
  return value;
}

VecX project(const MassScaled& problem, const VecX& r) {
  VecX inside(r.size());
  for (int a = 0; a < problem.num_contacts(); ++a)
    inside.segment<3>(contact::row_of(a)) =
        contact::project_cone(r.segment<3>(contact::row_of(a)), problem.mu[a], problem.cap[a]);
  return inside;
}

/// p of the header and what belongs to it.
struct Penalty {
  double largest = 0;   ///< L
  double regular = 0;   ///< e
  double exponent = 0;  ///< k
  double value() const { return std::sqrt(largest * regular) * std::pow(largest / regular, exponent); }
};

/// Moves the exponent towards balance of the residuals. False: they are balanced, or it is at its bound.
bool balance(double primal, double dual, Penalty& penalty) {
  const double before = penalty.exponent;
  if (primal > k_imbalance * dual) penalty.exponent += k_exponent_step;
  if (dual > k_imbalance * primal) penalty.exponent -= k_exponent_step;
  penalty.exponent = std::clamp(penalty.exponent, -k_largest_exponent, k_largest_exponent);
  return penalty.exponent != before;
}

bool factor(const MassScaled& problem, const Penalty& penalty, BlockCholesky& factors) {
  const std::vector<Mat3> unit(problem.num_contacts(), Mat3::Identity());
  const std::vector<Mat3> added(problem.num_contacts(), (penalty.value() + penalty.regular) * Mat3::Identity());
  return factors.factor(unit, added);
}

/// Returns the iterated vector: y followed by z/p.
VecX together(const VecX& y, const VecX& z, double penalty) {
  VecX both(2 * y.size());
  both << y, z / penalty;
  return both;
}

struct Imbalance {
  double primal = 0, dual = 0;
};

/// One iteration on y and z.
Imbalance alternate(const MassScaled& problem, const BlockCholesky& factors, const Penalty& penalty, VecX& y, VecX& z) {
  const double p = penalty.value();
  VecX rhs = (p + penalty.regular) * y - z - problem.q;
  if (problem.law == Law::coulomb) rhs -= de_saxce_shift(problem, z);
  if (problem.skew) rhs -= problem.w * y - problem.symmetric * y;
  const VecX x = factors.solve_unrefined(rhs);
  const VecX next = project(problem, x + z / p);
  const Imbalance residuals{(x - next).cwiseAbs().maxCoeff(), p * (next - y).cwiseAbs().maxCoeff()};
  z += p * (x - next);
  y = next;
  return residuals;
}

/// Anderson acceleration that stops for a number of plain iterations when the residual grows, twice as many each time.
class GuardedMixer {
 public:
  explicit GuardedMixer(int depth) : mixer_(depth), off_(depth == 0) {}

  void restart() {
    mixer_.restart();
    least_ = std::numeric_limits<double>::infinity();
  }

  /// Returns the state to continue from after `iteration` led from `before` to `after`; empty: from `after` itself.
  std::optional<VecX> next(const VecX& before, const VecX& after, int iteration) {
    if (off_ || iteration < plain_until_) return std::nullopt;
    const double residual = (after - before).norm();
    if (residual > k_growth * least_) {
      restart();
      plain_until_ = iteration + pause_;
      pause_ *= 2;
      return least_state_;
    }
    if (residual < least_) {
      least_ = residual;
      least_state_ = after;
    }
    return mixer_.next(before, after);
  }

 private:
  Anderson mixer_;
  bool off_;
  double least_ = std::numeric_limits<double>::infinity();
  VecX least_state_;
  int plain_until_ = 0, pause_ = k_first_pause;
};

/// AdmmSettings::least_fall: the last two residuals measured.
struct LastTwo {
  double last = std::numeric_limits<double>::infinity(), before_last = last;

  bool fell_too_little(double residual, double least_fall) {
    const bool slow = least_fall > 0 && !(residual <= least_fall * before_last);
    before_last = std::exchange(last, residual);
    return slow;
  }
};

constexpr const char* k_indefinite = "admm: W and the penalty together are not positive definite";

contact::ContactSolution alternate_to_tolerance(const contact::LocalProblem& island, const VecX& guess,
                                                const AdmmSettings& settings, const contact::SolverSettings& shared,
                                                const Budget& budget) {
  const MassScaled problem = mass_scaled(island);
  BlockCholesky factors(problem.symmetric);
  BestImpulses best(shared.tolerance, budget, {settings.stall_iterations, k_fall});
  LastTwo last_two;
  const auto offer = [&](const VecX& scaled) {
    const VecX r = problem.impulses(scaled);
    const double residual = contact::measure(island, r).law_map_m_s;
    if (shared.keep_history) best.note(residual);
    best.offer(r, residual);
    if (last_two.fell_too_little(residual, settings.least_fall)) best.stall();
  };

  VecX y = guess.size() > 0 ? project(problem, problem.scaled_impulses(guess)) : VecX(VecX::Zero(problem.q.size()));
  VecX z = VecX::Zero(y.size());
  offer(y);
  if (!best.has_any()) offer(y.setZero());  // the guess is beyond all numbers
  if (!best.has_any()) best.fail("admm: even impulses of zero have a residual beyond all numbers");

  Penalty penalty{0, 0, settings.first_exponent};
  if (best.goes_on()) {
    penalty.largest = largest_eigenvalue(problem.symmetric);
    penalty.regular = k_regularisation * penalty.largest;
    if (!factor(problem, penalty, factors)) best.fail(k_indefinite);
  }
  GuardedMixer mixer(settings.anderson_depth);
  const int period = settings.least_fall > 0 ? 1 : k_measure_period;
  while (best.goes_on()) {
    const VecX before = together(y, z, penalty.value());
    const Imbalance residuals = alternate(problem, factors, penalty, y, z);
    best.spend();
    if (best.iterations() % period == 0 || best.iterations() == budget.iterations()) offer(y);
    const VecX after = together(y, z, penalty.value());
    if (!after.allFinite()) {
      best.fail("admm: the impulses grew beyond all numbers");
    } else if (best.iterations() % k_balance_period == 0 && balance(residuals.primal, residuals.dual, penalty)) {
      if (!factor(problem, penalty, factors)) best.fail(k_indefinite);
      mixer.restart();
    } else if (const auto state = mixer.next(before, after, best.iterations())) {
      y = state->head(y.size());
      z = penalty.value() * state->tail(y.size());
    }
  }
  contact::ContactSolution solution = std::move(best).solution();
  if (solution.r.size() == 0) solution.r = VecX::Zero(island.q.size());
  return solution;
}

}  // namespace

void AdmmSolver::demand_law(Law law) const { demand_known("admm", k_cone_laws, law); }

contact::ContactSolution AdmmSolver::solve_island(const contact::LocalProblem& island, const VecX& guess,
                                                  const contact::SolverSettings& shared, const Budget& budget) const {
  if (const auto still = solve_immovable(island)) return *still;
  return alternate_to_tolerance(island, guess, settings_, shared, budget);
}

}  // namespace nilas::solvers
