#pragma once
/// The runs of cases and the verdict on each quantity.
#include <functional>

#include "apps/verify/case.h"

namespace nilas::verify {

/// A row of the table: one quantity of a case with one model.
struct Row {
  std::string id;        ///< identifier of the case
  std::string quantity;  ///< name with unit
  std::string input;     ///< "as given", or the input that is 10 % larger
  char family = 'A';
  Model model;
  double measured = 0, expected = 0, error = 0, tolerance = 0;
  double scale = 0;                    ///< The error is |measured - expected| / scale.
  double order = 0, proven_order = 0;  ///< measured over five steps, and expected; 0 where there is none
  bool holds = false;
  std::string message;  ///< why the run failed, else empty
};

/// The cases, solvers and laws to run. An empty list selects all.
struct Selection {
  std::vector<std::string> cases, solvers, laws;
  bool all = false;  ///< every solver with every integrator
};

/// Returns the selected cases. Throws InputError for an unknown case or family.
std::vector<const Case*> selected_cases(const Selection& selection);
/// Returns the models with which a case runs.
std::vector<Model> models_of(const Case& one, const Selection& selection);

/// Runs one case with one model and returns a row per quantity. `vary`: the varied input is 10 % larger. A run that
/// fails gives one row with a message. Throws FileError if a scene is missing.
std::vector<Row> judge(const Case& one, const Model& model, bool vary);

/// Runs a selection and returns its rows in a fixed order, which does not depend on `threads`. `done` is called with
/// the share of runs that has begun. Throws InputError for an unknown case, solver or law, or where nothing is left to
/// run.
std::vector<Row> verify(const Selection& selection, int threads, const std::function<void(double)>& done);

}  // namespace nilas::verify
