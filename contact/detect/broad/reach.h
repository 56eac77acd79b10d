#pragma once
/// Finds which contact points can matter in this step: how far each body can move, and so which gaps can close.
#include <vector>

#include "contact/detect/broad/broad_phase.h"
#include "contact/detect/broad/contact_point.h"
#include "core/bodies/bodies.h"
#include "core/bodies/module.h"

namespace nilas::detect {

/// Returns how far any point of each body may move within the step by its own speed and loads, relative to the mean
/// motion of the free bodies [m]: share * h * (|v + h F/m - v_mean| + |w + h I^-1 T| radius). The reach of a body that
/// floats at rest is 0, that of a body about to fall is its fall.
std::vector<double> own_reach(const bodies::Bodies& bodies, const bodies::Wrenches& loads, double h, double share);

/// Returns, per candidate pair, the gap beyond which `drop_out_of_reach` keeps no point between its bodies [m]. The
/// rule is the same, with reach handed on along all candidates as if their gaps were closed. The result lies between
/// `least` and `most` [m].
std::vector<double> pair_margins(const bodies::Bodies& bodies, const std::vector<double>& own,
                                 const std::vector<PartPair>& pairs, double least, double most, int threads);

/// Drops the points whose gap will not close in this step. A gap stays when it is smaller than the reach of one body,
/// by its own motion or pushed, plus the other's own reach. A body that is hit takes over m/(m + m') of the hitting
/// body's reach less the gap between them. This is the common speed after an inelastic impact, along any chain. What a
/// chain pushes farther than that closes its gap a step later. Points with gap < margin [m] stay in any case. The order
/// of the points is kept.
void drop_out_of_reach(const bodies::Bodies& bodies, const std::vector<double>& own, std::vector<ContactPoint>& points,
                       double margin = 0);

}  // namespace nilas::detect
