#pragma once
/// What the rows of a study of stored problems say.
#include <string>
#include <vector>

#include "apps/compare/problems/problem_profiles.h"
#include "apps/compare/problems/problem_study_row.h"

namespace nilas {

/// All solvers on the problems that all of them were tried on, for one law and tolerance.
struct SolverComparison {
  std::string law;
  double tolerance = 0;
  std::vector<std::string> problems, solvers;
  SolveTimes times;  ///< [s]
  std::vector<Profile> by_ratio, by_time;
  std::vector<SolverScore> scores;  ///< per solver
};
/// Laws in the order of their names in the rows, of each the middle tolerance first. Those without a problem that every
/// solver was tried on are left out.
std::vector<SolverComparison> compare_solvers(const std::vector<StudyRow>& rows);
/// The comparison of some of its problems.
SolverComparison restricted(const SolverComparison& all, const std::vector<std::string>& problems);

/// One sentence or two: who solves most, who is fastest, what nobody solves.
std::string headline(const SolverComparison& comparison);

/// A point of accuracy against time: of one problem, or (no problem) the medians over all of a comparison.
struct WorkPoint {
  std::string law, problem, solver;
  double tolerance = 0, seconds = 0, residual = 0;  ///< [m/s] [s] [m/s]
};
/// Medians per law, solver and tolerance, where a failure took for ever: there is a point only where most are solved.
/// Tolerances that were not tried on the same problems as the first of the law are left out.
std::vector<WorkPoint> median_points(const std::vector<StudyRow>& rows,
                                     const std::vector<SolverComparison>& comparisons);
/// Of single problems, whatever was reached: up to `count` of them, from the quickest to the slowest to be solved.
std::vector<WorkPoint> problem_points(const std::vector<StudyRow>& rows,
                                      const std::vector<SolverComparison>& comparisons, std::size_t count);

/// Name of the class of problems whose contacts are not known well enough.
constexpr const char* k_unknown_class = "not known";

/// Problems of a kind.
struct ProblemClass {
  std::string name;
  std::vector<std::string> problems;
};
/// By mass ratio (files of the global form), else by what most loaded contacts do in the most accurate answer of all
/// runs; "not known" where none came within 1e-4 m/s.
std::vector<ProblemClass> problem_classes(const std::vector<StudyRow>& rows);

}  // namespace nilas
