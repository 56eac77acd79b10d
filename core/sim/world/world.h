#pragma once
/// Everything that a run moves and the models that move it, built from a scene. Contains only what the scene names.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contact/assemble.h"
#include "contact/law/friction.h"
#include "core/base/channels.h"
#include "core/base/log.h"
#include "core/bodies/bodies.h"
#include "core/bodies/ice_properties.h"
#include "core/bodies/module.h"
#include "core/scene/scene.h"
#include "core/sim/account/step_record.h"
#include "core/sim/world/ice_plan.h"
#include "core/sim/world/vessel_database.h"
#include "core/vessel/mooring/mooring_model.h"
#include "core/vessel/vessel_system.h"
#include "hydro/flow/propeller_jet.h"
#include "hydro/water.h"
#include "hydro/waves/wave_field.h"

namespace nilas::sim {

/// The water that moves with the hull.
struct HullWater {
  std::size_t force = 0;        ///< index in WorldParts::forces of the module that gives it
  Mat6 added_B = Mat6::Zero();  ///< about the centre of mass, body axes
  Vec6 twist = Vec6::Zero();    ///< (v; w) of the hull after the last impulses, in G
  // In the present substep:
  Mat6 added_G = Mat6::Zero();
  contact::ArticulatedBlock block;  ///< the vessel's block, this water included
};

struct WorldParts {
  bodies::Bodies bodies;
  std::optional<hydro::Water> water;
  /// The current as one velocity, for axes of loads and checks: at the surface and the start, or the greatest of its
  /// tables where that is zero [m/s].
  Vec3 current = Vec3::Zero();
  std::shared_ptr<const hydro::WaveField> waves;  ///< of <waves>; also in water->flows where it moves the water
  std::vector<std::shared_ptr<hydro::PropellerJet>> jets;  ///< of <propeller_wash>, in its order; in water->flows too
  std::vector<std::unique_ptr<bodies::Module>> modules;    ///< modules of the scene, in the order of the module list
  std::vector<bodies::Module*> forces;                     ///< the modules that exert loads
  std::optional<vessel::VesselSystem> vessel;
  std::optional<HullWater> hull_water;  ///< only where a module gives the hull an added mass, and the vessel can move
  std::optional<vessel::CarriageModel> carriage;  ///< only for a towed vessel
  std::optional<scene::TankScene> course_within;  ///< tank whose walls end a towed vessel's course
  std::optional<vessel::VesselModel> vessel_model;
  std::optional<vessel::MooringModel> mooring;  ///< of a moored vessel; the module `mooring` has a copy
  int vessel_index = -1;                        ///< index of its hull
  std::string restless;                         ///< name of the part that prevents a towed vessel from starting at rest
  int num_parts = 0;                        ///< number of the vessel's parts, whose bodies follow the hull's in order
  std::vector<std::pair<int, int>> joined;  ///< pairs of bodies a < b that a joint connects, in rising order
  std::vector<PlannedIce> ice;              ///< its floes have the order of their bodies
  std::unique_ptr<bodies::IceProperties>
      ice_properties;  ///< present in a scene with <fracture> and ice; modules refer to it
  contact::FrictionPairs friction;
  std::optional<VesselDatabase> database;  ///< present where the scene names one
  /// What controllers ask of the vessel's actuators. Actuators add their channels when they are built.
  std::shared_ptr<Channels> commands = std::make_shared<Channels>();
  RunInfo info;

  /// Whether the vessel has parts or rods.
  bool is_jointed() const { return vessel_model && vessel_model->is_jointed(); }
  /// Whether a body is the hull or a part.
  bool is_of_vessel(int body) const {
    return vessel_index >= 0 && body >= vessel_index && body <= vessel_index + num_parts;
  }
  /// Whether a joint connects two bodies. Such bodies do not collide.
  bool are_joined(int a, int b) const {
    return std::binary_search(joined.begin(), joined.end(), std::pair(std::min(a, b), std::max(a, b)));
  }
};

/// Adds the vessel to `bodies` and builds its system. Returns the index of its hull.
int build_vessel(const scene::Scene& scene, WorldParts& parts);
/// Plans the floes of all fields and the single floes, and adds their bodies. The result does not depend on `threads`,
/// which share the drawing of properties.
void build_ice(const scene::Scene& scene, int threads, WorldParts& parts, WarningCounts& warnings);
/// Adds tank walls and <body> elements.
void build_structures(const scene::Scene& scene, WorldParts& parts);

/// Throws InputError naming the pair when two bodies, one of them a floe or the vessel, overlap at the start by more
/// than the scene tolerates.
void refuse_overlaps(const scene::Scene& scene, const WorldParts& parts);

}  // namespace nilas::sim
