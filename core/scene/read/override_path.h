#pragma once
/// The path of --set: [/][scene/]element[...]/.../@attribute, where [...] is a 1-based number, @name='value', or +.
#include <optional>
#include <string>
#include <vector>

namespace nilas::scene {

struct PathStep {
  std::string element;
  int number = 0;          ///< number; 0: none given
  bool added = false;      ///< [+]: a new element that is not in the file
  std::string key, value;  ///< key and value of [@key='value']; empty key: none given
  std::string text;        ///< as written
};

struct OverridePath {
  std::vector<PathStep> steps;  ///< below the root
  std::string attribute;
};

/// Parses a path; empty when the text is no path.
std::optional<OverridePath> parse_override_path(const std::string& text);

}  // namespace nilas::scene
