#pragma once
/// The table of the scene file: every element and attribute with type, unit, range, default and documentation. The
/// reader's checks, the XML schema (XSD), the scene reference and the valid --set paths follow from it.
#include <optional>
#include <string>
#include <vector>

#include "core/scene/spec/element_spec.h"

namespace nilas::scene {

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
/// The unit with those that hold under conditions: "N m/rad; with slider N/m". Empty: none.
std::string unit_text(const AttributeSpec& attribute);
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
