#pragma once
/// The best axis of two cylinders, where their rims make it.
#include "contact/detect/surface/round_axes.h"

namespace nilas {

/// The direction of all that separates b most from a, to `tolerance` [m]; `start` where none separates by more than it
/// does.
RoundAxis best_of_all_directions(const RoundBody& a, const RoundBody& b, const RoundAxis& start, double tolerance);

/// From n uphill to a top of what separates b from a, by Newton's method on the sphere; their rims make it where it is
/// smooth.
RoundAxis climb_between_rims(const RoundBody& a, const RoundBody& b, const Vec3& n);

}  // namespace nilas
