#pragma once
/// nilas compare SCENE: from what is asked to a folder with tables, pictures and a page.
#include <functional>
#include <optional>

#include "apps/compare/scenes/plan/grid.h"

namespace nilas {

struct StudyOptions {
  std::filesystem::path scene;
  Overrides overrides;  ///< the user's own, as --set takes them
  GridRequest grid;
  std::optional<int> realisations;         ///< default 3
  std::string reference = "auto";          ///< or a run folder
  double reference_tolerance = 1e-10;      ///< [m/s]
  bool fixed_reference_tolerance = false;  ///< it is not loosened to fit the budget
  std::optional<double> budget_s;          ///< wall time; 0: no limit; default 1200, of a resumed study its own [s]
  int jobs = 0;                            ///< 0: one per core
  std::string out, resume;
  bool force = false, json = false, quiet = false, keep_runs = false;
};

/// Runs or goes on. `stop` turns true when the user wants it to end: what is done is then written. Returns the exit
/// code. Throws as read_scene, InputError, FileError.
int run_study(const StudyOptions& options, const std::function<bool()>& stop);

}  // namespace nilas
