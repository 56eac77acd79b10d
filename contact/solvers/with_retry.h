#pragma once
/// One solver, and where it fails a second one from what the first left: on_failure="retry".
#include "contact/solvers/solver.h"

namespace nilas {

class WithRetry final : public ContactSolver {
 public:
  WithRetry(std::unique_ptr<ContactSolver> first, std::unique_ptr<ContactSolver> second)
      : first_(std::move(first)), second_(std::move(second)) {}
  using ContactSolver::solve;
  std::string name() const override { return first_->name(); }
  /// The better of the two by law_map_m_s; `iterations` of both; the message says that the second was asked.
  ContactSolution solve(const PreparedProblem& problem, const VecX& guess) const override;
  ContactSolution solve(const LocalProblem& problem, const VecX& guess) const override;

 private:
  std::unique_ptr<ContactSolver> first_, second_;
};

}  // namespace nilas
