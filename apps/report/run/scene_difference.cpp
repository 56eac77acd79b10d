#include "apps/report/run/scene_difference.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <map>

#include "core/base/error.h"

namespace nilas::report {

namespace {

using SceneElement = tinyxml2::XMLElement;

/// Values of the attributes by their paths, in the order of the file.
struct FlatScene {
  std::vector<std::string> order;
  std::map<std::string, std::string> values;
};

/// Number of an element among its siblings of the same name, from 1.
int number_before(const SceneElement& element) {
  int number = 1;
  for (const auto* e = element.PreviousSiblingElement(element.Name()); e != nullptr;
       e = e->PreviousSiblingElement(element.Name()))
    ++number;
  return number;
}

std::string step_to(const SceneElement& element) {
  // The same path with and without siblings, so that the scenes of a comparison name the same element alike.
  const int number = number_before(element);
  const std::string kind = element.Name();
  if (const char* name = element.Attribute("name"); name != nullptr && kind != "vessel")
    return fmt::format("{}[@name='{}']", kind, name);
  if (const char* between = element.Attribute("between")) return fmt::format("{}[@between='{}']", kind, between);
  return number == 1 ? kind : fmt::format("{}[{}]", kind, number);
}

void flatten(const SceneElement& element, const std::string& path, FlatScene& flat) {
  for (const auto* attribute = element.FirstAttribute(); attribute != nullptr; attribute = attribute->Next()) {
    const std::string name = path + "@" + attribute->Name();
    if (flat.values.emplace(name, attribute->Value()).second) flat.order.push_back(name);
  }
  for (const auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
    flatten(*child, path + step_to(*child) + "/", flat);
}

}  // namespace

std::vector<SceneDifference> scene_differences(const std::vector<std::string>& scenes) {
  std::vector<FlatScene> all;
  std::vector<std::string> paths;
  for (const std::string& text : scenes) {
    tinyxml2::XMLDocument document;
    if (document.Parse(text.c_str(), text.size()) != tinyxml2::XML_SUCCESS || document.RootElement() == nullptr)
      throw InputError("scene.xml: cannot be compared: " + std::string(document.ErrorStr()));
    flatten(*document.RootElement(), "", all.emplace_back());
    for (const std::string& path : all.back().order)
      if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
  }
  std::vector<SceneDifference> differences;
  for (const std::string& path : paths) {
    if (path.starts_with("output/") && path != "output/@statistics" && path != "output/@peak_filter") continue;
    SceneDifference difference{path, {}};
    for (const FlatScene& flat : all) {
      const auto found = flat.values.find(path);
      difference.values.push_back(found == flat.values.end() ? "" : found->second);
    }
    const auto same = [&](const std::string& value) { return value == difference.values.front(); };
    if (!std::all_of(difference.values.begin(), difference.values.end(), same)) differences.push_back(difference);
  }
  return differences;
}

}  // namespace nilas::report
