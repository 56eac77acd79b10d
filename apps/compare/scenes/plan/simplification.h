#pragma once
/// The simplifications of game-engine based simulators that a comparison can turn on, one at a time.
#include <string>
#include <vector>

#include "core/scene/read/read_scene.h"

namespace nilas::compare {

enum class Simplification {
  pyramid,
  equal_friction,
  no_rolling,
  rigid_contacts,
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

/// The name in tables and pages.
const char* name_of(Simplification simplification);
/// A sentence without a full stop about what it does.
const char* meaning_of(Simplification simplification);
/// All simplifications in the order of their importance. A short budget leaves out those at the end.
const std::vector<Simplification>& all_simplifications();
/// Why a simplification has nothing to change in a scene; empty if it has.
std::string no_effect(Simplification simplification, const scene::Scene& scene);

/// The overrides that take a simplification out of a scene, and those that put it into a scene from which all are taken
/// out. They are empty for simplifications that are a law, a solver or a stabilisation of a CompareSetting.
scene::Overrides taking_out(Simplification simplification, const scene::Scene& scene);
scene::Overrides putting_in(Simplification simplification, const scene::Scene& scene);

/// A simplification that Nilas makes itself, so that every setting has it.
struct Inexpressible {
  const char* name;
  const char* reason;
};
const std::vector<Inexpressible>& inexpressible_simplifications();

}  // namespace nilas::compare
