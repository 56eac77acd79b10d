#pragma once
/// What a Problem holds.
#include "contact/fclib/fclib_io.h"
#include "nilas/problem.h"

namespace nilas {

struct Problem::Content {
  contact::FclibProblem stored;

  const contact::LocalProblem* local() const { return std::get_if<contact::LocalProblem>(&stored.problem); }
  const contact::ContactProblem* global() const { return std::get_if<contact::ContactProblem>(&stored.problem); }
};

namespace library {

/// Throws Error where the impulses are not three finite numbers per contact. what: their name in messages.
VecX impulses_of(const Problem::Content& content, std::span<const double> r, const char* what = "the list of impulses");
std::vector<double> listed(const VecX& x);
/// Drops the guess and the solution that came with a problem, which no longer fit it.
void forget_impulses(Problem::Content& content);
/// Velocities of bodies in the order of the file or of add_body().
std::vector<double> in_order_of_file(const Problem::Content& content, const VecX& v);

}  // namespace library

}  // namespace nilas
