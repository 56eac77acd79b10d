#pragma once
/// A world in motion: what was built from the scene, and the state that a step takes from one instant to the next.
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "contact/detect/detector.h"
#include "contact/static_friction.h"
#include "contact/warm_start.h"
#include "core/sim/account/ledger.h"
#include "core/sim/world/contact_model.h"
#include "core/sim/world/world.h"

namespace nilas {

struct World {
  /// Starts from these parts, which stay where they are. `warnings` must outlive this.
  World(const Scene& scene, int threads, WarningCounts& warnings, WorldParts built);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  std::size_t size() const { return static_cast<std::size_t>(parts.bodies.size()); }
  /// At the end of the last step [s].
  double time() const { return start + static_cast<double>(steps) * step; }
  double potential();
  /// Brings all that is kept per body up to date; `pieces`: bodies that came in the place of a floe.
  void follow_bodies(const std::vector<NewPiece>& pieces);
  /// Throws SimulationError naming the body that left finite numbers or went beyond all bounds; `t` [s].
  void demand_finite(double t) const;

  void save(StateWriter out) const;
  /// Throws InputError when the state is one of another scene.
  void restore(const StateReader& in);

  // What never changes.
  WorldParts parts;  ///< but its bodies, vessel and modules, which move
  WarningCounts& warnings;
  int threads;
  double step, start;  ///< length of a step, time of the first [s]
  Vec3 gravity;
  bool gyroscopic;
  ContactModel model;

  // State.
  long steps = 0;
  ContactDetector detector;
  WarmStart warm;
  SlippingContacts slipping;
  EnergyAccount energy;
  std::set<std::pair<int, int>> unnamed_pairs;  ///< materials that touched although no <friction> names them
  std::vector<SolvedProblem> solved;            ///< of the last step, one for each substep

  // Follows from the bodies.
  int floes = 0;
  Wrenches weight;
  std::vector<double> width;  ///< smallest of each body [m]
};

}  // namespace nilas
