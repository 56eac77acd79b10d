#pragma once
/// Runs cases and judges each quantity.
#include <functional>

#include "apps/verify/case.h"

namespace nilas {

/// One line of the table.
struct Row {
  std::string id;        ///< of the case
  std::string quantity;  ///< with its unit
  std::string input;     ///< "as given", or the input that was made 10 % larger
  char family = 'A';
  Model model;
  double measured = 0, expected = 0, error = 0, tolerance = 0;
  double scale = 0;                    ///< that the error is a share of
  double order = 0, proven_order = 0;  ///< over five steps; 0: a discrete closed form, not measured
  bool holds = false;
  std::string message;  ///< why the run could not be made, else empty
};

/// What to run. Empty lists: everything.
struct Selection {
  std::vector<std::string> cases, solvers, laws;
  bool all = false;  ///< every solver with every integrator
};

/// Throws InputError where a case, solver or law is not known or nothing is left to run.
std::vector<const Case*> selected_cases(const Selection& selection);
/// The models that a case runs with.
std::vector<Model> models_of(const Case& one, const Selection& selection);

/// Runs one case with one model and one input set; `vary`: with the varied input.
std::vector<Row> judge(const Case& one, const Model& model, bool vary);

/// All rows of a selection in a fixed order, whatever `threads`. `done`: called with the share that has run.
std::vector<Row> verify(const Selection& selection, int threads, const std::function<void(double)>& done);

}  // namespace nilas
