#pragma once
/// Finds the best axis of two cylinders where their rims make it.
#include "contact/detect/surface/round_axes.h"

namespace nilas::detect {

/// Returns the direction that separates b most from a, to `tolerance` [m]. Returns `start` where none separates by more
/// than `start` does.
RoundAxis best_of_all_directions(const RoundBody& a, const RoundBody& b, const RoundAxis& start, double tolerance);

/// Climbs from n to a maximum of the separation of b from a, by Newton's method on the sphere. The separation is smooth
/// where the rims make it.
RoundAxis climb_between_rims(const RoundBody& a, const RoundBody& b, const Vec3& n);

}  // namespace nilas::detect
