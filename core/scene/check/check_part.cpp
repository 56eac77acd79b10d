#include <algorithm>

#include "core/choices/body_choices.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/schema/schema.h"

namespace nilas::scene {

/// Refuses attributes that the joint does not use, such as a spring in a weld or an angle of a slider.
static void check_joint(const SceneElement& part, std::vector<Fault>& faults) {
  const auto joint = text_of(part, "joint");
  if (!joint) return;
  for (const SceneAttribute& attribute : part.attributes) {
    const AttributeSpec* spec = find_attribute(*find_element("part"), attribute.name);
    if (!attribute.given || spec == nullptr || spec->applies.attribute != "joint") continue;
    const auto& joints = spec->applies.values;
    if (std::find(joints.begin(), joints.end(), *joint) != joints.end()) continue;
    std::string names;
    for (const std::string& name : joints) names += (names.empty() ? "" : ", ") + name;
    faults.push_back(
        fault_of(part, attribute.name, "it has no effect with joint '" + *joint + "'; allowed with: " + names));
  }
}

static void check_part(const SceneElement& part, const std::vector<std::string>& before, std::vector<Fault>& faults) {
  if (is_named(part, "mass") && is_named(part, "density"))
    faults.push_back(fault_of(part, "density", "found a mass and a density; allowed: one of them"));
  if (choice_of<SolidShapeKind>(part, "shape") == SolidShapeKind::mesh && !is_named(part, "mesh"))
    faults.push_back(
        fault_of(part, "mesh", "the attribute is missing; allowed: the path of a hull folder or an STL file"));
  const auto axis = numbers_of(part, "axis");
  if (axis && std::all_of(axis->begin(), axis->end(), [](double x) { return x == 0; }))
    faults.push_back(fault_of(part, "axis", "found an axis without length; allowed: a direction"));
  const auto to = text_of(part, "to");
  if (to && std::find(before.begin(), before.end(), *to) == before.end()) {
    std::string names;
    for (const std::string& name : before) names += (names.empty() ? "" : ", ") + name;
    faults.push_back(
        fault_of(part, "to", "found '" + *to + "'; allowed: the vessel or a part before this one: " + names));
  }
  check_joint(part, faults);
  check_inertia(part, faults);
}

void check_parts(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults) {
  std::vector<std::string> before;
  const SceneElement* first = nullptr;
  if (const auto name = text_of(vessel, "name")) before.push_back(*name);
  for (const auto& child : vessel.children) {
    if (child.name != "part") continue;
    if (first == nullptr) first = &child;
    check_part(child, before, faults);
    if (const auto name = text_of(child, "name")) before.push_back(*name);
  }
  if (first == nullptr) return;
  const SceneElement* mass = child_of(vessel, "mass");
  if (mass ? !is_named(*mass, "value") : !is_misspelt(vessel, "mass"))
    faults.push_back(fault_of(
        *first, "with parts the mass of the hull cannot follow from the water; allowed: <mass value=\"...\">"));
  const auto position = numbers_of(vessel, "position");
  if (position && position->size() != 3)
    faults.push_back(fault_of(vessel, "position", "found 2 numbers; with <part> allowed: 3 numbers [m]"));
  const SceneElement* contact = child_of(root, "contact");
  if (contact && text_of(*contact, "gyroscopic") == "false")
    faults.push_back(fault_of(*contact, "gyroscopic", "found 'false'; a vessel with <part> allows: true"));
}

}  // namespace nilas::scene
