#pragma once
/// The report of a study of stored problems: its JSON object and its page.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/compare/problems/problem_pictures.h"

namespace nilas::compare {

/// The input of the report.
struct ProblemReport {
  std::filesystem::path problems;    ///< folder of the problems
  std::string status;                ///< running, done, interrupted, out of budget
  std::vector<std::string> solvers;  ///< solvers asked for; empty: all
  std::vector<std::string> laws;     ///< laws asked for
  std::vector<double> tolerances;    ///< tolerances asked for [m/s]; empty: the usual ones
  double budget_s = 0, limit_s = 0;  ///< wall time of the study and time limit of a solve [s]
  int jobs = 1;
  double wall_s = 0;                     ///< wall time of all sessions [s]
  std::size_t planned = 0;               ///< number of planned runs
  double estimate_s = 0, at_most_s = 0;  ///< estimate and limit of their processor time [s]
  std::string machine;
  std::vector<StudyRow> rows;     ///< rows as sort_study() sorts them
  std::vector<StudyRow> dropped;  ///< runs left out: problem, solver, law, tolerance
};

nlohmann::ordered_json problem_report_json(const ProblemReport& report,
                                           const std::vector<SolverComparison>& comparisons);

/// Writes compare.html, which needs no other file because it contains the SVG files of `pictures`. `no_pictures`: why
/// there are none. Throws FileError.
void write_problem_page(const std::filesystem::path& folder, const ProblemReport& report,
                        const std::vector<SolverComparison>& comparisons, const std::vector<ProblemPicture>& pictures,
                        const std::string& no_pictures);

/// The runs that were left out, in words: the problems of each tolerance and law. Empty if none was.
std::string dropped_text(const ProblemReport& report);

}  // namespace nilas::compare
