#include "core/scene/read/old_names.h"

#include "core/scene/schema/schema.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

/// Calls for every attribute of the tree whose choices have old names.
template <class Call>
static void for_each_renamed(SceneElement& element, const Call& call) {
  if (const ElementSpec* spec = find_element(element.name))
    for (auto& attribute : element.attributes)
      if (const AttributeSpec* known = find_attribute(*spec, attribute.name); known && !known->old_names.empty())
        call(element, attribute, known->old_names);
  for (auto& child : element.children) for_each_renamed(child, call);
}

std::vector<Fault> replace_old_names(SceneElement& root) {
  std::vector<Fault> warnings;
  for_each_renamed(root, [&](const SceneElement& element, SceneAttribute& attribute, const auto& old_names) {
    const auto found = old_names.find(trimmed(attribute.value));
    if (found == old_names.end()) return;
    warnings.push_back(fault_of(element, attribute.name,
                                "'" + found->first + "' is now called '" + found->second + "'; use the new name"));
    attribute.value = found->second;
  });
  return warnings;
}

void restore_old_names(SceneElement& root) {
  for_each_renamed(root, [](const SceneElement&, SceneAttribute& attribute, const auto& old_names) {
    for (const auto& [old_name, name] : old_names)
      if (attribute.value == name) attribute.value = old_name;
  });
}

std::string moved_scene(const std::filesystem::path& file) {
  constexpr const char *k_old = "seed-2014.xml", *k_new = "metrikin-2014.xml";
  const auto now = file.parent_path() / k_new;
  std::error_code ignored;
  if (file.filename() != k_old || !std::filesystem::exists(now, ignored)) return "";
  return "; the scene is now " + now.string();
}

}  // namespace nilas::scene
