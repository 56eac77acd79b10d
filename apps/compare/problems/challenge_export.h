#pragma once
/// `nilas problems --export`: hard contact problems as FCLIB files with certified solutions.
#include <filesystem>
#include <functional>

namespace nilas::compare {

struct ProblemExportOptions {
  std::filesystem::path out;     ///< folder to write, which is empty or new unless `force`
  std::filesystem::path scenes;  ///< folder of scenes, whose hardest steps are written; empty: none
  double until_s = 4.5;          ///< largest simulated time of each scene [s]
  bool generated = true;         ///< write the generated challenges too
  int threads = 1;               ///< problems at a time; the files do not depend on it
  bool force = false, json = false, quiet = false;
};

/// Writes a file per problem with the law coulomb, and problems.csv. Each file has the impulses of the first of auto,
/// auto from the guess, and for at most 3000 contacts newton and ipm that reaches 1e-10 m/s, else those of the best.
/// problems.csv has the residual that measure() finds in each file after it is read again. A solution is certified if
/// it is at most 1e-8 m/s. Where the folder of scenes has a folder `jams`, the last step of each scene in it and those
/// 5 and 10 steps before are written, with the warm start that they had as the guess. The hardest step of a scene is
/// the one with most iterations of the solver, and of these the one with most contacts. Returns 0, or 130 if
/// `stop` turned true; the folder then holds what was done. Throws InputError, FileError.
int export_problems(const ProblemExportOptions& options, const std::function<bool()>& stop);

}  // namespace nilas::compare
