#include "core/scene/check/check_document.h"

#include <algorithm>
#include <set>

#include "core/scene/schema/schema.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

namespace {

std::string listed_or_none(const std::vector<std::string>& names) { return names.empty() ? "none" : joined(names); }

std::string nearest_text(const std::string& near) { return near.empty() ? "" : "; nearest: " + near; }

class DocumentCheck {
 public:
  explicit DocumentCheck(std::vector<Fault>& faults) : faults_(faults) {}

  void check(SceneElement& element, const ElementSpec& spec) {
    if (element.text_place)
      faults_.push_back(
          fault_at(*element.text_place, element.path, "found text; allowed: attributes and elements only"));
    check_attributes(element, spec);
    check_children(element);
  }

 private:
  void check_attributes(SceneElement& element, const ElementSpec& spec) {
    for (auto& attribute : element.attributes) {
      const AttributeSpec* known = find_attribute(spec, attribute.name);
      attribute.valid = known ? check_value(element, attribute, *known) : check_unknown(element, attribute, spec);
    }
    std::erase_if(element.attributes, [&](const auto& attribute) { return !find_attribute(spec, attribute.name); });
    for (const auto& known : spec.attributes)
      if (known.required && !is_named(element, known.name))
        faults_.push_back(fault_at(element.place, where_of(element, known.name),
                                   "the attribute is missing; allowed: " + allowed_text(known)));
  }

  /// Reports an unknown attribute. Returns true only for the attributes that tie an XML file to its schema.
  bool check_unknown(SceneElement& element, const SceneAttribute& attribute, const ElementSpec& spec) {
    const std::string& name = attribute.name;
    if (element.is_root && (name.rfind("xmlns:", 0) == 0 || name.rfind("xsi:", 0) == 0)) return true;
    const auto valid = attribute_names(spec);
    const std::string near = nearest_name(name, valid);
    if (!near.empty()) element.suspects.push_back(near);
    faults_.push_back(fault_at(attribute.place, where_of(element, name),
                               "unknown attribute; allowed: " + listed_or_none(valid) + nearest_text(near)));
    return false;
  }

  bool check_value(const SceneElement& element, const SceneAttribute& attribute, const AttributeSpec& spec) {
    auto problem = value_problem(spec, attribute.value);
    if (!problem && is_not_built(spec, attribute.value)) problem = not_built_text(spec, attribute.value);
    if (problem) faults_.push_back(fault_at(attribute.place, where_of(element, attribute.name), *problem));
    return !problem;
  }

  static std::string not_built_text(const AttributeSpec& spec, const std::string& value) {
    if (!spec.built) return "not built in this version; remove the attribute";
    const std::string found = "'" + value + "' is not built in this version; ";
    std::vector<std::string> built;
    for (const auto& choice : spec.choices)
      if (std::count(spec.not_built.begin(), spec.not_built.end(), choice) == 0) built.push_back(choice);
    return found + "built: " + listed_or_none(built);
  }

  void check_children(SceneElement& element) {
    std::set<std::string> seen;
    std::erase_if(element.children, [&](SceneElement& child) { return !keep_child(element, child, seen); });
    for (const auto* spec : children_of(element.name))
      if (spec->count == Count::one && !is_named(element, spec->name))
        faults_.push_back(fault_of(element, "the element <" + spec->name + "> is missing"));
  }

  bool keep_child(SceneElement& parent, SceneElement& child, std::set<std::string>& seen) {
    const ElementSpec* spec = find_child(parent.name, child.name);
    if (!spec) return report_unknown(parent, child);
    if (!spec->built) {
      faults_.push_back(fault_of(child, "not built in this version; remove the element"));
      return false;
    }
    check(child, *spec);
    if (spec->count == Count::many || seen.insert(child.name).second) return true;
    faults_.push_back(
        fault_of(child, "found a second one; allowed: one <" + child.name + "> in <" + parent.name + ">"));
    return false;
  }

  bool report_unknown(SceneElement& parent, const SceneElement& child) {
    const auto valid = child_names(parent.name);
    const std::string near = nearest_name(child.name, valid);
    if (!near.empty()) parent.suspects.push_back(near);
    const ElementSpec* elsewhere = find_element(child.name);
    const std::string home = elsewhere && !elsewhere->parent.empty()
                                 ? "; <" + child.name + "> belongs in <" + elsewhere->parent + ">"
                                 : nearest_text(near);
    faults_.push_back(fault_of(child, "unknown element here; allowed: " + listed_or_none(valid) + home));
    return false;
  }

  std::vector<Fault>& faults_;
};

}  // namespace

void check_document(SceneElement& root, std::vector<Fault>& faults) {
  DocumentCheck(faults).check(root, *find_element(root.name));
}

}  // namespace nilas::scene
