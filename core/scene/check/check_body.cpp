#include "core/choices/body_choices.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

void check_body(const SceneElement& body, std::vector<Fault>& faults) {
  const auto shape = choice_of<SolidShapeKind>(body, "shape");
  const SceneAttribute* fixed = attribute_of(body, "fixed");
  if (is_named(body, "mass") && is_named(body, "density"))
    faults.push_back(fault_of(body, "density", "found a mass and a density; allowed: one of them"));
  if (shape == SolidShapeKind::mesh && !is_named(body, "mesh"))
    faults.push_back(
        fault_of(body, "mesh", "the attribute is missing; allowed: the path of a hull folder or an STL file"));
  if (shape == SolidShapeKind::plane && fixed->valid && !is_true(body, "fixed"))
    faults.push_back(fault_of(body, "fixed", "found 'false'; a plane is always fixed; allowed: true"));
  for (const char* attribute : {"velocity", "angular_velocity"})
    if (is_true(body, "fixed") && is_given_nonzero(body, attribute))
      faults.push_back(fault_of(body, attribute, "a fixed body does not move; allowed: 0 0 0"));
  check_inertia(body, faults);
}

}  // namespace nilas::scene
