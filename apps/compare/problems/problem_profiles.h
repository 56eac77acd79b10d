#pragma once
/// Performance profiles of solvers on a set of problems.
///
///   ratio_ps = t_ps / min over s of t_ps,   rho_s(x) = share of the problems with ratio_ps <= x
///
/// A failure has an infinite time and so an infinite ratio; a problem that nobody solves counts against all.
/// Source: Dolan, More, Benchmarking optimization software with performance profiles, 2002. Data profiles take the time
/// itself in place of the ratio.
#include <cstddef>
#include <limits>
#include <vector>

namespace nilas {

constexpr double k_unsolved = std::numeric_limits<double>::infinity();

/// Seconds per problem (outer) and solver (inner); k_unsolved where it failed.
using SolveTimes = std::vector<std::vector<double>>;

/// A share that rises in steps: from x on it is `share`, until the next point.
struct ProfilePoint {
  double x = 0, share = 0;
};
using Profile = std::vector<ProfilePoint>;

/// ratio_ps; infinite where the solver failed. Two times of 0 are alike.
SolveTimes time_ratios(const SolveTimes& times);

/// Of each solver: the share of problems whose value is at most x, a point per jump. Empty where it solved none.
std::vector<Profile> profiles(const SolveTimes& values);

/// What a solver did on a set of problems.
struct SolverScore {
  std::size_t solved = 0, fastest = 0, problems = 0;
  double mean_ratio = k_unsolved;  ///< geometric mean over the problems that it solved
};
std::vector<SolverScore> scores(const SolveTimes& times);

/// The middle value, of an even number the mean of the two (infinite where one is); infinite of none.
double median(const std::vector<double>& values);

}  // namespace nilas
