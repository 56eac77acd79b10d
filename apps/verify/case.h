#pragma once
/// A case with a known answer: a scene, its inputs, and a check that compares runs of the scene with a formula.
#include <string>
#include <vector>

namespace nilas::verify {

/// The law, solver, integrator and step of one run.
struct Model {
  std::string law = "coulomb";
  std::string solver = "auto";
  std::string integrator = "semi-implicit-euler";
  double step = 0.01;  ///< [s]

  /// Returns the share of the step's motion that follows the impulses.
  double theta() const { return integrator == "semi-implicit-euler" ? 1 : 0.5; }
  /// Whether the run goes from event to event, so that the formulas of continuous time hold.
  bool continuous() const { return integrator == "reference"; }
};

/// A number that sets up a case.
struct Input {
  std::string name;
  double value = 0;
  std::string unit;
};

/// A measured value and the value that the formula gives.
struct Quantity {
  std::string name;  ///< with its unit
  double measured = 0, expected = 0;
  double scale = 0;    ///< The error is |measured - expected| / scale. 0 stands for |expected|.
  bool exact = false;  ///< The case's tolerance judges this quantity even where the case has an order.
};

class Setting;

/// One case of the catalogue. Its expected values follow from the inputs, for the law of the run. Where a simplified
/// law has an artefact, the expected value includes it.
struct Case {
  int number = 0;
  char family = 'A';
  std::string title, formula, source;
  std::string scene;                ///< the file in apps/scenes/verify
  std::vector<std::string> also{};  ///< other files there that the check runs too
  std::vector<Input> inputs;
  std::string varied;  ///< the input that is 10 % larger in a second run
  std::vector<Quantity> (*check)(const Setting& setting) = nullptr;

  std::vector<std::string> laws{"coulomb"};
  std::vector<std::string> solvers{};  ///< empty: all that take the law
  std::vector<std::string> integrators{"semi-implicit-euler", "moreau"};
  bool reference = false;   ///< The case also runs with integrator `reference` and solver `auto`.
  double step = 0.01;       ///< [s]
  double tolerance = 1e-9;  ///< largest error; where an order is given, of quantities that are `exact` only
  /// The proven order at which the error falls with the step, per integrator; empty or 0 where the formula holds for
  /// the step itself. With an order the case runs at five steps, each half of the one before.
  std::vector<double> orders{};
  std::vector<double> coarsest{};    ///< per integrator with an order: largest error at the first of the five steps
  double contact_tolerance = 1e-12;  ///< tolerance of the solver on law_map_m_s [m/s]
  int contact_iterations = 100000;

  std::string note{};  ///< a remark, such as which solvers are left out and why

  std::string id() const { return family + std::to_string(number); }
};

/// Returns the title of a family, 'A' to 'I'. Throws ContractError for any other letter.
std::string family_title(char family);

/// Returns all cases, sorted by number.
const std::vector<Case>& catalogue();

}  // namespace nilas::verify
