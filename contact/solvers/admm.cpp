#include "contact/solvers/admm.h"

#include <algorithm>
#include <cmath>

#include "contact/law/cone.h"
#include "contact/solvers/linear/block_cholesky.h"
#include "contact/solvers/shared/anderson.h"
#include "contact/solvers/shared/mass_scaled.h"
#include "core/base/error.h"

namespace nilas {

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

std::size_t at(int i) { return static_cast<std::size_t>(i); }
Eigen::Index row_of(int c) { return 3 * static_cast<Eigen::Index>(c); }

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

/// One island.
class Alternation {
 public:
  Alternation(const LocalProblem& island, const AdmmSettings& settings)
      : island_(island),
        settings_(settings),
        problem_(mass_scaled(island)),
        factor_(problem_.symmetric),
        exponent_(settings.first_exponent) {}

  ContactSolution run(const VecX& guess) {
    y_ = guess.size() > 0 ? project(problem_.scaled_impulses(guess)) : VecX(VecX::Zero(problem_.q.size()));
    out_.status = SolveStatus::iteration_limit;
    best_ = y_;
    offer(y_);
    if (!std::isfinite(best_map_)) start_from_nothing();
    if (out_.status == SolveStatus::iteration_limit) iterate();
    out_.r = problem_.impulses(best_);
    return out_;
  }

 private:
  /// The guess is beyond all numbers.
  void start_from_nothing() {
    y_.setZero();
    best_ = y_;
    offer(y_);
    if (!std::isfinite(best_map_)) fail("even impulses of zero have a residual beyond all numbers");
  }

  void fail(const std::string& why) {
    out_.status = SolveStatus::numerical_error;
    out_.message = "admm: " + why;
  }

  void fail_to_factorise() { fail("W and the penalty together are not positive definite"); }

  VecX project(const VecX& r) const {
    VecX inside(r.size());
    for (int a = 0; a < problem_.num_contacts(); ++a)
      inside.segment<3>(row_of(a)) = project_cone(r.segment<3>(row_of(a)), problem_.mu[at(a)], problem_.cap[at(a)]);
    return inside;
  }

  /// Keeps r' if it measures best; a look that finds no progress for long ends the run.
  void offer(const VecX& scaled) {
    const double map = measure(island_, problem_.impulses(scaled)).law_map_m_s;
    if (settings_.shared.keep_history) out_.history.push_back(map);
    if (map < best_map_) {
      best_map_ = map;
      best_ = scaled;
    }
    if (map < k_fall * fallen_map_) {
      fallen_map_ = map;
      fallen_iteration_ = out_.iterations;
    }
    const bool slow = settings_.least_fall > 0 && !(map <= settings_.least_fall * map_before_last_);
    map_before_last_ = last_map_;
    last_map_ = map;
    if (slow) out_.status = SolveStatus::stalled;
    if (settings_.shared.tolerance <= 0) return;
    if (out_.iterations - fallen_iteration_ >= settings_.stall_iterations) out_.status = SolveStatus::stalled;
    if (best_map_ <= settings_.shared.tolerance) out_.status = SolveStatus::converged;
  }

  bool set_penalty() {
    penalty_ = std::sqrt(largest_ * regular_) * std::pow(largest_ / regular_, exponent_);
    const std::vector<Mat3> unit(at(problem_.num_contacts()), Mat3::Identity());
    const std::vector<Mat3> added(at(problem_.num_contacts()), (penalty_ + regular_) * Mat3::Identity());
    return factor_.factor(unit, added);
  }

  /// One iteration on y_ and z_; leaves the two residuals.
  void step() {
    VecX rhs = (penalty_ + regular_) * y_ - z_ - problem_.q;
    if (problem_.law == Law::coulomb) rhs -= de_saxce_shift(problem_, z_);
    if (problem_.skew) rhs -= problem_.w * y_ - problem_.symmetric * y_;
    const VecX x = factor_.solve_unrefined(rhs);
    const VecX y = project(x + z_ / penalty_);
    primal_ = (x - y).cwiseAbs().maxCoeff();
    dual_ = penalty_ * (y - y_).cwiseAbs().maxCoeff();
    z_ += penalty_ * (x - y);
    y_ = y;
  }

  VecX state() const {
    VecX both(2 * y_.size());
    both << y_, z_ / penalty_;
    return both;
  }
  void set_state(const VecX& both) {
    y_ = both.head(y_.size());
    z_ = penalty_ * both.tail(y_.size());
  }

  bool balance() {
    const double before = exponent_;
    if (primal_ > k_imbalance * dual_) exponent_ += k_exponent_step;
    if (dual_ > k_imbalance * primal_) exponent_ -= k_exponent_step;
    exponent_ = std::clamp(exponent_, -k_largest_exponent, k_largest_exponent);
    return exponent_ != before;
  }

  void iterate() {
    largest_ = largest_eigenvalue(problem_.symmetric);
    regular_ = k_regularisation * largest_;
    z_ = VecX::Zero(y_.size());
    if (best_map_ == 0) return;
    if (!set_penalty()) return fail_to_factorise();
    Anderson mixer(settings_.anderson_depth);
    double least = std::numeric_limits<double>::infinity();
    VecX least_state;
    const int period = settings_.least_fall > 0 ? 1 : k_measure_period;
    int plain_until = 0, pause = k_first_pause;
    while (out_.iterations < settings_.shared.max_iterations && out_.status == SolveStatus::iteration_limit &&
           !settings_.shared.out_of_time()) {
      const VecX before = state();
      step();
      ++out_.iterations;
      if (out_.iterations % period == 0 || out_.iterations == settings_.shared.max_iterations) offer(y_);
      const VecX after = state();
      if (!after.allFinite()) return fail("the impulses grew beyond all numbers");
      if (out_.iterations % k_balance_period == 0 && balance()) {
        if (!set_penalty()) return fail_to_factorise();
        mixer.restart();
        least = std::numeric_limits<double>::infinity();
        continue;
      }
      if (settings_.anderson_depth == 0 || out_.iterations < plain_until) continue;
      const double residual = (after - before).norm();
      if (residual > k_growth * least) {
        mixer.restart();
        set_state(least_state);
        least = std::numeric_limits<double>::infinity();
        plain_until = out_.iterations + pause;
        pause *= 2;
        continue;
      }
      if (residual < least) {
        least = residual;
        least_state = after;
      }
      set_state(mixer.next(before, after));
    }
  }

  const LocalProblem& island_;
  const AdmmSettings& settings_;
  MassScaled problem_;
  BlockCholesky factor_;
  double largest_ = 0, regular_ = 0, penalty_ = 0;
  double exponent_;
  VecX y_, z_;
  double primal_ = 0, dual_ = 0;
  ContactSolution out_;
  VecX best_;
  double best_map_ = std::numeric_limits<double>::infinity();
  double last_map_ = best_map_, map_before_last_ = best_map_;
  double fallen_map_ = std::numeric_limits<double>::infinity();
  int fallen_iteration_ = 0;
};

}  // namespace

void AdmmSolver::demand_law(Law law) const { demand_known("admm", {Law::coulomb, Law::ccp, Law::frictionless}, law); }

ContactSolution AdmmSolver::solve_island(const LocalProblem& island, const VecX& guess,
                                         const SolverSettings& shared) const {
  if (const auto still = solve_immovable(island)) return *still;
  AdmmSettings own = settings_;
  own.shared = shared;
  return Alternation(island, own).run(guess);
}

}  // namespace nilas
