#pragma once
/// Types of the scene file's table: elements, attributes, their ranges and conditions.
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace nilas::scene {

/// Types of values. number and integer: `min_count`..`max_count` of them, separated by blanks. words: words separated
/// by blanks, from `choices` if there are any. name: a label without quotes, separators and slashes. path: a file.
/// hull: a hull folder or an STL file. Paths are relative to the scene file's folder.
enum class ValueType { number, integer, boolean, text, name, words, choice, path, hull };

/// Number of such children that a parent may have.
enum class Count { optional, one, many };

struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_inclusive = true, max_inclusive = true;
  bool contains(double x) const;
  /// "> 0", ">= 0 and <= 1"; empty when there is no bound.
  std::string text() const;
};

/// A condition for an effect: the attribute has one of these values. Empty: always.
struct Condition {
  std::string attribute = {};
  std::vector<std::string> values = {};
};

/// A unit that an attribute has where a condition is met.
struct OtherUnit {
  Condition applies = {};
  std::string unit = {};
};

struct AttributeSpec {
  std::string name = {};
  ValueType type = ValueType::number;
  int min_count = 1, max_count = 1;  ///< max_count k_any_count: no upper limit
  std::string unit = {};             ///< empty: none; unit.h reads it
  std::vector<OtherUnit> other_units = {};
  Range range = {};                       ///< range of each number
  std::vector<std::string> choices = {};  ///< "pyramid-k" stands for a pyramid with a number of facets
  std::map<std::string, std::string> old_names =
      {};                          ///< old names of choices, which the reader replaces by present ones
  std::string default_value = {};  ///< empty: none
  std::string default_note = {};   ///< explanation of a default that is no fixed value
  bool required = false;
  Condition applies = {};                   ///< condition on an attribute of the same element
  bool built = true;                        ///< false: naming it is refused
  std::vector<std::string> not_built = {};  ///< choices that are refused
  bool scaled = true;                       ///< false: no physical value, so that --scale leaves it
  bool scaled_file = false;                 ///< of a file: its reader scales it by the scene's `scale`
  std::string doc = {};
};
constexpr int k_any_count = std::numeric_limits<int>::max();

struct ElementSpec {
  std::string name = {};    ///< unique in the table
  std::string parent = {};  ///< empty for the root
  Count count = Count::optional;
  bool always = false;     ///< true: an absent element means its defaults, and the scene as run contains it
  Condition applies = {};  ///< condition on an attribute of the parent
  bool built = true;
  std::string doc = {};
  std::vector<AttributeSpec> attributes = {};
};

}  // namespace nilas::scene
