#pragma once
/// A contact problem with the data that its solver and its measurement share, derived once for both.
#include <vector>

#include "contact/problem/mass_inverse.h"
#include "contact/problem/problem.h"

namespace nilas::contact {

class PreparedProblem {
 public:
  /// `problem` must outlive this and stay as it is, apart from its coefficients of friction. Throws ContractError where
  /// its lists differ in length.
  explicit PreparedProblem(const ContactProblem& problem);
  explicit PreparedProblem(ContactProblem&&) = delete;

  const ContactProblem& problem() const { return problem_; }
  const MassInverse& masses() const { return masses_; }
  /// nc, d_a = trace(W_aa)/3 of each row triple, moments among them [1/kg].
  const std::vector<double>& inverse_mass_scales() const { return scales_; }
  /// The islands that find_islands returns.
  const std::vector<std::vector<int>>& islands() const { return islands_; }

 private:
  const ContactProblem& problem_;
  MassInverse masses_;
  std::vector<double> scales_;
  std::vector<std::vector<int>> islands_;
};

/// v = M^-1 (f + H r).
VecX velocities(const PreparedProblem& prepared, const VecX& r);

}  // namespace nilas::contact
