#include "core/scene/document/places.h"

#include "core/scene/scene.h"

namespace nilas::scene {

static void add_places(const SceneElement& element, const std::string& path, std::map<std::string, Fault>& places) {
  places.emplace(path, fault_of(element, ""));
  for (const auto& attribute : element.attributes)
    if (attribute.given)
      places.emplace((path.empty() ? "@" : path + "/@") + attribute.name, fault_of(element, attribute.name, ""));
  for (const auto& child : element.children)
    add_places(child, path.empty() ? child.name : path + "/" + child.name, places);
}

std::map<std::string, Fault> places_of(const SceneElement& root) {
  std::map<std::string, Fault> places;
  add_places(root, "", places);
  return places;
}

Fault warning_at(const Scene& scene, const std::string& path, const std::string& message) {
  std::string nearest = path;
  while (!nearest.empty() && !scene.places.contains(nearest)) {
    const auto cut = nearest.rfind('/');
    nearest = cut == std::string::npos ? "" : nearest.substr(0, cut);
  }
  const auto found = scene.places.find(nearest);
  Fault warning = found == scene.places.end() ? fault_at({scene.file.string()}, "", "") : found->second;
  warning.message = message;
  return warning;
}

}  // namespace nilas::scene
