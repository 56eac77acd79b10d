#pragma once
/// The page and the JSON object of a study of stored problems.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/compare/problems/problem_study_figures.h"

namespace nilas {

/// All that a study has to tell.
struct StudyReport {
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

nlohmann::ordered_json study_report_json(const StudyReport& report, const std::vector<Comparison>& comparisons);

/// compare.html: needs no other file; the SVG pictures of `figures` in the folder go into it. `no_pictures`: why there
/// are none. Throws FileError.
void write_study_page(const std::filesystem::path& folder, const StudyReport& report,
                      const std::vector<Comparison>& comparisons, const std::vector<StudyFigure>& figures,
                      const std::string& no_pictures);

/// What was left out, in words: by tolerance and law the problems, all of them or by name. Empty where nothing was.
std::string dropped_text(const StudyReport& report);

}  // namespace nilas
