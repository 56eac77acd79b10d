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

/// An elastic pair needs a stiffness unless ice gives it, and bounces by its springs alone.
static void check_elastic(const SceneElement& friction, std::vector<Fault>& faults) {
  if (text_of(friction, "elastic") != "true") return;
  if (number_of(friction, "restitution").value_or(0) > 0)
    faults.push_back(
        fault_of(friction, "restitution", "an elastic pair bounces by its stiffness and damping_ratio; allowed: 0"));
  const auto pair = words_of(friction, "between");
  const auto may_be_ice = [](const std::string& material) { return material == "ice" || material == "*"; };
  if (!pair.empty() && !number_of(friction, "stiffness") && std::none_of(pair.begin(), pair.end(), may_be_ice))
    faults.push_back(
        fault_of(friction, "stiffness",
                 "the attribute is missing: elastic contacts of materials other than ice need it; allowed: "
                 "a number above 0 [N/m]"));
}

void check_friction(const SceneElement& root, const SceneElement& contact, std::vector<Fault>& faults) {
  const auto known = known_materials(root);
  std::map<std::vector<std::string>, int> line_of_pair;
  for (const auto& friction : contact.children) {
    check_coefficients(friction, faults);
    check_elastic(friction, faults);
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
