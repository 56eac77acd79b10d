#include "core/scene/read/overrides.h"

#include "core/scene/read/override_path.h"
#include "core/scene/schema/schema.h"

namespace nilas::scene {

namespace {

const std::string k_source = "--set";

/// Sets one attribute of the tree.
class OneOverride {
 public:
  OneOverride(SceneElement& root, const std::string& path, std::vector<Fault>& faults)
      : root_(root), path_(path), faults_(faults) {}

  void set(const std::string& value) {
    const auto path = parse_override_path(path_);
    if (!path)
      return report(
          "this is no path; allowed: element/element[number]/element[@name='value']/element[+]/@attribute, as in "
          "contact/@tolerance");
    SceneElement* element = &root_;
    for (const auto& step : path->steps)
      if (!(element = enter(*element, step))) return;
    set_attribute(*element, path->attribute, value);
  }

 private:
  void report(const std::string& message) { faults_.push_back({k_source, 0, 0, path_, message}); }

  void report_unknown(const std::string& kind, const std::string& holder, const std::string& word,
                      const std::vector<std::string>& valid) {
    std::string allowed;
    for (const auto& name : valid) allowed += (allowed.empty() ? "" : ", ") + name;
    const std::string near = nearest_name(word, valid);
    report("<" + holder + "> has no " + kind + " '" + word + "'; allowed: " + (allowed.empty() ? "none" : allowed) +
           (near.empty() ? "" : "; nearest: " + near));
  }

  /// The child that a step names. A missing optional child is created; null after a report.
  SceneElement* enter(SceneElement& parent, const PathStep& step) {
    const ElementSpec* spec = find_child(parent.name, step.element);
    if (!spec) {
      report_unknown("element", parent.name, step.element, child_names(parent.name));
      return nullptr;
    }
    std::vector<SceneElement*> same;
    for (auto& child : parent.children)
      if (child.name == step.element) same.push_back(&child);
    if (step.added) return added(parent, step, *spec, same);
    if (!step.key.empty()) return with_value(parent, step, same);
    if (step.number > 0) return numbered(parent, step, same);
    if (same.size() == 1) return same.front();
    if (same.empty() && spec->count != Count::many)
      return &parent.children.emplace_back(make_element(step.element, &parent, {k_source}));
    report(holds(parent, step, same.size()) + (same.empty() ? "" : "; say which, as in " + step.element + "[1]"));
    return nullptr;
  }

  SceneElement* added(SceneElement& parent, const PathStep& step, const ElementSpec& spec,
                      const std::vector<SceneElement*>& same) {
    if (spec.count != Count::many) {
      report("<" + parent.name + "> may hold one <" + step.element + "> only; [+] is for elements of any number");
      return nullptr;
    }
    if (!same.empty() && same.back()->place.file == k_source) return same.back();
    return &parent.children.emplace_back(make_element(step.element, &parent, {k_source}));
  }

  static std::string holds(const SceneElement& parent, const PathStep& step, std::size_t count) {
    return "<" + parent.name + "> holds " + (count == 0 ? "no" : std::to_string(count)) + " <" + step.element + ">";
  }

  SceneElement* numbered(const SceneElement& parent, const PathStep& step, const std::vector<SceneElement*>& same) {
    const auto number = static_cast<std::size_t>(step.number);
    if (number <= same.size()) return same[number - 1];
    report(holds(parent, step, same.size()) + ", so there is no number " + std::to_string(number));
    return nullptr;
  }

  SceneElement* with_value(const SceneElement& parent, const PathStep& step, const std::vector<SceneElement*>& same) {
    std::vector<std::string> values;
    std::vector<SceneElement*> matching;
    for (auto* child : same) {
      const SceneAttribute* key = attribute_of(*child, step.key);
      if (key) values.push_back(key->value);
      if (key && key->value == step.value) matching.push_back(child);
    }
    if (matching.size() == 1) return matching.front();
    const std::string near = nearest_name(step.value, values);
    report(holds(parent, step, same.size()) + ", " + std::to_string(matching.size()) + " with " + step.key + " '" +
           step.value + "'; one is needed" + (matching.empty() && !near.empty() ? "; nearest: " + near : ""));
    return nullptr;
  }

  void set_attribute(SceneElement& element, const std::string& name, const std::string& value) {
    const ElementSpec& spec = *find_element(element.name);
    if (!find_attribute(spec, name)) return report_unknown("attribute", element.name, name, attribute_names(spec));
    SceneAttribute* attribute = attribute_of(element, name);
    if (!attribute) attribute = &element.attributes.emplace_back();
    *attribute = {.name = name, .value = value, .place = {k_source}};
  }

  SceneElement& root_;
  const std::string& path_;
  std::vector<Fault>& faults_;
};

}  // namespace

void apply_overrides(SceneElement& root, const Overrides& overrides, std::vector<Fault>& faults) {
  for (const auto& [path, value] : overrides) OneOverride(root, path, faults).set(value);
}

}  // namespace nilas::scene
