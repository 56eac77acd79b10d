#include "core/scene/check/implausible_values.h"

#include "core/scene/schema/attribute_values.h"
#include "core/scene/schema/values.h"

namespace nilas::scene {

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

static void doubt_statistics(const SceneElement& root, const SceneElement& output, std::vector<Fault>& warnings) {
  const SceneElement* time = child_of(root, "time");
  const auto window = numbers_of(output, "statistics");
  if (!time || !window) return;
  const auto start = number_of(*time, "start"), end = number_of(*time, "end");
  if (!start || !end || (window->at(1) > *start && window->at(0) < *end)) return;
  warnings.push_back(fault_of(output, "statistics",
                              "the window from " + format_number(window->at(0)) + " s to " +
                                  format_number(window->at(1)) + " s has no step of the run, which goes from " +
                                  format_number(*start) + " s to " + format_number(*end) +
                                  " s; means will be those of the whole run"));
}

std::vector<Fault> implausible_values(const SceneElement& root) {
  std::vector<Fault> warnings;
  for (const auto& element : root.children) {
    if (element.name == "contact") doubt_friction(element, warnings);
    if (element.name == "output") doubt_statistics(root, element, warnings);
  }
  return warnings;
}

}  // namespace nilas::scene
