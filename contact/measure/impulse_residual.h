#pragma once
/// How far one contact's impulse is from what the law makes of its velocity, as a vector: e = r - P_K(r - u/d).
/// A length d |e| is what `measure` reports; summed over the contacts of a body, e is what the body's load is off.
#include "contact/problem/problem.h"

namespace nilas {

/// In (N, T1, T2) of the contact, on body B [N s].
struct ImpulseResidual {
  Vec3 law = Vec3::Zero();      ///< from the law that was asked
  Vec3 coulomb = Vec3::Zero();  ///< from exact Coulomb; the same for coulomb
};

/// Of contact c, not a moment. `d`: as from `measure`. `gap_speed`: what an open gap adds to u_N, gap/h [m/s]. A
/// convexified law lets what slides hover at h mu |u_T|, which the next step's gap_speed gives back: such a gap counts
/// as closed for `coulomb`. Of a contact with a moment the force alone.
ImpulseResidual impulse_residual(const ContactProblem& problem, int c, double d, const VecX& r, const VecX& v,
                                 double gap_speed);

}  // namespace nilas
