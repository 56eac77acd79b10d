#pragma once
/// What the residuals of a step's contacts amount to, as loads on the vessel. Theory: docs/theory/load-error.md.
#include "contact/measure/impulse_residual.h"
#include "contact/step_motion.h"
#include "core/sim/account/step_record.h"

namespace nilas {

/// Impulses on the vessel in G, torques about its centre of mass where the contacts were found [N s, N m s].
struct LoadResidual {
  /// Of the law that was asked: sum of the absolute values, component by component, over the vessel's contacts. Where
  /// the solver ended above its tolerance, also over all other contacts of bodies that are in touch with the vessel,
  /// directly or through others: each may reach the vessel whole, along any axis.
  Wrench solver;
  Wrench law;  ///< of exact Coulomb less those of the law that was asked: signed sum; 0 for coulomb
};

/// `C`: as in AssembledContacts. `vessel`: the hull; the parts that follow it count with it.
LoadResidual load_residual(const SolvedProblem& solved, const std::vector<Mat3>& C, const StepMotion& motion,
                           int vessel, int num_parts = 0);

}  // namespace nilas
