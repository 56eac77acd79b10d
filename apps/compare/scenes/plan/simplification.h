#pragma once
/// The simplifications of game-engine based simulators that a comparison can turn on, one at a time.
#include <string>
#include <vector>

#include "core/scene/read/read_scene.h"

namespace nilas {

enum class Simplification {
  pyramid,
  equal_friction,
  no_rolling,
  no_gyroscopic,
  split_impulse,
  discrete,
  library_contacts,
  fixed_sweeps,
  prismatic,
  uniform_inertia,
  crushing_limit,
  rigid_floes,
  no_extrusion,
  geometric_splitting,
  straight_cracks,
  uniform_ice
};

/// As tables and pages name it.
const char* name_of(Simplification simplification);
/// What it does, in a sentence without a stop.
const char* meaning_of(Simplification simplification);
/// The order is that of their importance: what the budget cannot pay for goes from the end.
const std::vector<Simplification>& all_simplifications();
/// Why the scene has nothing that it would change; empty where it has.
std::string no_effect(Simplification simplification, const Scene& scene);

/// What takes it out of a scene, and what puts it into one that others are taken out of. Nothing of those that are no
/// more than a law, a solver or a stabilisation (CompareSetting).
Overrides taking_out(Simplification simplification, const Scene& scene);
Overrides putting_in(Simplification simplification, const Scene& scene);

/// A simplification that Nilas makes itself, so that no setting is without it.
struct Inexpressible {
  const char* name;
  const char* reason;
};
const std::vector<Inexpressible>& inexpressible_simplifications();

}  // namespace nilas
