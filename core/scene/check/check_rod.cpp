#include <algorithm>

#include "core/choices/contact_choices.h"
#include "core/choices/vessel_choices.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

/// The scene's element that prevents the hull from moving; empty where it can move.
static std::string held_fast(const SceneElement& vessel) {
  if (child_of(vessel, "fixed")) return "<fixed>";
  const SceneElement* carriage = child_of(vessel, "carriage");
  if (!carriage || !words_of(*carriage, "free").empty()) return {};
  const SceneElement* balance = child_of(*carriage, "force_balance");
  if (!balance && is_misspelt(*carriage, "force_balance")) return {};
  const auto kind = balance ? choice_of<BalanceKind>(*balance, "kind") : std::nullopt;
  return !kind || *kind == BalanceKind::rigid ? "<carriage> with force balance 'rigid' and no free axis" : "";
}

static void check_rod(const SceneElement& rod, const SceneElement& vessel, std::vector<Fault>& faults) {
  const auto hull = text_of(vessel, "name"), on = text_of(rod, "on");
  std::vector<std::string> bodies{hull.value_or("")};
  for (const auto& child : vessel.children)
    if (const auto name = text_of(child, "name"); name && child.name == "part") bodies.push_back(*name);
  if (on && std::find(bodies.begin(), bodies.end(), *on) == bodies.end()) {
    std::string names;
    for (const std::string& name : bodies) names += (names.empty() ? "" : ", ") + name;
    faults.push_back(fault_of(rod, "on", "found '" + *on + "'; allowed: the vessel or one of its parts: " + names));
    return;
  }
  const std::string held = held_fast(vessel);
  if (!held.empty() && (!on || *on == bodies.front()))
    faults.push_back(fault_of(rod, held + " holds the hull fast, so a rod on it would do nothing; allowed: a rod on a "
                                          "part, or on a hull that is free, on six-cells or has free axes"));
}

void check_rods(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults) {
  const SceneElement* first = nullptr;
  for (const auto& child : vessel.children) {
    if (child.name != "rod") continue;
    if (first == nullptr) first = &child;
    check_rod(child, vessel, faults);
  }
  for (const auto& child : vessel.children)
    if (first != nullptr && child.name == "part" && text_of(child, "name") == "rod")
      faults.push_back(fault_of(child, "name",
                                "found 'rod', with which the columns of rods in parts.csv begin; with <rod> "
                                "allowed: any other name"));
  const SceneElement* contact = child_of(root, "contact");
  if (first == nullptr || !contact) return;
  if (text_of(*contact, "gyroscopic") == "false")
    faults.push_back(fault_of(*contact, "gyroscopic", "found 'false'; a vessel with <rod> allows: true"));
  if (choice_of<Integrator>(*contact, "integrator") == Integrator::reference)
    faults.push_back(fault_of(*contact, "integrator",
                              "found 'reference', which knows no rods; a vessel with <rod> allows: "
                              "semi-implicit-euler, moreau"));
}

}  // namespace nilas::scene
