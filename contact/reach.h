#pragma once
/// Which contact points can matter in this step: how far each body can get, and so which gaps can close.
#include <vector>

#include "contact/detect/contact_point.h"
#include "core/bodies/bodies.h"

namespace nilas {

/// How far any point of each body may move relative to the mean motion of the free bodies within the step by its own
/// speed [m]: share * h * (|v - v_mean| + |w| radius + h g).
std::vector<double> own_reach(const Bodies& bodies, double h, double share, double gravity);

/// Drops the points whose gap cannot close: a gap stays when it is smaller than the sum of what both bodies can reach,
/// where a body that can be hit inherits the reach of the body that hits it less the gap between them, along any chain.
/// The order of the points is kept.
void drop_out_of_reach(std::vector<ContactPoint>& points, std::vector<double> reach);

}  // namespace nilas
