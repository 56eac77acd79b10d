#pragma once
/// The table of the scene file: every element and attribute with type, unit, range, default and documentation. The
/// reader's checks, the XML schema (XSD), the scene reference and the valid --set paths follow from it.
#include <limits>
#include <map>
#include <optional>
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

struct AttributeSpec {
  std::string name = {};
  ValueType type = ValueType::number;
  int min_count = 1, max_count = 1;       ///< max_count k_any_count: no upper limit
  std::string unit = {};                  ///< empty: none
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
  std::string remark = {};  ///< printed once when the element is present
  std::string doc = {};
  std::vector<AttributeSpec> attributes = {};
};

/// The table, parents before children.
const std::vector<ElementSpec>& scene_schema();

/// The element with this name; null when the table has none.
const ElementSpec* find_element(const std::string& name);
/// The child with this name; null when `parent` has no such child.
const ElementSpec* find_child(const std::string& parent, const std::string& name);
const AttributeSpec* find_attribute(const ElementSpec& element, const std::string& name);
std::vector<const ElementSpec*> children_of(const std::string& parent);
std::vector<std::string> child_names(const std::string& parent);
std::vector<std::string> attribute_names(const ElementSpec& element);

/// The entry of `choices` that matches `value` ("pyramid-8" matches "pyramid-k"); empty when there is none.
std::string matching_choice(const std::vector<std::string>& choices, const std::string& value);
/// Description of an attribute's allowed values: "3 numbers > 0 [m]".
std::string allowed_text(const AttributeSpec& attribute);
/// The fault of a value (found, allowed, nearest name), if any. Does not check what is built.
std::optional<std::string> value_problem(const AttributeSpec& attribute, const std::string& value);
/// Whether a valid value names something that does not exist in this version.
bool is_not_built(const AttributeSpec& attribute, const std::string& value);

/// The XML schema, as printed by `nilas schema --xsd`. It accepts everything that the reader accepts, and what is not
/// built yet. Only the reader checks relations between values.
std::string schema_xsd();
/// The scene reference page, in Markdown.
std::string schema_markdown();

}  // namespace nilas::scene
