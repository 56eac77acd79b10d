#include "core/scene/read/include_mooring.h"

#include <algorithm>

#include "core/base/file_bytes.h"
#include "core/choices/mooring_choices.h"

namespace nilas::scene {

namespace fs = std::filesystem;

void include_mooring(SceneElement& root, const fs::path& scene_file, std::vector<Fault>& faults) {
  SceneElement* vessel = child_of(root, "vessel");
  SceneElement* mooring = vessel ? child_of(*vessel, "mooring") : nullptr;
  const SceneAttribute* file = mooring ? attribute_of(*mooring, "file") : nullptr;
  const SceneAttribute* model = mooring ? attribute_of(*mooring, "model") : nullptr;
  if (!file || (model && model->value == name_of(MooringKind::moordyn))) return;
  const fs::path path = fs::absolute(scene_file).parent_path() / file->value;
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return;
  SceneElement content = parse_document(file_bytes(path, k_most_text_bytes), path.string());
  if (content.name != "mooring") {
    faults.push_back(fault_of(content, "found <" + content.name + "> as the root; allowed: <mooring>"));
    return;
  }
  std::erase_if(mooring->attributes, [](const SceneAttribute& a) { return a.name == "file"; });
  for (const SceneAttribute& attribute : content.attributes)
    if (!attribute_of(*mooring, attribute.name)) mooring->attributes.push_back(attribute);
  for (const SceneElement& child : content.children) {
    SceneElement& copy = mooring->children.emplace_back(make_element(child.name, mooring, child.place));
    copy.attributes = child.attributes;
    copy.text_place = child.text_place;
    if (SceneAttribute* table = attribute_of(copy, "table"))
      table->value = (path.parent_path() / table->value).string();
    for (const SceneElement& grandchild : child.children)
      copy.children.push_back(make_element(grandchild.name, &copy, grandchild.place));
  }
}

}  // namespace nilas::scene
