#pragma once
/// The residuals of a step's contacts as loads on the vessel. Theory: docs/theory/load-error.md.
#include "contact/measure/impulse_residual.h"
#include "contact/step_motion.h"
#include "core/sim/account/step_record.h"

namespace nilas::sim {

/// Impulses on the vessel [N s, N m s], frame G. Torques are about its centre of mass where the contacts were found.
struct LoadResidual {
  /// Residual of the chosen contact law: the sum of absolute values, component by component, over the vessel's
  /// contacts. Where the solver ended above its tolerance, the sum includes all other contacts of bodies that touch the
  /// vessel directly or through others. Each of those may reach the vessel in full, along any axis.
  Wrench solver;
  Wrench law;  ///< residual of exact Coulomb minus that of the chosen law, signed sum; 0 for law "coulomb"
};

/// `C`: as in AssembledContacts. `vessel`: index of the hull; the `num_parts` bodies that follow it belong to the
/// vessel. The result has the same bits for any `threads`.
LoadResidual load_residual(const contact::SolvedProblem& solved, const std::vector<Mat3>& C,
                           const contact::StepMotion& motion, int vessel, int num_parts = 0, int threads = 1);

}  // namespace nilas::sim
