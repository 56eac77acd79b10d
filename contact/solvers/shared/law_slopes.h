#pragma once
/// A map of one contact that vanishes where its law holds, with a generalised derivative: what Newton's method needs.
///
///   coulomb       Alart-Curnier: r_N - clamp(r_N - u_N, 0, cap),  r_T - nearest point to r_T - u_T in the disc
///                 of radius mu clamp(r_N - u_N, 0, cap)
///   ccp           r - P(r - u) for the cone cut at cap
///   pyramid-k     r - P(r - u_hat), u_hat = u + mu max_k(-e_k . u_T) n, for the k-sided pyramid cut at cap
///   pyramid       the normal row of coulomb,  r_i - clamp(r_i - u_i, +-mu r_N), i = 1, 2
///   frictionless  the normal row of coulomb,  r_T
///
/// r and u in units where a contact's inverse mass is about 1, so that they may be subtracted. Every map is piecewise
/// smooth. Sources: Alart & Curnier 1991; Acary, Bremond, Huber 2018.
#include "contact/problem/problem.h"

namespace nilas::solvers {

struct LawSlopes {
  Vec3 value = Vec3::Zero();
  Mat3 by_velocity = Mat3::Zero();  ///< d value / d u
  Mat3 by_impulse = Mat3::Zero();   ///< d value / d r
  bool open = false;                ///< value = r whatever u is, nearby
};

/// `cap`: largest r_N, may be infinite. `facets`: of pyramid-k.
LawSlopes law_slopes(Law law, int facets, double mu, double cap, const Vec3& r, const Vec3& u);

}  // namespace nilas::solvers
