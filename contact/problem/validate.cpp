#include <algorithm>
#include <cmath>
#include <functional>

#include "contact/problem/local_problem.h"
#include "contact/problem/mass_inverse.h"
#include "contact/problem/problem.h"
#include "core/base/error.h"

namespace nilas::contact {

/// Largest asymmetry of a mass block, relative to its largest entry: what files may hold.
constexpr double k_symmetry = 1e-2;

[[noreturn]] static void refuse(const std::string& field, const std::string& fault) {
  throw ContractError("contact problem: " + field + ": " + fault);
}

static void demand_size(const std::string& field, std::size_t found, std::size_t needed) {
  if (found != needed) refuse(field, "has " + std::to_string(found) + " entries, needs " + std::to_string(needed));
}

template <class Numbers>
static void demand_finite(const std::string& field, const Numbers& numbers) {
  for (auto i = 0 * numbers.size(); i < numbers.size(); ++i)
    if (!std::isfinite(numbers[i])) refuse(field, "entry " + std::to_string(i) + " is not finite");
}

static void check_scalars(const ContactProblem& problem) {
  if (!std::isfinite(problem.h) || problem.h < 0) refuse("h", "must be finite and not negative");
  if (problem.law == Law::pyramid_k && problem.facets < 3) refuse("facets", "a pyramid has at least 3");
}

static void check_blocks(const ContactProblem& problem) {
  demand_size("mass_offset", problem.mass_offset.size(), problem.block_offset.size());
  if (problem.block_offset.front() != 0 || problem.mass_offset.front() != 0) refuse("block_offset", "must begin at 0");
  for (int k = 0; k < problem.num_blocks(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (problem.block_size(k) < 1) refuse("block_offset", "block " + std::to_string(k) + " is empty");
    const auto n = static_cast<std::size_t>(problem.block_size(k));
    demand_size("mass_offset of block " + std::to_string(k), problem.mass_offset[i + 1] - problem.mass_offset[i],
                n * n);
  }
  demand_size("mass_data", problem.mass_data.size(), problem.mass_offset.back());
  demand_size("f", static_cast<std::size_t>(problem.f.size()), static_cast<std::size_t>(problem.num_velocities()));
  demand_finite("mass_data", problem.mass_data);
  demand_finite("f", problem.f);
  for (int k = 0; k < problem.num_blocks(); ++k) {
    const auto mass = problem.mass(k);
    const double asymmetry = (mass - mass.transpose()).cwiseAbs().maxCoeff();
    if (asymmetry > k_symmetry * mass.cwiseAbs().maxCoeff())
      refuse("mass_data", "block " + std::to_string(k) + " is not symmetric");
  }
  const int bad = MassInverse(problem).first_bad_block();
  if (bad >= 0) refuse("mass_data", "block " + std::to_string(bad) + " is not positive definite");
}

static void check_rows(const ContactProblem& problem) {
  const std::size_t nc = problem.pairs.size();
  demand_size("jacobian_offset", problem.jacobian_offset.size(), nc + 1);
  if (problem.jacobian_offset.front() != 0) refuse("jacobian_offset", "must begin at 0");
  for (std::size_t c = 0; c < nc; ++c) {
    std::size_t columns = 0;
    for (const int block : {problem.pairs[c].a, problem.pairs[c].b}) {
      if (block < -1 || block >= problem.num_blocks())
        refuse("pairs", "contact " + std::to_string(c) + " names block " + std::to_string(block));
      if (block >= 0) columns += static_cast<std::size_t>(problem.block_size(block));
    }
    demand_size("jacobian_offset of contact " + std::to_string(c),
                problem.jacobian_offset[c + 1] - problem.jacobian_offset[c], 3 * columns);
  }
  demand_size("jacobian_data", problem.jacobian_data.size(), problem.jacobian_offset.back());
  demand_size("w", static_cast<std::size_t>(problem.w.size()), 3 * nc);
  demand_finite("jacobian_data", problem.jacobian_data);
  demand_finite("w", problem.w);
}

template <class Problem>
static void check_keys(const Problem& problem) {
  demand_size("key", problem.key.size(), static_cast<std::size_t>(problem.num_contacts()));
  auto keys = problem.key;
  std::sort(keys.begin(), keys.end());
  const auto twin = std::adjacent_find(keys.begin(), keys.end());
  if (twin != keys.end()) refuse("key", std::to_string(*twin) + " occurs twice");
}

template <class Problem>
static void check_coefficients(const Problem& problem) {
  const auto nc = static_cast<std::size_t>(problem.num_contacts());
  demand_size("mu", problem.mu.size(), nc);
  demand_size("mu_static", problem.mu_static.size(), nc);
  demand_size("force_limit", problem.force_limit.size(), nc);
  demand_size("compliance", problem.compliance.size(), nc);
  demand_size("tangential_compliance", problem.tangential_compliance.size(), nc);
  demand_finite("mu", problem.mu);
  demand_finite("mu_static", problem.mu_static);
  demand_finite("compliance", problem.compliance);
  demand_finite("tangential_compliance", problem.tangential_compliance);
  for (std::size_t c = 0; c < nc; ++c) {
    const std::string contact = "contact " + std::to_string(c);
    if (problem.mu[c] < 0) refuse("mu", contact + " is negative");
    if (problem.mu_static[c] < problem.mu[c]) refuse("mu_static", contact + " is below mu");
    if (!(problem.force_limit[c] >= 0)) refuse("force_limit", contact + " is negative or not a number");
    if (problem.compliance[c] < 0) refuse("compliance", contact + " is negative");
    if (problem.tangential_compliance[c] < 0) refuse("tangential_compliance", contact + " is negative");
  }
}

static void check_matrix(const LocalProblem& problem) {
  const int nc = problem.num_contacts();
  if (problem.row_start.front() != 0) refuse("row_start", "must begin at 0");
  demand_size("column", problem.column.size(), static_cast<std::size_t>(problem.row_start.back()));
  demand_size("block", problem.block.size(), problem.column.size());
  for (int a = 0; a < nc; ++a) {
    const auto first = problem.column.begin() + problem.row_start[a];
    const auto last = problem.column.begin() + problem.row_start[static_cast<std::size_t>(a) + 1];
    const std::string row = "row " + std::to_string(a);
    if (last <= first || std::adjacent_find(first, last, std::greater_equal<>()) != last || *first < 0 ||
        *(last - 1) >= nc)
      refuse("column", row + " is not in rising order within 0.." + std::to_string(nc - 1));
    if (!std::binary_search(first, last, a)) refuse("column", row + " has no diagonal block");
  }
  for (std::size_t k = 0; k < problem.block.size(); ++k)
    if (!problem.block[k].allFinite()) refuse("block", "entry " + std::to_string(k) + " is not finite");
  demand_size("q", static_cast<std::size_t>(problem.q.size()), 3 * static_cast<std::size_t>(nc));
  demand_finite("q", problem.q);
}

void validate(const LocalProblem& problem) {
  if (problem.law == Law::pyramid_k && problem.facets < 3) refuse("facets", "a pyramid has at least 3");
  check_matrix(problem);
  check_coefficients(problem);
  check_keys(problem);
}

static void check_moments(const ContactProblem& problem) {
  if (!problem.has_moments()) return;
  demand_size("moments", problem.moments.size(), problem.pairs.size());
  const auto at = [&](int c) -> const ContactProblem::Moment& { return problem.moments[c]; };
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const int own = at(c).moment, of = at(c).contact;
    const bool agrees = (own < 0 || (of < 0 && own > c && own < problem.num_contacts() && at(own).contact == c)) &&
                        (of < 0 || (of < c && at(of).moment == c));
    if (!agrees) refuse("moments", "contact " + std::to_string(c) + " and its moment do not name each other");
  }
}

void validate(const ContactProblem& problem) {
  check_scalars(problem);
  check_blocks(problem);
  check_rows(problem);
  check_coefficients(problem);
  check_moments(problem);
  check_keys(problem);
}

}  // namespace nilas::contact
