#pragma once
/// Bodies that move so far against each other in a substep that they could pass through each other.
/// docs/theory/contact-detection.md
#include <optional>
#include <utility>
#include <vector>

#include "contact/detect/detector.h"
#include "contact/step_motion.h"
#include "core/sim/world/world_state.h"

namespace nilas {

/// Pairs that move less than this share of the thinner body's thickness against each other cannot get past its middle.
constexpr double k_fast_share = 0.5;

/// Pairs whose contact is not a rigid one: a module's, or bodies that a joint holds together. Empty where there are
/// none. Refers to the world.
PairFilter pairs_left_out(const World& world);

/// Where fast pairs first touch along these velocities over `horizon` [s] or, with `overlap`, first overlap that deep.
/// Free bodies turn on as they will have turned after `exact` [s].
std::vector<SweptPair> sweep(World& world, const Velocities& velocities, double exact, double horizon,
                             const SoughtOverlap& overlap = {});

/// Two bodies of which one would go deeper into the other by half the thinner one's thickness within `horizon` [s]: it
/// could leave on the other side.
std::optional<std::pair<int, int>> passing_bodies(World& world, const Velocities& velocities, double horizon);

/// Throws SimulationError naming the two bodies; `t`: now [s].
[[noreturn]] void refuse_passing(const World& world, const std::pair<int, int>& pair, double t);

}  // namespace nilas
