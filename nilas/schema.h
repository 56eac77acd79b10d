#pragma once
/// The table of the scene file: what elements and attributes there are.
#include <string>
#include <vector>

#include "nilas/export.h"

namespace nilas {

struct AttributeInfo {
  std::string name;
  std::string type;                  ///< number, integer, boolean, text, name, words, choice, path or hull
  int min_count = 1, max_count = 1;  ///< numbers or words that its value has; max_count -1: no limit
  std::string unit;                  ///< empty: none
  std::string default_value;         ///< empty: none
  std::string default_note;          ///< about a default that is no fixed value
  std::string allowed;               ///< in words: "3 numbers > 0 [m]"
  std::vector<std::string> choices;
  bool required = false;
  std::string doc;
};

struct ElementInfo {
  std::string name, parent;  ///< the root has no parent
  bool may_repeat = false;
  std::string doc;
  std::vector<AttributeInfo> attributes;
};

/// All elements, parents before children.
NILAS_API std::vector<ElementInfo> scene_schema();

}  // namespace nilas
