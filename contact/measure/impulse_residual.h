#pragma once
/// The natural-map residual of one contact's impulse, as a vector: e = r - P_K(r - u/d). A length d |e| is what
/// `measure` reports. Summed over the contacts of a body, e is the error of the body's load.
#include "contact/problem/problem.h"

namespace nilas::contact {

/// The residual on body B in the frame (N, T1, T2) of the contact [N s].
struct ImpulseResidual {
  Vec3 law = Vec3::Zero();      ///< residual of the law that was asked for
  Vec3 coulomb = Vec3::Zero();  ///< residual of exact Coulomb friction; equal to `law` for the law coulomb
};

/// Returns the residual of contact c, which is no moment; for a contact with a moment, that of the force alone. `d`: as
/// from `measure`. `gap_speed`: what an open gap adds to u_N, gap/h [m/s]. With a convexified law a sliding body hovers
/// at h mu |u_T|, which the next step's gap_speed gives back. Such a gap counts as closed for `coulomb`.
ImpulseResidual impulse_residual(const ContactProblem& problem, int c, double d, const VecX& r, const VecX& v,
                                 double gap_speed);

}  // namespace nilas::contact
