#pragma once
/// Which contact points can matter in this step: how far each body can get, and so which gaps can close.
#include <vector>

#include "contact/detect/broad/broad_phase.h"
#include "contact/detect/broad/contact_point.h"
#include "core/bodies/bodies.h"
#include "core/bodies/module.h"

namespace nilas {

/// How far any point of each body may move relative to the mean motion of the free bodies within the step, by its own
/// speed and by the loads on it [m]: share * h * (|v + h F/m - v_mean| + |w + h I^-1 T| radius). A body that floats at
/// rest reaches nothing, one about to fall reaches its fall.
std::vector<double> own_reach(const Bodies& bodies, const Wrenches& loads, double h, double share);

/// Per candidate pair the gap beyond which no point between its bodies can stay in `drop_out_of_reach` [m]: the same
/// rule with reach handed on along all candidates as if their gaps were closed; between `least` and `most` [m].
std::vector<double> pair_margins(const Bodies& bodies, const std::vector<double>& own,
                                 const std::vector<PartPair>& pairs, double least, double most, int threads);

/// Drops the points whose gap will not close in this step: a gap stays when it is smaller than what one body can reach,
/// by its own motion or pushed, together with the other's own reach. A body that is hit takes over m/(m + m') of the
/// reach of the body that hits it less the gap between them (the common speed after an inelastic impact), along any
/// chain. What a chain pushes farther than that closes its gap a step later. Points with
/// gap < margin [m] stay in any case. The order of the points is kept.
void drop_out_of_reach(const Bodies& bodies, const std::vector<double>& own, std::vector<ContactPoint>& points,
                       double margin = 0);

}  // namespace nilas
