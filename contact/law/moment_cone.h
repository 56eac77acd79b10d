#pragma once
/// Rolling and spinning friction: the cone of a contact's force and moment.
///
/// The moment rows (S, R1, R2) are divided by their lengths, spinning delta_s and rolling delta_r, so all six rows are
/// in N s and m/s: impulse m / delta, velocity delta w. A length of zero leaves a row of zeros.
///   K = {|r_T| <= mu r_N, |r_S| <= r_N, |r_R| <= r_N, r_N <= cap}
///   u_hat = u + (mu |u_T| + |u_S| + |u_R|) n
/// with K* containing u_hat, perpendicular to r in K: Coulomb in all three, each opposing its own motion.
/// Source: FCLIB's rolling form (Acary, Bourrier 2021), which has no spinning row.
#include "contact/law/law_map.h"

namespace nilas::contact {

/// One contact's impulses or velocities: (N, T1, T2) and (S, R1, R2).
struct ForceAndMoment {
  Vec3 force = Vec3::Zero();
  Vec3 moment = Vec3::Zero();
};

/// Nearest point of K.
ForceAndMoment project_moment_cone(const ForceAndMoment& x, double mu, double cap);

/// The force of law_map.h's residual vectors for a contact with moments, as below [N s].
Vec3 natural_residual(const ContactScale& scale, const ForceAndMoment& r, const ForceAndMoment& u);
Vec3 law_residual(Law law, const ContactScale& scale, const ForceAndMoment& r, const ForceAndMoment& u);

/// The residuals of law_map.h for a contact with moments; `u` compliant, `scale` of its force rows. Laws: coulomb, and
/// pyramid with each of T1, T2, S, R1, R2 clamped on its own.
double natural_map(const ContactScale& scale, const ForceAndMoment& r, const ForceAndMoment& u);
double ccp_map(const ContactScale& scale, const ForceAndMoment& r, const ForceAndMoment& u);
double law_map(Law law, const ContactScale& scale, const ForceAndMoment& r, const ForceAndMoment& u);

}  // namespace nilas::contact
