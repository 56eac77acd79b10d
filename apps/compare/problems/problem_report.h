#pragma once
/// The report of a study of stored problems: its JSON object and its page.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/compare/problems/problem_pictures.h"

namespace nilas {

/// All that the report is made from.
struct ProblemReport {
  std::filesystem::path problems;    ///< the folder
  std::string status;                ///< running, done, interrupted, out of budget
  std::vector<std::string> solvers;  ///< as asked; empty: all
  std::vector<std::string> laws;     ///< as asked
  std::vector<double> tolerances;    ///< as asked; empty: the usual ones [m/s]
  double budget_s = 0, limit_s = 0;  ///< of the study; of a solve
  int jobs = 1;
  double wall_s = 0;                     ///< of all sessions
  std::size_t planned = 0;               ///< runs
  double estimate_s = 0, at_most_s = 0;  ///< of processor time for them
  std::string machine;
  std::vector<StudyRow> rows;     ///< sorted
  std::vector<StudyRow> dropped;  ///< runs left out: problem, solver, law, tolerance
};

nlohmann::ordered_json problem_report_json(const ProblemReport& report,
                                           const std::vector<SolverComparison>& comparisons);

/// compare.html: needs no other file; the SVG of `pictures` in the folder go into it. `no_pictures`: why there are
/// none. Throws FileError.
void write_problem_page(const std::filesystem::path& folder, const ProblemReport& report,
                        const std::vector<SolverComparison>& comparisons, const std::vector<ProblemPicture>& pictures,
                        const std::string& no_pictures);

/// What was left out, in words: by tolerance and law the problems, all of them or by name. Empty where nothing was.
std::string dropped_text(const ProblemReport& report);

}  // namespace nilas
