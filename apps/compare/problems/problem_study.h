#pragma once
/// `nilas compare --problems`: compares solvers on stored contact problems at several tolerances.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace nilas::compare {

struct ProblemStudyOptions {
  std::filesystem::path folder;            ///< folder of FCLIB files
  std::vector<std::string> solvers, laws;  ///< empty: all solvers that take the law, and the law coulomb
  std::vector<double> tolerances;          ///< [m/s]; empty: 1e-2 1e-4 1e-6 1e-8, and 1e-10 up to 50 contacts
  double budget_s = 0;                     ///< wall time for the runs [s]; 0: 1200 s
  int jobs = 0;                            ///< processes at a time; 0: one per core
  std::filesystem::path out;               ///< folder to write; empty: runs/<folder>-<time>
  bool json = false, quiet = false, force = false;
  std::filesystem::path resume;  ///< folder of a study to continue, with its options but for budget and jobs
};

/// Runs the study and writes compare.csv (a row per run as each ends), compare.json, compare.html and pictures. Returns
/// 0, or 130 if `stop` turned true; the outputs then hold what was done. Throws InputError, FileError.
int run_problem_study(const ProblemStudyOptions& options, const std::function<bool()>& stop);

}  // namespace nilas::compare
