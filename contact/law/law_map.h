#pragma once
/// Distance of one contact from a law, as a velocity: d |r - P(r - u/d)| for the set and the velocity of that law.
#include "contact/problem/local_problem.h"
#include "contact/problem/problem.h"

namespace nilas {

/// What a law needs to know of a contact beside its impulse and velocity.
struct ContactScale {
  double mu = 0;
  double force_limit = 0;  ///< [N s]
  double d = 0;            ///< trace(W_cc)/3 [1/kg]
};
/// `d`: trace(W_cc)/3.
ContactScale contact_scale(const ContactProblem& problem, int c, double d);
ContactScale contact_scale(const LocalProblem& problem, int c);

/// The velocity that laws speak of: u with c r_N added to its normal part.
inline Vec3 compliant_velocity(double compliance, const Vec3& r, const Vec3& u) {
  return {u[0] + compliance * r[0], u[1], u[2]};
}

/// `u` below is the compliant velocity. An impulse that is off, r - P(r - u/d), as a vector [N s]; zero for a contact
/// that cannot move.
Vec3 natural_residual(const ContactScale& scale, const Vec3& r, const Vec3& u);
Vec3 law_residual(Law law, int facets, const ContactScale& scale, const Vec3& r, const Vec3& u);

/// d times the length of it, in m/s. A contact that cannot move (d = 0) has r_N = force_limit
/// while it closes and 0 otherwise; being elsewhere counts as |u_N|, and so does closing without a limit. An impulse
/// that moves its contact by more than 1e12 m/s, beside which u is lost in rounding, counts as d |r|.
double natural_map(const ContactScale& scale, const Vec3& r, const Vec3& u);
double ccp_map(const ContactScale& scale, const Vec3& r, const Vec3& u);
double law_map(Law law, int facets, const ContactScale& scale, const Vec3& r, const Vec3& u);

}  // namespace nilas
