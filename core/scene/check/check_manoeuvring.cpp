#include "core/choices/manoeuvring_choices.h"
#include "core/choices/water_choices.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/elements/manoeuvring_scene.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

static ManoeuvringModel model_of(ManoeuvringPreset preset) {
  switch (preset) {
    case ManoeuvringPreset::kvlcc2:
      return ManoeuvringModel::mmg;
    case ManoeuvringPreset::supply:
      return ManoeuvringModel::derivatives;
  }
  return ManoeuvringModel::mmg;
}

/// The coefficients come from a preset or from a file, and other attributes fit to that.
static void check_ship_coefficients(const SceneElement& element, std::vector<Fault>& faults) {
  const bool preset = is_named(element, "preset"), file = is_named(element, "file");
  if (preset == file)
    faults.push_back(fault_of(element, std::string("found ") + (preset ? "a preset and a file" : "no coefficients") +
                                           "; allowed: preset=\"kvlcc2\" or file=\"ship.csv\""));
  const auto of = choice_of<ManoeuvringPreset>(element, "preset");
  const auto model = choice_of<ManoeuvringModel>(element, "model");
  if (of && model && *model != model_of(*of))
    faults.push_back(fault_of(element, "preset",
                              "found '" + name_of(*of) + "' with model '" + name_of(*model) + "'; allowed: model=\"" +
                                  name_of(model_of(*of)) + "\""));
  const SceneAttribute* length = attribute_of(element, "length");
  if (length && file && !preset)
    faults.push_back(
        fault_of(element, "length", "found with a file, which has its own length_m; allowed: with a preset"));
  if (attribute_of(element, "propulsion") && preset && !file)
    faults.push_back(fault_of(element, "propulsion", "found with a preset, which has its own; allowed: with a file"));
}

/// The hull's forces act on a vessel that nothing holds, in water, and nothing else brings them a second time.
static void check_manoeuvring_surroundings(const SceneElement& root, const SceneElement& vessel,
                                           const SceneElement& element, std::vector<Fault>& faults) {
  for (const char* held : {"carriage", "fixed"})
    if (is_named(vessel, held))
      faults.push_back(fault_of(element, std::string("found <") + held + ">; allowed: a free vessel"));
  const SceneElement* water = child_of(root, "water");
  if (!water && !is_misspelt(root, "water"))
    faults.push_back(fault_of(element, "the scene has no water; allowed: with <water>"));
  if (const SceneElement* current = water ? child_of(*water, "current") : nullptr)
    for (const char* varies : {"profile", "series"})
      if (attribute_of(*current, varies))
        faults.push_back(fault_of(*current, varies,
                                  "found with <manoeuvring>, whose hull meets one velocity of the water; allowed: a "
                                  "uniform current"));
  const SceneElement* hydro = child_of(root, "hydro");
  const SceneElement* added = hydro ? child_of(*hydro, "added_mass") : nullptr;
  if (!added) return;
  const auto of_vessel = choice_of<VesselAddedMass>(*added, "vessel");
  if (of_vessel && *of_vessel != VesselAddedMass::none)
    faults.push_back(fault_of(*added, "vessel",
                              "found '" + name_of(*of_vessel) +
                                  "', but <manoeuvring> brings the added mass of its own model; allowed: none"));
}

static void check_manoeuvre(const SceneElement& vessel, const SceneElement& element, std::vector<Fault>& faults) {
  const SceneElement* manoeuvring = child_of(vessel, "manoeuvring");
  if (!manoeuvring) {
    if (!is_misspelt(vessel, "manoeuvring"))
      faults.push_back(fault_of(element, "nothing here has a rudder and a propeller; allowed: with <manoeuvring>"));
    return;
  }
  if (const SceneElement* control = child_of(vessel, "control"); control && text_of(*control, "mode") == "dp")
    faults.push_back(fault_of(element, "found <control mode=\"dp\">, which gives commands too; allowed: one of them"));
  const auto kind = choice_of<ManoeuvreKind>(element, "kind");
  const auto angle = number_of(element, "angle_deg"), most = number_of(*manoeuvring, "max_rudder_deg");
  if (angle && most && std::abs(*angle) > *most)
    faults.push_back(fault_of(element, "angle_deg",
                              "found " + format_number(*angle) + "; allowed: within max_rudder_deg of <manoeuvring>, " +
                                  format_number(*most) + " [deg]"));
  const auto heading = number_of(element, "heading_deg");
  if (kind == ManoeuvreKind::zigzag && heading && !(*heading > 0))
    faults.push_back(
        fault_of(element, "heading_deg", "found " + format_number(*heading) + " in a zigzag; allowed: > 0 [deg]"));
  if (kind != ManoeuvreKind::course || !attribute_of(element, "file")) return;
  for (const char* replaced : {"heading_deg", "speed"})
    if (attribute_of(element, replaced))
      faults.push_back(fault_of(element, replaced, "found with a file, which has the orders; allowed: one of them"));
}

void check_manoeuvring(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults) {
  if (const SceneElement* element = child_of(vessel, "manoeuvring")) {
    check_ship_coefficients(*element, faults);
    check_manoeuvring_surroundings(root, vessel, *element, faults);
  }
  if (const SceneElement* element = child_of(vessel, "manoeuvre")) check_manoeuvre(vessel, *element, faults);
}

}  // namespace nilas::scene
