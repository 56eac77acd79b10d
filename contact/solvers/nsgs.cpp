#include "contact/solvers/nsgs.h"

#include <array>
#include <optional>

#include "contact/problem/row_of.h"
#include "contact/solvers/lanes/nsgs_lanes.h"
#include "contact/solvers/shared/nsgs_sweep.h"
#include "contact/solvers/shared/sweep_momentum.h"

namespace nilas::solvers {

namespace {

class NsgsBodies : public RowSweeps {
 public:
  NsgsBodies(const RowIsland& whole, bool has_momentum)
      : RowSweeps(whole),
        facets_(whole.problem.facets),
        threads_(whole.threads),
        blocks_(make_nsgs_contacts(rows_, island_)),
        turns_(rows_, island_, blocks_) {
    if (has_momentum) momentum_.emplace(whole, turns_.alone(island_));
  }

  double sweep(bool backward) {
    if (momentum_) turns_.set_momentum(momentum_->push());
    if (turns_.exist()) return turns_.sweep(rows_, island_, blocks_, backward, threads_);
    return nsgs_sweep(rows_, island_, blocks_, facets_, backward, threads_);
  }
  double law_map() {
    turns_.keep_impulses(rows_);
    return RowSweeps::law_map();
  }
  VecX impulses() {
    turns_.keep_impulses(rows_);
    return RowSweeps::impulses();
  }

 private:
  int facets_;
  int threads_;
  std::vector<NsgsContact> blocks_;
  NsgsTurns turns_;
  std::optional<SweepMomentum> momentum_;
};

class NsgsLocal : public LocalSweeps {
 public:
  NsgsLocal(const contact::LocalProblem& problem, const VecX& guess) : LocalSweeps(problem, guess) {
    for (int c = 0; c < problem.num_contacts(); ++c) {
      const auto i = static_cast<std::size_t>(c);
      contacts_.push_back({contact::ContactBlock(problem.diagonal(c), problem.mu[i], problem.force_limit[i],
                                                 problem.compliance[i], problem.tangential_compliance[i]),
                           {0, r_[contact::row_of(c)]},
                           scales_[i].d});
    }
  }

  double sweep(bool backward) {
    double largest = 0;
    const int count = problem_.num_contacts();
    for (int k = 0; k < count; ++k) {
      const double change = visit(backward ? count - 1 - k : k);
      if (!(change <= largest)) largest = change;
    }
    return largest;
  }

 private:
  double visit(int c) {
    NsgsContact& own = contacts_[c];
    const Vec3 old = r_.segment<3>(contact::row_of(c));
    const Vec3 u = contact::compliant_velocity(problem_, c, old, velocity(c));
    const Vec3 r =
        contact::solve_in_sweep(problem_.law, problem_.facets, own.block, own.block.without(old, u), own.start);
    r_.segment<3>(contact::row_of(c)) = r;
    return own.d * (r - old).norm();
  }

  std::vector<NsgsContact> contacts_;
};

}  // namespace

contact::ContactSolution NsgsSolver::solve(const contact::PreparedProblem& problem, const VecX& guess) const {
  return solve(problem, guess, Budget(settings_.shared));
}

contact::ContactSolution NsgsSolver::solve(const contact::LocalProblem& problem, const VecX& guess) const {
  return solve(problem, guess, Budget(settings_.shared));
}

contact::ContactSolution NsgsSolver::solve(const contact::PreparedProblem& problem, const VecX& guess,
                                           const Budget& budget) const {
  if (problem.problem().has_moments())
    demand_known("nsgs with rolling friction", std::array{Law::coulomb, Law::pyramid}, problem.problem().law);
  return solve_row_islands(problem, guess, settings_.shared, RowOrder::coloured, [&](const RowIsland& island) {
    NsgsBodies sweeps(island, settings_.has_momentum);
    contact::ContactSolution part =
        sweep_to_tolerance(sweeps, island.island.last - island.island.first, settings_, budget);
    sweeps.set_impulses(part.r);
    return part;
  });
}

contact::ContactSolution NsgsSolver::solve(const contact::LocalProblem& problem, const VecX& guess,
                                           const Budget& budget) const {
  return solve_by_sweeps<NsgsLocal>(problem, guess, settings_, budget);
}

}  // namespace nilas::solvers
