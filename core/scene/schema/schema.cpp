#include "core/scene/schema/schema.h"

#include <algorithm>

#include "core/choices/law.h"
#include "core/scene/spec/values.h"
#include "core/scene/table/schema_table.h"

namespace nilas::scene {

bool Range::contains(double x) const {
  return (min_inclusive ? x >= min : x > min) && (max_inclusive ? x <= max : x < max);
}

std::string Range::text() const {
  const Range unbounded;
  std::string s;
  if (min > unbounded.min) s = (min_inclusive ? ">= " : "> ") + format_number(min);
  if (max < unbounded.max) s += (s.empty() ? "" : " and ") + ((max_inclusive ? "<= " : "< ") + format_number(max));
  return s;
}

const std::vector<ElementSpec>& scene_schema() {
  static const std::vector<ElementSpec> table = [] {
    std::vector<ElementSpec> all;
    using namespace schema_table;
    for (const auto& chapter :
         {run_elements(), contact_elements(), water_elements(), vessel_elements(), wind_elements(), ice_elements(),
          fracture_elements(), body_elements(), output_elements()})
      all.insert(all.end(), chapter.begin(), chapter.end());
    return all;
  }();
  return table;
}

const ElementSpec* find_element(const std::string& name) {
  for (const auto& element : scene_schema())
    if (element.name == name) return &element;
  return nullptr;
}

const ElementSpec* find_child(const std::string& parent, const std::string& name) {
  const ElementSpec* element = find_element(name);
  return element && element->parent == parent ? element : nullptr;
}

const AttributeSpec* find_attribute(const ElementSpec& element, const std::string& name) {
  for (const auto& attribute : element.attributes)
    if (attribute.name == name) return &attribute;
  return nullptr;
}

std::vector<const ElementSpec*> children_of(const std::string& parent) {
  std::vector<const ElementSpec*> children;
  for (const auto& element : scene_schema())
    if (element.parent == parent) children.push_back(&element);
  return children;
}

std::vector<std::string> child_names(const std::string& parent) {
  std::vector<std::string> names;
  for (const auto* child : children_of(parent)) names.push_back(child->name);
  return names;
}

std::vector<std::string> attribute_names(const ElementSpec& element) {
  std::vector<std::string> names;
  for (const auto& attribute : element.attributes) names.push_back(attribute.name);
  return names;
}

std::string matching_choice(const std::vector<std::string>& choices, const std::string& value) {
  for (const auto& choice : choices) {
    const bool counted = choice.size() > 2 && choice.compare(choice.size() - 2, 2, "-k") == 0;
    if (choice == value && !counted) return choice;
    const std::string stem = choice.substr(0, choice.size() - 1);
    if (!counted || value.rfind(stem, 0) != 0) continue;
    // digits alone: parse_law takes neither blanks nor a sign
    const std::string digits = value.substr(stem.size());
    if (digits.find_first_not_of("0123456789") != std::string::npos) continue;
    const auto k = parse_integer(digits);
    if (k && *k >= k_fewest_facets && *k <= k_most_facets) return choice;
  }
  return "";
}

bool is_not_built(const AttributeSpec& attribute, const std::string& value) {
  if (!attribute.built) return true;
  const std::string choice = matching_choice(attribute.choices, trimmed(value));
  return std::count(attribute.not_built.begin(), attribute.not_built.end(), choice) > 0;
}

}  // namespace nilas::scene
