#pragma once
/// Detection of bodies that move so far in a substep that they could pass through each other.
/// docs/theory/contact-detection.md
#include <optional>
#include <utility>
#include <vector>

#include "contact/detect/detector.h"
#include "contact/step_motion.h"
#include "core/sim/world/world_state.h"

namespace nilas::sim {

/// Threshold of a fast pair: its relative motion as a share of the thinner body's thickness. A slower pair cannot pass
/// the middle of the thinner body.
constexpr double k_fast_share = 0.5;

/// Filter of pairs without rigid contact: a module handles their contact, or a joint connects them. Empty where there
/// are none. Refers to the world.
detect::PairFilter pairs_left_out(const World& world);

/// The places where fast pairs first touch along these velocities over `horizon` [s] or, with `overlap`, first overlap
/// that deep. Free bodies continue the rotation that they will have after `exact` [s].
std::vector<detect::SweptPair> sweep(World& world, const contact::Velocities& velocities, double exact, double horizon,
                                     const detect::SoughtOverlap& overlap = {});

/// Two bodies of which one would enter the other by half the thinner one's thickness within `horizon` [s], so that it
/// could leave on the other side.
std::optional<std::pair<int, int>> passing_bodies(World& world, const contact::Velocities& velocities, double horizon);

/// Throws SimulationError naming the two bodies. `t`: present time [s].
[[noreturn]] void refuse_passing(const World& world, const std::pair<int, int>& pair, double t);

}  // namespace nilas::sim
