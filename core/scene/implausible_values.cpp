#include "core/scene/implausible_values.h"

#include "core/scene/attribute_values.h"
#include "core/scene/values.h"

namespace nilas {

/// Measured coefficients of ice on ice, steel, paint and concrete stay below one.
static void doubt_friction(const SceneElement& contact, std::vector<Fault>& warnings) {
  constexpr double k_largest = 2;
  for (const auto& friction : contact.children)
    for (const char* coefficient : {"static", "kinetic"}) {
      const auto mu = number_of(friction, coefficient);
      if (mu && *mu > k_largest)
        warnings.push_back(fault_of(friction, coefficient,
                                    "found " + format_number(*mu) + "; measured coefficients of ice are below 1"));
    }
}

std::vector<Fault> implausible_values(const SceneElement& root) {
  std::vector<Fault> warnings;
  for (const auto& element : root.children)
    if (element.name == "contact") doubt_friction(element, warnings);
  return warnings;
}

}  // namespace nilas
