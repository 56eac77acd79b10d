#include "core/scene/document/document.h"

#include <tinyxml2.h>

#include <algorithm>

namespace nilas::scene {

SceneElement make_element(const std::string& name, const SceneElement* parent, const Place& place) {
  SceneElement element;
  element.name = name;
  element.place = place;
  element.is_root = parent == nullptr;
  element.path = (parent && !parent->is_root ? parent->path : "") + "<" + name + ">";
  return element;
}

template <class List>
static auto named(List& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& item) { return item.name == name; });
  return found == list.end() ? nullptr : &*found;
}

SceneAttribute* attribute_of(SceneElement& element, const std::string& name) { return named(element.attributes, name); }
const SceneAttribute* attribute_of(const SceneElement& element, const std::string& name) {
  return named(element.attributes, name);
}
SceneElement* child_of(SceneElement& element, const std::string& name) { return named(element.children, name); }
const SceneElement* child_of(const SceneElement& element, const std::string& name) {
  return named(element.children, name);
}

bool is_named(const SceneElement& element, const std::string& name) {
  const SceneAttribute* attribute = attribute_of(element, name);
  return (attribute && attribute->given) || child_of(element, name) || is_misspelt(element, name);
}

bool is_misspelt(const SceneElement& element, const std::string& name) {
  return std::count(element.suspects.begin(), element.suspects.end(), name) > 0;
}

Fault fault_at(const Place& place, const std::string& where, const std::string& message) {
  return {place.file, place.line, place.column, where, message};
}

Fault fault_of(const SceneElement& element, const std::string& message) {
  return fault_at(element.place, element.path, message);
}

Fault fault_of(const SceneElement& element, const std::string& attribute, const std::string& message) {
  const SceneAttribute* found = attribute_of(element, attribute);
  return fault_at(found && found->given ? found->place : element.place, where_of(element, attribute), message);
}

std::string where_of(const SceneElement& element, const std::string& attribute) {
  return element.path.substr(0, element.path.size() - 1) + " " + attribute + ">";
}

static void print_element(const SceneElement& element, tinyxml2::XMLPrinter& printer) {
  printer.OpenElement(element.name.c_str());
  for (const auto& attribute : element.attributes)
    printer.PushAttribute(attribute.name.c_str(), attribute.value.c_str());
  for (const auto& child : element.children) print_element(child, printer);
  printer.CloseElement();
}

std::string write_document(const SceneElement& root) {
  tinyxml2::XMLPrinter printer;
  printer.PushHeader(false, true);
  print_element(root, printer);
  return printer.CStr();
}

}  // namespace nilas::scene
