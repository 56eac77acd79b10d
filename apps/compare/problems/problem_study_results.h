#pragma once
/// The results of a study of stored problems, from its rows.
#include <string>
#include <vector>

#include "apps/compare/problems/problem_profiles.h"
#include "apps/compare/problems/problem_study_row.h"

namespace nilas::compare {

/// All solvers on the problems that all of them were tried on, for one law and tolerance.
struct SolverComparison {
  std::string law;
  double tolerance = 0;
  std::vector<std::string> problems, solvers;
  SolveTimes times;  ///< solve times [s]
  std::vector<Profile> by_ratio, by_time;
  std::vector<SolverScore> scores;  ///< one per solver
};
/// The comparisons, in the order of the laws in the rows and with the middle tolerance of each first. Those without a
/// problem on which every solver was tried are left out.
std::vector<SolverComparison> compare_solvers(const std::vector<StudyRow>& rows);
/// The comparison of some of its problems.
SolverComparison restricted(const SolverComparison& all, const std::vector<std::string>& problems);

/// One or two sentences: which solver solves most problems, which is fastest, and how many problems no solver solves.
std::string headline(const SolverComparison& comparison);

/// A point of accuracy against time. It is of one problem, or of the medians over a comparison if `problem` is empty.
struct WorkPoint {
  std::string law, problem, solver;
  double tolerance = 0, seconds = 0, residual = 0;  ///< [m/s], [s], [m/s]
};
/// The medians for each law, solver and tolerance. A failure counts as an infinite time, so there is a point only if
/// most problems are solved. Tolerances that were not tried on the same problems as the first of the law are left out.
std::vector<WorkPoint> median_points(const std::vector<StudyRow>& rows,
                                     const std::vector<SolverComparison>& comparisons);
/// The points of up to `count` single problems, from the one solved fastest to the slowest, whatever residual was
/// reached.
std::vector<WorkPoint> problem_points(const std::vector<StudyRow>& rows,
                                      const std::vector<SolverComparison>& comparisons, std::size_t count);

/// The name of the class of problems whose contacts are not known well enough.
constexpr const char* k_unknown_class = "not known";

/// A class of problems.
struct ProblemClass {
  std::string name;
  std::vector<std::string> problems;
};
/// The classes of the problems: by mass ratio (files of the global form), else by whether more contacts slide or stick
/// in the most accurate answer of all runs. The class is "not known" if no answer is within 1e-4 m/s.
std::vector<ProblemClass> problem_classes(const std::vector<StudyRow>& rows);

}  // namespace nilas::compare
