#pragma once
/// Performance profiles of solvers on a set of problems.
///
///   ratio_ps = t_ps / min over s of t_ps,   rho_s(x) = share of the problems with ratio_ps <= x
///
/// A failure has an infinite time and so an infinite ratio. A problem that no solver solves counts against all.
/// Source: Dolan, More, Benchmarking optimization software with performance profiles, 2002. Data profiles take the time
/// itself in place of the ratio.
#include <cstddef>
#include <limits>
#include <vector>

namespace nilas::compare {

constexpr double k_unsolved = std::numeric_limits<double>::infinity();

/// Solve times [s], one list per problem with a time per solver; k_unsolved if it failed.
using SolveTimes = std::vector<std::vector<double>>;

/// A point of a share that rises in steps: it is `share` from x to the next point.
struct ProfilePoint {
  double x = 0, share = 0;
};
using Profile = std::vector<ProfilePoint>;

/// The ratios ratio_ps; infinite if the solver failed. The ratio of two times of 0 is 1.
SolveTimes time_ratios(const SolveTimes& times);

/// The profile of each solver: the share of problems with a value of at most x, a point per jump. It is empty if the
/// solver solved none.
std::vector<Profile> profiles(const SolveTimes& values);

/// The score of a solver on a set of problems.
struct SolverScore {
  std::size_t solved = 0, fastest = 0, problems = 0;
  double mean_ratio = k_unsolved;  ///< geometric mean of its ratios over the problems that it solved
};
std::vector<SolverScore> scores(const SolveTimes& times);

/// The median: the middle value, or the mean of the two middle ones, which is infinite if one is. Infinite without
/// values.
double median(const std::vector<double>& values);

}  // namespace nilas::compare
