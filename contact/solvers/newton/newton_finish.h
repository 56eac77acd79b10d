#pragma once
/// A short damped semismooth Newton that brings impulses near a solution to rounding.
///
/// In units of sqrt(J) (mass_scaled.h, W as stored), per contact with y = r - u:
///   coulomb (Alart-Curnier):  F_N = r_N - clamp(y_N, 0, cap),  F_T = r_T - disc(y_T, mu clamp(y_N, 0, cap))
///   ccp:                      F = r - P_K(y)
/// Steps of Levenberg and Marquardt, (J^T J + a^2) dr = -J^T F with J = F' on the contacts that are not open (an open
/// one has J = 1 and is eliminated), halved until |F| falls. a makes up for the rank that W lacks where contact is
/// redundant: it falls tenfold after a long step and rises tenfold after a short one.
/// Sources: Alart, Curnier 1991; Qi, Sun 1993 (semismooth Newton); Marquardt 1963.
#include "contact/solvers/shared/budget.h"
#include "contact/solvers/shared/mass_scaled.h"

namespace nilas::solvers {

struct FinishOutcome {
  VecX r;              ///< r', the best found
  int iterations = 0;  ///< factorisations
};

/// Steps from r' until the largest map is at most `tolerance` [m/s], |F| stops falling, or the iterations are used up.
FinishOutcome newton_finish(const MassScaled& problem, const VecX& scaled, double tolerance, const Budget& budget);

}  // namespace nilas::solvers
