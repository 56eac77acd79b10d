#include "core/scene/check/implausible_values.h"

#include <cmath>

#include "core/choices/wave_choices.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/spec/values.h"

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

/// Waves steeper than 0.142 in deep water break (Michell 1893); a sea whose significant height is above 1/15 of the
/// length of its peak is not found (DNV-RP-C205, 3.5.5). In water of finite depth waves are shorter still.
static void doubt_waves(const SceneElement& root, const SceneElement& water, std::vector<Fault>& warnings) {
  constexpr double k_steepest_wave = 0.142, k_steepest_sea = 1.0 / 15;
  const SceneElement* gravity = child_of(root, "gravity");
  const auto g = gravity ? numbers_of(*gravity, "value") : std::nullopt;
  if (!g) return;
  for (const auto& waves : water.children) {
    const auto height = number_of(waves, "height"), period = number_of(waves, "period");
    if (waves.name != "waves" || !height || !period) continue;
    const double length = std::abs(g->back()) * *period * *period / (2 * k_pi);
    const double allowed =
        length * (choice_of<WaveKind>(waves, "kind") == WaveKind::regular ? k_steepest_wave : k_steepest_sea);
    if (*height > allowed)
      warnings.push_back(fault_of(waves, "height",
                                  "found " + format_number(*height) + "; waves of this period break above " +
                                      format_number(allowed) + " m, and linear theory does not hold"));
  }
}

std::vector<Fault> implausible_values(const SceneElement& root) {
  std::vector<Fault> warnings;
  for (const auto& element : root.children) {
    if (element.name == "water") doubt_waves(root, element, warnings);
    if (element.name == "contact") doubt_friction(element, warnings);
    if (element.name == "output") doubt_statistics(root, element, warnings);
  }
  return warnings;
}

}  // namespace nilas::scene
