#pragma once
/// The motion of a hull and its parts between impulses: nothing acts but joints and rods, and the carriage goes on as
/// it does.
#include <functional>

#include "core/vessel/tree/jointed_tree.h"

namespace nilas {

/// Called at the stages of the scheme for the tree's state there: `carriage`, the time that it stands for [s], the
/// accelerations of the n speeds and the tensions of the rods. Sums over these times are integrals of the scheme's own
/// order.
using DriftSample = std::function<void(const CarriageMotion::State& carriage, double time, const VecX& accelerations,
                                       const VecX& tensions)>;

/// Moves the tree over `time` [s] by the classical Runge-Kutta scheme, and the carriage, `carriage` being where it is,
/// with its present speeds. What the scheme lacks in the momenta of a free hull with its parts is given back to all of
/// them as one rigid body, so that linear and angular momentum are kept to rounding. At the end the lengths of rods and
/// their rates are put right to rounding; returns the impulses of tension that did it [N s], beyond the sampled ones.
VecX drift(JointedTree& tree, CarriageMotion::State& carriage, double time, const DriftSample& sample);

/// Of the n speeds where nothing but the loads acts, springs and dampers left out. The carriage does not accelerate.
VecX accelerations_under(const JointedTree& tree, const std::vector<Wrench>& loads);

}  // namespace nilas
