#pragma once
/// The natural-map residual of one contact for a law, as a velocity: d |r - P(r - u/d)| for the set and the velocity of
/// that law.
#include "contact/problem/local_problem.h"
#include "contact/problem/problem.h"

namespace nilas::contact {

/// The data that a law needs besides impulse and velocity of a contact.
struct ContactScale {
  double mu = 0;
  double force_limit = 0;  ///< [N s]
  double d = 0;  ///< trace(W_cc)/3, or where that is 0, since neither side moves, the compliance of the contact [1/kg]
};
/// `d`: trace(W_cc)/3, which may be 0.
ContactScale contact_scale(const ContactProblem& problem, int c, double d);
ContactScale contact_scale(const LocalProblem& problem, int c);

/// Returns the velocity that the laws use: u + C r, C = diag(normal, tangential, tangential) [m/(s N s)].
inline Vec3 compliant_velocity(double normal, double tangential, const Vec3& r, const Vec3& u) {
  return {u[0] + normal * r[0], u[1] + tangential * r[1], u[2] + tangential * r[2]};
}
/// The same for contact c of a problem.
inline Vec3 compliant_velocity(const ContactCoefficients& contacts, int c, const Vec3& r, const Vec3& u) {
  return compliant_velocity(contacts.compliance[c], contacts.tangential_compliance[c], r, u);
}

/// Returns the natural-map residual as an impulse, r - P(r - u/d) [N s]; zero for a contact that cannot move. Here and
/// below `u` is the compliant velocity.
Vec3 natural_residual(const ContactScale& scale, const Vec3& r, const Vec3& u);
Vec3 law_residual(Law law, int facets, const ContactScale& scale, const Vec3& r, const Vec3& u);

/// Returns d times the length of that residual [m/s]. A contact that cannot move (d = 0) has r_N = force_limit while it
/// closes and 0 otherwise. Any other r_N counts as |u_N|, and so does closing without a limit. An impulse that moves
/// its contact by more than 1e12 m/s counts as d |r|, because u is lost in rounding there.
double natural_map(const ContactScale& scale, const Vec3& r, const Vec3& u);
double ccp_map(const ContactScale& scale, const Vec3& r, const Vec3& u);
double law_map(Law law, int facets, const ContactScale& scale, const Vec3& r, const Vec3& u);

}  // namespace nilas::contact
