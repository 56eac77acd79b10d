#pragma once
/// A world in motion: the contents built from the scene, and the state that steps carry forward.
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "contact/detect/detector.h"
#include "contact/elastic_contacts.h"
#include "contact/static_friction.h"
#include "contact/warm_start.h"
#include "core/sim/account/ledger.h"
#include "core/sim/world/contact_model.h"
#include "core/sim/world/load_checks.h"
#include "core/sim/world/world.h"

namespace nilas::sim {

struct World {
  /// Starts from `built`. `warnings` must outlive this object.
  World(const scene::Scene& scene, int threads, WarningCounts& warnings, WorldParts built);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  std::size_t size() const { return static_cast<std::size_t>(parts.bodies.size()); }
  /// Time at the end of the last step [s].
  double time() const { return time_after(steps); }
  double time_after(long count) const { return start + static_cast<double>(count) * step; }
  double potential();
  /// The springs of contact points, as left by the last step; empty where no contact is elastic.
  std::vector<contact::Spring> springs(const std::vector<detect::ContactPoint>& points) const;
  /// Updates all per-body data after bodies changed. `pieces`: new bodies that replace a floe.
  void follow_bodies(const std::vector<fracture::NewPiece>& pieces);
  /// Throws SimulationError naming a body whose state is not finite or exceeds all bounds. `t`: present time [s].
  void demand_finite(double t) const;

  void save(StateWriter out) const;
  /// Throws InputError when the state belongs to another scene.
  void restore(const StateReader& in);

  // Constant during a run.
  WorldParts parts;  ///< constant except for bodies, vessel and modules
  WarningCounts& warnings;
  int threads;
  double step, start;  ///< length of a step, time of the first [s]
  Vec3 gravity;
  bool gyroscopic;
  double ice_modulus;  ///< Young's modulus [Pa]
  ContactModel model;
  LoadChecks load_checks;

  // State.
  long steps = 0;
  detect::ContactDetector detector;
  contact::WarmStart warm;
  std::optional<contact::ElasticContacts> elastic;  ///< present where some pair of materials is elastic
  contact::SlippingContacts slipping;
  EnergyAccount energy;
  std::set<std::pair<int, int>> unnamed_pairs;  ///< pairs of materials in contact that no <friction> names
  std::vector<contact::SolvedProblem> solved;   ///< problems of the last step, one per substep

  // Derived from the bodies.
  int floes = 0;
  bodies::Wrenches weight;
  std::vector<double> width;  ///< smallest width of each body [m]
  std::vector<double> edge;   ///< Young's modulus times thickness of floes, 0 for others; empty without `elastic` [N/m]
};

}  // namespace nilas::sim
