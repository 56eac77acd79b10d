#pragma once
/// What each simplification of older tools does to a number, beside the same run without it.
#include <optional>
#include <string>
#include <vector>

namespace nilas {

struct Limitation {
  std::string name;      ///< the simplification
  std::string measured;  ///< what, with its unit
  std::string scene;     ///< and what of it differs from the file
  double with = 0, without = 0;
  std::optional<double> exact = std::nullopt;  ///< none of a time, which is another one in every run
};

/// Runs all of them.
std::vector<Limitation> limitations();
/// The page docs/evidence/limitations.md; three digits, so that rounding does not change it. Times have two, and do
/// change.
std::string limitations_markdown(const std::vector<Limitation>& all);

}  // namespace nilas
