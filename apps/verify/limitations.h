#pragma once
/// The cost of simplifications of game-engine based simulators: a number from a run with one and a run without it.
#include <optional>
#include <string>
#include <vector>

namespace nilas::verify {

/// A number measured with and without a simplification.
struct Limitation {
  std::string name;      ///< the simplification
  std::string measured;  ///< what is measured, with its unit
  std::string scene;     ///< the scene file and the values that matter
  double with = 0, without = 0;
  std::optional<double> exact = std::nullopt;  ///< empty for a time, which differs from run to run
};

/// Runs and returns all of them.
std::vector<Limitation> limitations();
/// Returns the page docs/evidence/limitations.md. Its numbers have three digits, so that rounding does not change them.
/// Ratios of times have two digits and differ from run to run.
std::string limitations_markdown(const std::vector<Limitation>& all);

}  // namespace nilas::verify
