#include "contact/solvers/newton.h"

#include <algorithm>
#include <cmath>

#include "contact/solvers/newton/newton_system.h"
#include "contact/solvers/shared/mass_scaled.h"
#include "core/base/error.h"

namespace nilas {

namespace {

constexpr double k_most_weight = 10;
/// Factors of the weight after a middling and a failed inner solve.
constexpr double k_rise = 3, k_retreat = 10;
/// A good inner solve of more steps than these leaves the weight as it is.
constexpr int k_very_quick_steps = 3, k_quick_steps = 8;
/// |F| fallen to this share makes an inner solve good, to the second one middling.
constexpr double k_good = 0.1, k_middling = 0.5;
/// A line search demands this share of the fall that the linear model promises.
constexpr double k_armijo = 1e-4;
/// Retreats beyond the largest weight before giving up.
constexpr int k_patience = 3;
/// |F| that rounding leaves, in units of sqrt(J).
constexpr double k_rounding = 1e-16;

/// Impulses with their velocities, the proximal term included, and |F|.
struct Iterate {
  VecX r, u;
  double size = 0;
};

class Island {
 public:
  Island(const LocalProblem& problem, const NewtonSettings& settings)
      : problem_(problem), settings_(settings), system_(problem, settings.order_free) {}

  ContactSolution solve(const VecX& guess) {
    r_ = guess.size() > 0 ? system_.scaled(guess) : VecX(VecX::Zero(problem_.q.size()));
    out_.status = SolveStatus::iteration_limit;
    weight_ = settings_.first_weight;
    judge(r_);
    if (!std::isfinite(best_)) start_from_nothing();
    while (out_.status == SolveStatus::iteration_limit && !out_of_budget()) outer_step();
    return out_;
  }

 private:
  /// The guess is beyond all numbers.
  void start_from_nothing() {
    out_.r.resize(0);
    r_.setZero();
    judge(r_);
    if (!std::isfinite(best_)) fail("even impulses of zero have a residual beyond all numbers");
  }

  void fail(const std::string& why) {
    out_.status = SolveStatus::numerical_error;
    out_.message = "newton: " + why;
  }

  /// Measures, keeps the best.
  void judge(const VecX& scaled_r) {
    const VecX r = system_.impulses(scaled_r);
    const double law_map = settings_.order_free ? system_.law_map(scaled_r) : measure(problem_, r).law_map_m_s;
    if (out_.r.size() == 0 || law_map < best_) {
      best_ = law_map;
      out_.r = r;
    }
    if (law_map <= settings_.shared.tolerance) out_.status = SolveStatus::converged;
  }

  bool out_of_budget() const {
    const int most = std::min(settings_.shared.max_iterations, settings_.max_factorisations);
    if (out_.iterations >= most) return true;
    return settings_.shared.out_of_time();
  }

  void outer_step() {
    const VecX free_velocity = system_.velocities(r_);
    const double before = system_.map_size(r_, free_velocity);
    const int steps_before = out_.iterations;
    const double target = std::max(settings_.inner_share * before, k_rounding);
    VecX r = r_;
    const double after = inner_solve(free_velocity, target, r);
    judge(r);
    if (out_.status != SolveStatus::iteration_limit) return;
    if (out_.iterations == steps_before) {  // |F| is rounding already
      if (std::isfinite(before))
        out_.status = SolveStatus::stalled;
      else
        fail("the map grew beyond all numbers");
      return;
    }
    if (after <= std::max(10 * target, k_good * before)) {
      r_ = r;
      const int taken = out_.iterations - steps_before;
      if (taken <= k_quick_steps)
        weight_ = std::max((taken <= k_very_quick_steps ? settings_.plunge : settings_.fall) * weight_,
                           settings_.least_weight);
    } else if (after <= k_middling * before) {
      r_ = r;
      weight_ *= k_rise;
    } else {
      retreat();
    }
  }

  void retreat() {
    weight_ *= k_retreat;
    if (weight_ <= k_most_weight) return;
    weight_ = 10 * settings_.first_weight;
    r_ = system_.scaled(out_.r);
    if (++retreats_ < k_patience) return;
    if (singular_)
      fail("the linear system stays singular whatever the proximal weight");
    else
      out_.status = SolveStatus::stalled;
  }

  /// Newton on the problem with velocities u + a (r - r_0), r and u those of r_0 on entry. Returns |F|.
  double inner_solve(VecX u, double target, VecX& r) {
    Iterate now{r, std::move(u), 0};
    now.size = system_.linearise(now.r, now.u);
    Iterate best = now;
    int in_vain = 0;
    VecX dr;
    for (int k = 0; k < settings_.inner_steps && best.size > target && !out_of_budget(); ++k) {
      if (in_vain == settings_.free_steps && now.size > best.size) {
        now = best;
        system_.linearise(now.r, now.u);
      }
      ++out_.iterations;
      singular_ = !system_.step(weight_, now.r, dr);
      if (singular_) break;
      const VecX du = system_.product(dr) + weight_ * dr;
      if (in_vain < settings_.free_steps) {
        now = {now.r + dr, now.u + du, 0};
      } else if (!descend(dr, du, now)) {
        break;
      }
      now.size = system_.linearise(now.r, now.u);
      if (in_vain < settings_.free_steps) in_vain = now.size < k_middling * best.size ? 0 : in_vain + 1;
      if (now.size < best.size) best = now;
      if (settings_.shared.keep_history) note(now.r);
    }
    r = best.r;
    return best.size;
  }

  /// Halves the step until |F| falls. False when it never does.
  bool descend(const VecX& dr, const VecX& du, Iterate& now) const {
    double t = 1;
    for (int k = 0; k < settings_.halvings; ++k, t *= 0.5) {
      Iterate next{now.r + t * dr, now.u + t * du, 0};
      next.size = system_.map_size(next.r, next.u);
      if (!(next.size < (1 - k_armijo * t) * now.size)) continue;
      now = std::move(next);
      return true;
    }
    return false;
  }

  void note(const VecX& scaled_r) { out_.history.push_back(measure(problem_, system_.impulses(scaled_r)).law_map_m_s); }

  const LocalProblem& problem_;
  const NewtonSettings& settings_;
  NewtonSystem system_;
  ContactSolution out_;
  VecX r_;
  double best_ = 0;
  double weight_ = 0;
  int retreats_ = 0;
  bool singular_ = false;  ///< the last linear system
};

}  // namespace

ContactSolution newton_island(const LocalProblem& island, const VecX& guess, const NewtonSettings& settings) {
  if (const auto immovable = solve_immovable(island)) return *immovable;
  return Island(island, settings).solve(guess);
}

ContactSolution NewtonSolver::solve_island(const LocalProblem& island, const VecX& guess,
                                           const SolverSettings& shared) const {
  NewtonSettings own = settings_;
  own.shared = shared;
  return newton_island(island, guess, own);
}

}  // namespace nilas
