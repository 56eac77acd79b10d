#include <algorithm>
#include <map>

#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

static std::vector<std::string> known_materials(const SceneElement& root) {
  std::vector<std::string> names{"ice", "hull", "wall", "structure", "*"};
  const auto add = [&](const SceneElement& element) {
    for (const auto& material : words_of(element, "material")) names.push_back(material);
  };
  for (const auto& element : root.children) {
    if (element.name == "body") add(element);
    if (element.name != "vessel") continue;
    for (const auto& child : element.children)
      if (child.name == "part") add(child);
  }
  return names;
}

static void check_coefficients(const SceneElement& friction, std::vector<Fault>& faults) {
  if (!is_named(friction, "static") && !is_named(friction, "kinetic"))
    faults.push_back(fault_of(friction, "static", "the attribute is missing; allowed: static, kinetic or both"));
  const auto mu_s = number_of(friction, "static"), mu_k = number_of(friction, "kinetic");
  if (mu_s && mu_k && *mu_s < *mu_k)
    faults.push_back(fault_of(friction, "static",
                              "found " + format_number(*mu_s) + " with kinetic " + format_number(*mu_k) +
                                  "; allowed: not below the kinetic coefficient"));
}

void check_friction(const SceneElement& root, const SceneElement& contact, std::vector<Fault>& faults) {
  const auto known = known_materials(root);
  std::map<std::vector<std::string>, int> line_of_pair;
  for (const auto& friction : contact.children) {
    check_coefficients(friction, faults);
    auto pair = words_of(friction, "between");
    if (pair.empty()) continue;
    for (const auto& material : pair) {
      if (std::count(known.begin(), known.end(), material) > 0) continue;
      const std::string near = nearest_name(material, known);
      faults.push_back(fault_of(friction, "between",
                                "nothing in the scene is made of '" + material +
                                    "'; allowed: ice, hull, wall, structure, * and the materials of bodies and parts" +
                                    (near.empty() ? "" : "; nearest: " + near)));
    }
    std::sort(pair.begin(), pair.end());
    if (!line_of_pair.emplace(pair, friction.place.line).second)
      faults.push_back(
          fault_of(friction, "between", "the pair is already named in line " + std::to_string(line_of_pair[pair])));
  }
}

}  // namespace nilas::scene
