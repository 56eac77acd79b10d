#pragma once
/// A case with a known answer: a scene, its inputs, and what is measured in the run beside what the formula says.
#include <string>
#include <vector>

namespace nilas {

/// Law, solver and time stepping of one run.
struct Model {
  std::string law = "coulomb";
  std::string solver = "auto";
  std::string integrator = "semi-implicit-euler";
  double step = 0.01;  ///< [s]

  /// Share of the step's motion that follows the impulses.
  double theta() const { return integrator == "semi-implicit-euler" ? 1 : 0.5; }
  /// Integrated between events, as if the steps were infinitely small.
  bool continuous() const { return integrator == "reference"; }
};

/// A number that a case is set up with.
struct Input {
  std::string name;
  double value = 0;
  std::string unit;
};

/// What one run gave and what it should have.
struct Quantity {
  std::string name;  ///< with its unit
  double measured = 0, expected = 0;
  double scale = 0;    ///< error = |measured - expected| / scale; 0: |expected|
  bool exact = false;  ///< judged by the case's tolerance even where an order is proven
};

class Setting;

/// One case of the catalogue. All that is expected is computed from the inputs, for the law that is asked: the artefact
/// of a wrong model is an expected value too.
struct Case {
  int number = 0;
  char family = 'A';
  std::string title, formula, source;
  std::string scene;                ///< file in apps/scenes/verify
  std::vector<std::string> also{};  ///< other files there that the check runs
  std::vector<Input> inputs;
  std::string varied;  ///< the input that a second run has 10 % larger
  std::vector<Quantity> (*check)(const Setting& setting) = nullptr;

  std::vector<std::string> laws{"coulomb"};
  std::vector<std::string> solvers{};  ///< empty: those that take the law
  std::vector<std::string> integrators{"semi-implicit-euler", "moreau"};
  bool reference = false;   ///< runs with the integrator `reference` and `auto`, too
  double step = 0.01;       ///< [s]
  double tolerance = 1e-9;  ///< of the error; where a proven order is given, of a discrete closed form alone
  /// Where only the limit of small steps is known: the order at which the error falls, per integrator. Then five steps
  /// are run, each half of the one before.
  std::vector<double> orders{};
  std::vector<double> coarsest{};    ///< where orders are given: largest error allowed at the first of the five steps
  double contact_tolerance = 1e-12;  ///< of the solver, on law_map_m_s [m/s]
  int contact_iterations = 100000;

  std::string note{};  ///< what is left out and why

  std::string id() const { return family + std::to_string(number); }
};

/// Families A to H.
std::string family_title(char family);

/// All cases by number.
const std::vector<Case>& catalogue();

}  // namespace nilas
