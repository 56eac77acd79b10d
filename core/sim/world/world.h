#pragma once
/// Everything a run moves and the models that move it, as built from a scene. Only what the scene names is here.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contact/law/friction.h"
#include "core/base/log.h"
#include "core/bodies/bodies.h"
#include "core/bodies/ice_properties.h"
#include "core/bodies/module.h"
#include "core/scene/scene.h"
#include "core/sim/account/step_record.h"
#include "core/sim/world/ice_plan.h"
#include "core/vessel/vessel_system.h"
#include "hydro/water.h"

namespace nilas {

struct WorldParts {
  Bodies bodies;
  std::optional<Water> water;
  std::vector<std::unique_ptr<Module>> modules;  ///< what the scene asks for, in the order of the module list
  std::vector<Module*> forces;                   ///< of them those that exert loads
  std::optional<VesselSystem> vessel;
  std::optional<CarriageModel> carriage;   ///< of a vessel that is towed
  std::optional<TankScene> course_within;  ///< whose walls end the course of a towed vessel
  std::optional<VesselModel> vessel_model;
  int vessel_index = -1;                          ///< of its hull
  std::string restless;                           ///< the part that keeps a towed vessel from starting at rest
  int num_parts = 0;                              ///< of the vessel, whose bodies follow the hull's in their order
  std::vector<std::pair<int, int>> joined;        ///< bodies a < b that a joint holds together, in rising order
  std::vector<PlannedIce> ice;                    ///< its floes in the order of their bodies
  std::unique_ptr<IceProperties> ice_properties;  ///< of a scene with <fracture> and ice; modules refer to it
  FrictionPairs friction;
  RunInfo info;

  /// Whether the vessel has parts or rods.
  bool is_jointed() const { return vessel_model && vessel_model->is_jointed(); }
  /// Whether a body is the hull or a part.
  bool is_of_vessel(int body) const {
    return vessel_index >= 0 && body >= vessel_index && body <= vessel_index + num_parts;
  }
  /// Whether a joint holds two bodies together: these do not collide.
  bool are_joined(int a, int b) const {
    return std::binary_search(joined.begin(), joined.end(), std::pair(std::min(a, b), std::max(a, b)));
  }
};

/// The vessel entry of `bodies` and its system. Returns its index.
int build_vessel(const Scene& scene, WorldParts& parts);
/// Floes of all fields and single floes: the plan, and the bodies. `threads` draw properties; the result does not
/// depend on their number.
void build_ice(const Scene& scene, int threads, WorldParts& parts, WarningCounts& warnings);
/// Tank walls and <body> elements.
void build_structures(const Scene& scene, WorldParts& parts);

/// Throws InputError naming the pair when two bodies, one of them a floe, overlap at the start by more than the scene
/// tolerates.
void refuse_overlaps(const Scene& scene, const WorldParts& parts);

}  // namespace nilas
