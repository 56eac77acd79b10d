#pragma once
/// The contact points of a substep.
#include <cstdint>
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "contact/step_motion.h"
#include "core/sim/step/substep.h"
#include "core/sim/world/world_state.h"

namespace nilas::sim {

/// Impacts earlier than this become contacts of the substep instead of ending it [share of the step].
constexpr double k_shortest_cut = 1e-3;

struct FoundContacts {
  std::vector<detect::ContactPoint> points;
  /// Keys of contacts that fast bodies meet on their paths. Their gap is the distance that closes until then, not the
  /// present distance.
  std::vector<std::uint64_t> met_on_path;
};

/// The rigid contacts that can close in the substep, found by the scene's mode of detection.
FoundContacts find_contacts(World& world, const Loads& loads, const Substep& substep);
/// Adds, from the last detection, the points of pairs whose contact a module handles.
void add_module_contacts(World& world, const Substep& substep, std::vector<detect::ContactPoint>& points);

/// A contact that two bodies meet at the share `t` of the substep with these velocities. It has the arms that the
/// bodies will have there, and a gap that these velocities close at just that time.
detect::ContactPoint as_gap(const World& world, const detect::ContactPoint& met, double t,
                            const contact::Velocities& velocities, double h);

/// Sorts points in the order of ContactDetector.
void sort_as_detected(std::vector<detect::ContactPoint>& points);

}  // namespace nilas::sim
