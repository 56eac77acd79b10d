#pragma once
/// nilas compare --problems: all solvers on stored contact problems, at several tolerances.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace nilas {

struct ProblemStudyOptions {
  std::filesystem::path folder;            ///< of FCLIB files
  std::vector<std::string> solvers, laws;  ///< empty: all that take the law; coulomb
  std::vector<double> tolerances;          ///< [m/s]; empty: 1e-2 1e-4 1e-6 1e-8, and 1e-10 up to 50 contacts
  double budget_s = 0;                     ///< wall time for the runs; 0: 1200 [s]
  int jobs = 0;                            ///< processes at a time; 0: as many as cores
  std::filesystem::path out;               ///< empty: runs/<folder>-<time>
  bool json = false, quiet = false, force = false;
  std::filesystem::path resume;  ///< of an earlier study: goes on with it, by its own options but for budget and jobs
};

/// Runs the study and writes compare.csv (a row per run as each ends), compare.json, compare.html and pictures. Returns
/// 0, or 130 where `stop` turned true, with all outputs of what was done. Throws InputError, FileError.
int run_problem_study(const ProblemStudyOptions& options, const std::function<bool()>& stop);

}  // namespace nilas
