#pragma once
/// One island as solvers of the projected-gradient family see it: u = W r + q (+ c r_N on normal rows) and the law.
#include <memory>
#include <vector>

#include "contact/solvers/row_islands.h"

namespace nilas {

class IslandOperator {
 public:
  virtual ~IslandOperator() = default;
  int num_contacts() const { return static_cast<int>(scales_.size()); }
  Law law() const { return law_; }
  int facets() const { return facets_; }
  const std::vector<ContactScale>& scales() const { return scales_; }

  /// u: 3 nc compliant velocities of the impulses r. O(nc), or O(blocks of W) on a local problem.
  virtual void velocities(const VecX& r, VecX& u) = 0;
  /// The residual of r as `measure` finds it [m/s].
  virtual double law_map(const VecX& r) = 0;

  /// Largest residual of any contact for impulses and velocities at hand: law_map up to rounding.
  double estimate(const VecX& r, const VecX& u) const;

 protected:
  Law law_ = Law::coulomb;
  int facets_ = 8;
  std::vector<ContactScale> scales_;
};

std::unique_ptr<IslandOperator> make_operator(const LocalProblem& island);
std::unique_ptr<IslandOperator> make_operator(const RowIsland& island);

/// Solves one island from `guess` (3 nc, admissible or not); r of the solution is what was found.
using OperatorSolve = std::function<ContactSolution(IslandOperator& island, const VecX& guess)>;

ContactSolution solve_by_operator(const LocalProblem& problem, const VecX& guess, const SolverSettings& shared,
                                  const OperatorSolve& solve);
ContactSolution solve_by_operator(const ContactProblem& problem, const VecX& guess, const SolverSettings& shared,
                                  const OperatorSolve& solve);

}  // namespace nilas
