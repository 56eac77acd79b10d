#include "contact/problem/prepared_problem.h"

#include "contact/problem/islands.h"
#include "contact/problem/operators.h"
#include "core/base/error.h"

namespace nilas::contact {

namespace {

const ContactProblem& checked(const ContactProblem& problem) {
  const std::size_t nc = problem.pairs.size();
  NILAS_DEMAND(problem.f.size() == problem.num_velocities());
  NILAS_DEMAND(problem.w.size() == 3 * problem.num_contacts() && problem.jacobian_offset.size() == nc + 1);
  NILAS_DEMAND(problem.mu.size() == nc && problem.force_limit.size() == nc && problem.compliance.size() == nc &&
               problem.tangential_compliance.size() == nc);
  NILAS_DEMAND(problem.key.size() == nc);
  return problem;
}

std::vector<double> scales_of(const ContactProblem& problem, const MassInverse& masses) {
  std::vector<double> response(largest_response(problem)), scales;
  scales.reserve(problem.pairs.size());
  for (int c = 0; c < problem.num_contacts(); ++c)
    scales.push_back(inverse_mass_scale(problem, masses, c, response.data()));
  return scales;
}

}  // namespace

PreparedProblem::PreparedProblem(const ContactProblem& problem)
    : problem_(checked(problem)),
      masses_(problem),
      scales_(scales_of(problem, masses_)),
      islands_(find_islands(problem)) {}

VecX velocities(const PreparedProblem& prepared, const VecX& r) {
  return velocities(prepared.problem(), prepared.masses(), r);
}

}  // namespace nilas::contact
