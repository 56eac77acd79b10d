#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

static void check_hull(const SceneElement& vessel, std::vector<Fault>& faults) {
  const SceneElement* generated = child_of(vessel, "hull");
  if (attribute_of(vessel, "hull") && generated)
    faults.push_back(fault_of(*generated, "found a hull folder and a generated hull; allowed: one of them"));
  if (!is_named(vessel, "hull"))
    faults.push_back(
        fault_of(vessel, "the vessel has no hull; allowed: hull=\"FOLDER\" or <hull generate=\"icebreaker\"/>"));
}

static void check_motion(const SceneElement& vessel, std::vector<Fault>& faults) {
  const SceneElement* carriage = child_of(vessel, "carriage");
  const SceneElement* fixed = child_of(vessel, "fixed");
  if (carriage && fixed)
    faults.push_back(
        fault_of(*fixed, "found <carriage> and <fixed>; allowed: one of them, or neither for a free vessel"));
  if (carriage || fixed) {
    for (const char* attribute : {"velocity", "angular_velocity"})
      if (is_given_nonzero(vessel, attribute))
        faults.push_back(fault_of(vessel, attribute, "only a free vessel takes an initial velocity; allowed: 0 0 0"));
  }
}

/// Requires water where the mass or the height follows from it.
static void check_flotation(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults) {
  const bool water = is_named(root, "water");
  const SceneElement* mass = child_of(vessel, "mass");
  if (!mass && is_misspelt(vessel, "mass")) return;
  const bool by_value = mass && is_named(*mass, "value"), by_draught = mass && is_named(*mass, "draught");
  if (by_value && by_draught)
    faults.push_back(fault_of(*mass, "draught", "found a mass and a draught; allowed: one of them"));
  if (!water && !by_value) faults.push_back(fault_of(vessel, "without <water> the vessel needs <mass value=\"...\">"));
  const auto position = numbers_of(vessel, "position");
  if (!position || position->size() != 2) return;
  if (!water)
    faults.push_back(fault_of(vessel, "position", "found 2 numbers; without <water> allowed: 3 numbers [m]"));
  else if (!by_value && !by_draught)
    faults.push_back(fault_of(vessel, "position",
                              "found 2 numbers, so the height follows from the mass; allowed: 3 numbers, or <mass> "
                              "with value or draught"));
}

void check_vessel(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults) {
  check_hull(vessel, faults);
  check_motion(vessel, faults);
  check_flotation(root, vessel, faults);
  check_parts(root, vessel, faults);
  check_rods(root, vessel, faults);
  check_thrusters(root, vessel, faults);
  check_manoeuvring(root, vessel, faults);
  check_mooring(root, vessel, faults);
  check_remote_control(root, vessel, faults);
  if (const SceneElement* mass = child_of(vessel, "mass")) check_inertia(*mass, faults);
}

}  // namespace nilas::scene
