#pragma once
/// H, H^T and the diagonal of H^T M^-1 H, one contact at a time.
#include "contact/problem/mass_inverse.h"
#include "contact/problem/problem.h"

namespace nilas::contact {

/// u_c = J_A v_A + J_B v_B + w_c. `v`: nv velocities.
Vec3 contact_velocity(const ContactProblem& problem, int c, const double* v);

/// momentum += J_c^T r for the blocks of contact c. `momentum`: nv numbers.
void add_impulse(const ContactProblem& problem, int c, const Vec3& r, double* momentum);

/// W_cc (3 x 3). `response` receives M_A^-1 J_A^T (n_a x 3) then M_B^-1 J_B^T (n_b x 3), each column contiguous.
Mat3 delassus_block(const ContactProblem& problem, const MassInverse& masses, int c, double* response);

/// d_c = trace(W_cc)/3, the scale between impulse and velocity [1/kg].
double inverse_mass_scale(const ContactProblem& problem, const MassInverse& masses, int c, double* response);

/// Most numbers that the two above write for any contact.
std::size_t largest_response(const ContactProblem& problem);

/// v = M^-1 (f + H r) with the inverse at hand.
VecX velocities(const ContactProblem& problem, const MassInverse& masses, const VecX& r);

/// d_c = trace(W_cc)/3 from the block W_cc [1/kg].
inline double inverse_mass_scale(const Mat3& w) { return w.trace() / 3; }

}  // namespace nilas::contact
