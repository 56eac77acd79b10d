#include "contact/solvers/ipm.h"

#include <algorithm>
#include <cmath>

#include "contact/solvers/newton/interior_point.h"
#include "contact/solvers/newton/newton_finish.h"
#include "contact/solvers/shared/anderson.h"
#include "core/base/error.h"

namespace nilas {

namespace {

constexpr int k_anderson_depth = 6;
/// An inner solve need not be better than this share of the outer loop's last change.
constexpr double k_inner_share = 1e-4;
/// A later round starts this share of the first one's velocities inside the cones: nearer, steps are cut short by the
/// boundary; farther, the warm start is lost.
constexpr double k_warm_share = 1e-3;
/// Rounds without halving after which the fixed point is repeated plainly: accelerated, it may creep along one set of
/// states; plain, it wanders and gives the Newton finish other starts.
constexpr int k_plain_after = 5;
/// Inner iterations per round; 30 are enough from a cold start.
constexpr int k_inner_limit = 60;
constexpr double k_halved = 0.5;

/// One island.
class Rounds {
 public:
  Rounds(const LocalProblem& island, const IpmSettings& settings)
      : island_(island), settings_(settings), problem_(mass_scaled(island)), inner_(problem_) {}

  ContactSolution run(const VecX& guess) {
    best_ = VecX::Zero(problem_.q.size());
    offer(best_);
    if (guess.size() > 0) {
      offer(problem_.scaled_impulses(guess));
      if (!done()) finish(best_);
    }
    iterate();
    if (!done() && !std::isfinite(best_map_))
      fail("even impulses of zero have a residual beyond all numbers");
    else if (!done() && rounds_ > 0 && failed_rounds_ == rounds_)
      fail("W and the barrier together are not positive definite");
    out_.r = problem_.impulses(best_);
    return out_;
  }

 private:
  const SolverSettings& shared() const { return settings_.shared; }
  bool done() const { return shared().tolerance > 0 && best_map_ <= shared().tolerance; }
  void fail(const std::string& why) {
    out_.status = SolveStatus::numerical_error;
    out_.message = "ipm: " + why;
  }
  int left() const { return shared().max_iterations - out_.iterations; }

  /// Keeps r' if it measures best.
  void offer(const VecX& scaled) {
    if (!scaled.allFinite()) return;
    const double map = measure(island_, problem_.impulses(scaled)).law_map_m_s;
    if (shared().keep_history) out_.history.push_back(map);
    if (!(map < best_map_)) return;
    best_map_ = map;
    best_ = scaled;
    if (done()) out_.status = SolveStatus::converged;
  }

  void finish(const VecX& scaled) {
    const int most = std::min(settings_.finish_iterations, left());
    const FinishOutcome end = newton_finish(problem_, scaled, 0.1 * shared().tolerance, most, shared());
    out_.iterations += end.iterations;
    offer(end.r);
  }

  /// What the outer loop adds to q for given impulses.
  VecX offset(const VecX& r) const {
    const VecX u = problem_.w * r + problem_.q;
    VecX sum = problem_.skew ? VecX(problem_.w * r - problem_.symmetric * r) : VecX(VecX::Zero(r.size()));
    if (problem_.law == Law::coulomb) sum += de_saxce_shift(problem_, u);
    return sum;
  }

  void iterate() {
    out_.status = done() ? SolveStatus::converged : SolveStatus::iteration_limit;
    const double size = problem_.q.cwiseAbs().maxCoeff();
    VecX added = VecX::Zero(problem_.q.size());
    InteriorIterate point = inner_.cold_start(problem_.q);
    const bool adds_nothing = problem_.law != Law::coulomb && !problem_.skew;  // then one round is all
    Anderson mixer(k_anderson_depth);
    double halved_map = best_map_, change = size;
    int halved_round = 0;
    for (int round = 0; round < settings_.max_rounds && !done() && left() > 0 && !shared().out_of_time(); ++round) {
      if (round > 0) point = inner_.shifted(point, std::min(k_warm_share * size, change));
      const double least = 0.1 * shared().tolerance;
      const double tolerance = adds_nothing ? least : std::max(k_inner_share * change, least);
      const auto inner =
          inner_.minimise(problem_.q + added, tolerance, std::min(k_inner_limit, left()), shared(), point);
      out_.iterations += inner.iterations;
      ++rounds_;
      if (!inner.finite) ++failed_rounds_;
      const VecX r = inner_.impulses(point);
      offer(r);
      if (!done()) finish(r);
      const VecX wanted = offset(r);
      change = (wanted - added).cwiseAbs().maxCoeff();
      if (round - halved_round >= k_plain_after) {
        mixer.restart();
        added = wanted;
      } else {
        added = mixer.next(added, wanted);
      }
      if (best_map_ < k_halved * halved_map) {
        halved_map = best_map_;
        halved_round = round;
      }
      const bool stuck = change == 0 || round - halved_round >= settings_.stall_rounds;
      if (!done() && stuck) {
        out_.status = SolveStatus::stalled;
        return;
      }
    }
  }

  const LocalProblem& island_;
  const IpmSettings& settings_;
  MassScaled problem_;
  InteriorPoint inner_;
  ContactSolution out_;
  VecX best_;
  double best_map_ = std::numeric_limits<double>::infinity();
  int rounds_ = 0, failed_rounds_ = 0;  ///< failed: without one iterate
};

}  // namespace

void IpmSolver::demand_law(Law law) const { demand_known("ipm", {Law::coulomb, Law::ccp, Law::frictionless}, law); }

ContactSolution IpmSolver::solve_island(const LocalProblem& island, const VecX& guess,
                                        const SolverSettings& shared) const {
  if (const auto still = solve_immovable(island)) return *still;
  IpmSettings own = settings_;
  own.shared = shared;
  return Rounds(island, own).run(guess);
}

}  // namespace nilas
