#pragma once
/// One island as solvers of the projected-gradient family see it: u = W r + q (+ c r_N on normal rows) and the law.
#include <memory>
#include <vector>

#include "contact/solvers/shared/row_islands.h"

namespace nilas::solvers {

class IslandOperator {
 public:
  virtual ~IslandOperator() = default;
  int num_contacts() const { return static_cast<int>(scales_.size()); }
  Law law() const { return law_; }
  int facets() const { return facets_; }
  const std::vector<contact::ContactScale>& scales() const { return scales_; }

  int threads() const { return threads_; }  ///< threads for work on all contacts

  /// u: 3 nc compliant velocities of the impulses r. O(nc), or O(blocks of W) on a local problem.
  virtual void velocities(const VecX& r, VecX& u) = 0;
  /// The residual of r as `measure` finds it [m/s].
  virtual double law_map(const VecX& r) = 0;

  /// Largest residual of any contact for impulses and velocities at hand: law_map up to rounding.
  double estimate(const VecX& r, const VecX& u) const;

 protected:
  Law law_ = Law::coulomb;
  int facets_ = 8;
  int threads_ = 1;
  std::vector<contact::ContactScale> scales_;
};

std::unique_ptr<IslandOperator> make_operator(const contact::LocalProblem& island);
/// `order_free`: as in BlockSums, the residual included.
std::unique_ptr<IslandOperator> make_operator(const RowIsland& island, bool order_free);

/// Solves one island from `guess` (3 nc, admissible or not); r of the solution holds the impulses found.
using OperatorSolve = std::function<contact::ContactSolution(IslandOperator& island, const VecX& guess)>;

contact::ContactSolution solve_by_operator(const contact::LocalProblem& problem, const VecX& guess,
                                           const contact::SolverSettings& shared, const OperatorSolve& solve);
/// `order_free`: r, v and u too have bits that do not depend on the order of contacts and bodies.
contact::ContactSolution solve_by_operator(const contact::PreparedProblem& problem, const VecX& guess,
                                           const contact::SolverSettings& shared, bool order_free,
                                           const OperatorSolve& solve);

}  // namespace nilas::solvers
