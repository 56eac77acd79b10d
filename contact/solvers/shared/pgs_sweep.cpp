#include "contact/solvers/shared/pgs_sweep.h"

#include <algorithm>
#include <cmath>

#include "contact/solvers/shared/contact_sides.h"

namespace nilas::solvers {

namespace {

struct TangentStep {
  double d1, d2;
};

/// Row by row, T2 seeing T1's change.
TangentStep step_box(PgsContact& c, double u1, double u2) {
  const double bound = c.mu * c.r[0];
  const double r1 = std::clamp(c.r[1] - u1 * c.weight[1], -bound, bound);
  const double d1 = r1 - c.r[1];
  const double r2 = std::clamp(c.r[2] - (u2 + c.coupling[2] * d1) * c.weight[2], -bound, bound);
  const double d2 = r2 - c.r[2];
  c.r[1] = r1;
  c.r[2] = r2;
  return {d1, d2};
}

/// Both rows with one weight, then back onto the disc.
TangentStep step_disc(PgsContact& c, double u1, double u2) {
  const double bound = c.mu * c.r[0];
  double r1 = c.r[1] - u1 * c.weight[1];
  double r2 = c.r[2] - u2 * c.weight[2];
  const double square = r1 * r1 + r2 * r2;
  if (square > bound * bound) {
    const double share = bound / std::sqrt(square);
    r1 *= share;
    r2 *= share;
  }
  const TangentStep step{r1 - c.r[1], r2 - c.r[2]};
  c.r[1] = r1;
  c.r[2] = r2;
  return step;
}

template <Law law, bool track, int NA, int NB>
double visit(PgsContact& c, const double* coefficients, double* velocities) {
  const Sides<NA, NB> sides(c, coefficients, velocities);
  const double u_n = sides.velocity(0) + c.w[0] + c.compliance * c.r[0];
  const double r_n = std::min(std::max(c.r[0] - u_n * c.weight[0], 0.0), c.force_limit);
  const double dn = r_n - c.r[0];
  c.r[0] = r_n;
  double change = track ? std::abs(dn) * c.diagonal[0] : 0;
  const bool open = r_n == 0 && c.r[1] == 0 && c.r[2] == 0;
  if (law == Law::frictionless || open) {
    if (dn != 0) sides.apply_normal(dn);
    return change;
  }
  const double u1 = sides.velocity(1) + c.w[1] + c.coupling[0] * dn + c.tangential_compliance * c.r[1];
  const double u2 = sides.velocity(2) + c.w[2] + c.coupling[1] * dn + c.tangential_compliance * c.r[2];
  const TangentStep step = law == Law::pyramid ? step_box(c, u1, u2) : step_disc(c, u1, u2);
  sides.apply(dn, step.d1, step.d2);
  if (track) change = std::max({change, std::abs(step.d1) * c.diagonal[1], std::abs(step.d2) * c.diagonal[2]});
  return change;
}

template <Law law, bool track>
double visit_any(PgsContact& c, const double* coefficients, double* velocities) {
  switch (c.shape) {
    case PgsShape::six_six:
      return visit<law, track, 6, 6>(c, coefficients, velocities);
    case PgsShape::six_none:
      return visit<law, track, 6, 0>(c, coefficients, velocities);
    case PgsShape::none_six:
      return visit<law, track, 0, 6>(c, coefficients, velocities);
    case PgsShape::general:
      return visit<law, track, k_any, k_any>(c, coefficients, velocities);
  }
  return 0;
}

template <Law law, bool track>
double sweep(PgsRows& rows, const PgsIsland& island, bool backward) {
  PgsContact* const contacts = rows.contacts.data();
  const double* const coefficients = rows.coefficients.data();
  double* const velocities = rows.velocities.data();
  double largest = 0;
  for (int k = island.first; k < island.last; ++k) {
    PgsContact& contact = contacts[backward ? island.first + island.last - 1 - k : k];
    const double change = visit_any<law, track>(contact, coefficients, velocities);
    if (track) largest = std::max(largest, change);
  }
  return largest;
}

}  // namespace

PgsSweep pgs_sweep(Law law, bool track) {
  if (law == Law::coulomb) return track ? sweep<Law::coulomb, true> : sweep<Law::coulomb, false>;
  if (law == Law::frictionless) return track ? sweep<Law::frictionless, true> : sweep<Law::frictionless, false>;
  return track ? sweep<Law::pyramid, true> : sweep<Law::pyramid, false>;
}

PgsVisit pgs_visit(Law law, bool track) {
  if (law == Law::coulomb) return track ? visit_any<Law::coulomb, true> : visit_any<Law::coulomb, false>;
  if (law == Law::frictionless) return track ? visit_any<Law::frictionless, true> : visit_any<Law::frictionless, false>;
  return track ? visit_any<Law::pyramid, true> : visit_any<Law::pyramid, false>;
}

template <int NA, int NB>
static void apply_impulse_of(const PgsContact& contact, PgsRows& rows) {
  const Sides<NA, NB> sides(contact, rows.coefficients.data(), rows.velocities.data());
  if (rows.law == Law::frictionless)
    sides.apply_normal(contact.r[0]);
  else
    sides.apply(contact.r[0], contact.r[1], contact.r[2]);
}

void apply_impulse(const PgsContact& contact, PgsRows& rows) {
  // a moment that rolls without spinning has no first coordinate
  if (contact.r[0] == 0 && contact.r[1] == 0 && contact.r[2] == 0) return;
  if (contact.shape == PgsShape::six_six)
    apply_impulse_of<6, 6>(contact, rows);
  else
    apply_impulse_of<k_any, k_any>(contact, rows);
}

}  // namespace nilas::solvers
