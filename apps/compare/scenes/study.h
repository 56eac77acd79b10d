#pragma once
/// `nilas compare SCENE`: makes the runs of a comparison and writes a folder with tables, pictures and a page.
#include <functional>
#include <optional>

#include "apps/compare/scenes/plan/grid.h"

namespace nilas::compare {

struct StudyOptions {
  std::filesystem::path scene;
  scene::Overrides overrides;  ///< the user's overrides, as --set takes them
  GridRequest grid;
  std::optional<int> realisations;         ///< number of realisations; default 3
  std::string reference = "auto";          ///< "auto" or a run folder
  double reference_tolerance = 1e-10;      ///< tolerance of the reference's solver [m/s]
  bool fixed_reference_tolerance = false;  ///< the tolerance is not loosened to fit the budget
  std::optional<double> budget_s;          ///< wall time [s]; 0: no limit; default: 1200, or that of a resumed study
  int jobs = 0;                            ///< runs at a time; 0: one per core
  std::string out, resume;
  bool force = false, json = false, quiet = false, keep_runs = false;
};

/// Makes a comparison or continues one. `stop` turns true when the user wants it to end; what is done is then written.
/// Returns the exit code. Throws as read_scene() does, and InputError and FileError.
int run_study(const StudyOptions& options, const std::function<bool()>& stop);

}  // namespace nilas::compare
