#pragma once
/// nilas problems --export: contact problems worth solving, as FCLIB files with certified solutions.
#include <filesystem>

namespace nilas {

struct ProblemExportOptions {
  std::filesystem::path out;     ///< empty or new, unless `force`
  std::filesystem::path scenes;  ///< folder of scenes; of each its hardest step is written; empty: none
  double until_s = 4.5;          ///< simulated time of each scene at most [s]
  bool generated = true;         ///< write the generated challenges too
  int threads = 1;               ///< problems at a time; the files do not depend on it
  bool force = false, json = false, quiet = false;
};

/// Writes a file per problem, law coulomb, with the impulses of the first of auto, newton and ipm that reaches 1e-10
/// m/s, else of the best of them, and problems.csv with the residual that measure() finds in each file as read back. A
/// solution is certified up to 1e-8 m/s. The hardest step of a scene is the one whose solver took most iterations, of
/// these the one with most contacts. Returns the exit code 0. Throws InputError, FileError.
int export_problems(const ProblemExportOptions& options);

}  // namespace nilas
