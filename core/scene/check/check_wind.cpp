#include "core/choices/contact_choices.h"
#include "core/choices/wind_choices.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

void check_wind_area(const SceneElement& vessel, std::vector<Fault>& faults) {
  const SceneElement* area = child_of(vessel, "wind_area");
  const auto model = area ? choice_of<WindAreaModel>(*area, "model") : std::nullopt;
  if (!model) return;
  const auto demand = [&](const char* attribute, const char* what) {
    if (!is_named(*area, attribute))
      faults.push_back(
          fault_of(*area, "model '" + name_of(*model) + "' needs " + what + "; allowed: " + attribute + "=\"...\""));
  };
  switch (*model) {
    case WindAreaModel::blendermann:
      demand("ship_type", "the kind of ship");
      break;
    case WindAreaModel::coefficients:
      demand("file", "the file of coefficients");
      break;
  }
}

static void check_jet(const SceneElement& jet, std::vector<Fault>& faults) {
  const bool thruster = is_named(jet, "thruster"), thrust = is_named(jet, "thrust");
  if (thruster == thrust)
    faults.push_back(fault_of(
        jet, std::string("found ") + (thrust ? "both" : "neither") + " of thruster and thrust; allowed: one of them"));
  const auto direction = numbers_of(jet, "direction");
  if (direction && direction->size() == 3 && Vec3::Map(direction->data()).isZero(0))
    faults.push_back(fault_of(jet, "direction", "found 0 0 0; allowed: a vector with a direction"));
}

void check_propeller_wash(const SceneElement& root, const SceneElement& hydro, std::vector<Fault>& faults) {
  const SceneElement *wash = child_of(hydro, "propeller_wash"), *contact = child_of(root, "contact");
  if (!wash) return;
  if (!is_named(root, "vessel"))
    faults.push_back(
        fault_of(*wash, "the scene has no vessel to which a propeller could belong; allowed: with <vessel>"));
  if (!is_named(*wash, "jet")) faults.push_back(fault_of(*wash, "it has no jet; allowed: one <jet> or more of them"));
  if (contact && choice_of<Integrator>(*contact, "integrator") == Integrator::reference)
    faults.push_back(fault_of(*wash,
                              "integrator 'reference' does not take <propeller_wash>, whose jets go on from "
                              "substep to substep; allowed: semi-implicit-euler, moreau"));
  for (const auto& jet : wash->children) check_jet(jet, faults);
}

}  // namespace nilas::scene
