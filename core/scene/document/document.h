#pragma once
/// A scene file as a tree of elements with their places, between the XML text and the Scene.
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace nilas::scene {

/// A place in a file. Column 0: unknown. Line 0: not in a file; `file` is then the origin, such as "--set".
struct Place {
  std::string file = {};
  int line = 0, column = 0;  ///< 1-based; columns count characters
};

struct SceneAttribute {
  std::string name = {}, value = {};
  Place place = {};
  bool given = true;  ///< false: a default
  bool valid = true;  ///< false: a fault was reported and the value is meaningless
};

struct SceneElement {
  std::string name = {};
  std::string path = {};  ///< "<contact><friction>", without the root
  bool is_root = false;
  Place place = {};
  std::vector<SceneAttribute> attributes = {};
  std::vector<SceneElement> children = {};
  std::optional<Place> text_place = {};    ///< place of text that is not blank
  std::vector<std::string> suspects = {};  ///< valid names that misspelt attributes and children probably stand for
};

/// An element without content. `parent`: null for the root.
SceneElement make_element(const std::string& name, const SceneElement* parent, const Place& place);

SceneAttribute* attribute_of(SceneElement& element, const std::string& name);
const SceneAttribute* attribute_of(const SceneElement& element, const std::string& name);
SceneElement* child_of(SceneElement& element, const std::string& name);
const SceneElement* child_of(const SceneElement& element, const std::string& name);
/// Whether the file names such an attribute or child, even misspelt.
bool is_named(const SceneElement& element, const std::string& name);
/// Whether the file probably names such an attribute or child, but misspelt. What follows from its absence is no fault
/// of its own then.
bool is_misspelt(const SceneElement& element, const std::string& name);

Fault fault_at(const Place& place, const std::string& where, const std::string& message);
Fault fault_of(const SceneElement& element, const std::string& message);
/// A fault at the attribute if it exists, else at the element.
Fault fault_of(const SceneElement& element, const std::string& attribute, const std::string& message);
/// "<contact><friction static>"
std::string where_of(const SceneElement& element, const std::string& attribute);

/// Parses XML text. Throws SceneError with the place where the text is not well formed.
SceneElement parse_document(const std::string& text, const std::string& file);
/// XML text of the tree.
std::string write_document(const SceneElement& root);

}  // namespace nilas::scene
