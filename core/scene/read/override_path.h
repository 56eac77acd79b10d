#pragma once
/// The path of --set: [/][scene/]element[...]/.../@attribute, where [...] is a 1-based number, @name='value', or +.
#include <optional>
#include <string>
#include <vector>

namespace nilas {

struct PathStep {
  std::string element;
  int number = 0;          ///< 0: none given
  bool added = false;      ///< [+]: one that is not in the file
  std::string key, value;  ///< of [@key='value']; key empty: none given
  std::string text;        ///< as written
};

struct OverridePath {
  std::vector<PathStep> steps;  ///< below the root
  std::string attribute;
};

/// Nothing when the text is no path.
std::optional<OverridePath> parse_override_path(const std::string& text);

}  // namespace nilas
