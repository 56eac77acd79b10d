#pragma once
/// A solver and, where it fails, a second one that continues from the first one's impulses: on_failure="retry".
#include "contact/solvers/solver.h"

namespace nilas::solvers {

class WithRetry final : public ContactSolver {
 public:
  WithRetry(std::unique_ptr<ContactSolver> first, std::unique_ptr<ContactSolver> second)
      : first_(std::move(first)), second_(std::move(second)) {}
  using ContactSolver::solve;
  std::string name() const override { return first_->name(); }
  /// Returns the better of the two by law_map_m_s. `iterations` counts both, and the message says that the second was
  /// used.
  contact::ContactSolution solve(const contact::PreparedProblem& problem, const VecX& guess) const override;
  contact::ContactSolution solve(const contact::LocalProblem& problem, const VecX& guess) const override;

 private:
  std::unique_ptr<ContactSolver> first_, second_;
};

}  // namespace nilas::solvers
