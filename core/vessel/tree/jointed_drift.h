#pragma once
/// The motion of a hull and its parts between impulses: only joints and rods act, and the carriage keeps its speeds.
#include <functional>

#include "core/vessel/tree/jointed_tree.h"

namespace nilas::vessel {

/// Function that is called at the stages of the scheme, with the tree in the stage's state. Arguments: the carriage,
/// the time that the stage represents [s], the accelerations of the n speeds and the tensions of the rods. Sums
/// weighted with these times are integrals of the scheme's own order.
using DriftSample = std::function<void(const CarriageMotion::State& carriage, double time, const VecX& accelerations,
                                       const VecX& tensions)>;

/// Moves the tree over `time` [s] by the classical Runge-Kutta scheme. The carriage moves from `carriage` with its
/// present speeds. The scheme's error in the momenta of a free hull with parts is corrected by a rigid motion of all
/// bodies, so that linear and angular momentum are kept to rounding. At the end, lengths of rods and their rates are
/// corrected to rounding. Returns the impulses of tension for this correction [N s], which the samples do not contain.
VecX drift(JointedTree& tree, CarriageMotion::State& carriage, double time, const DriftSample& sample);

/// Accelerations of the n speeds under the loads alone, without springs and dampers. The carriage does not accelerate.
VecX accelerations_under(const JointedTree& tree, const std::vector<Wrench>& loads);

}  // namespace nilas::vessel
