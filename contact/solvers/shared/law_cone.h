#pragma once
/// The set of admissible impulses of a law and the normal velocity that the law adds: what makes contact a variational
/// inequality,  r in K,  (u + shift(u) n) . (r' - r) >= 0 for all r' in K. These laws are k_convex_laws.
#include "contact/law/cone.h"
#include "contact/law/law_map.h"

namespace nilas::solvers {

/// Nearest point of K. The box pyramid is no such inequality (its sides depend on r_N): not for that law.
inline Vec3 project_law(Law law, int facets, const contact::ContactScale& scale, const Vec3& x) {
  if (law == Law::frictionless) return {std::min(std::max(x[0], 0.0), scale.force_limit), 0, 0};
  if (law == Law::pyramid_k) return contact::project_pyramid(x, scale.mu, facets, scale.force_limit);
  return contact::project_cone(x, scale.mu, scale.force_limit);
}

/// mu |u_T| for Coulomb, its polygon's like for pyramid-k, 0 for convex laws.
inline double law_shift(Law law, int facets, const contact::ContactScale& scale, const Vec3& u) {
  if (law == Law::coulomb) return scale.mu * contact::tangential_norm(u);
  if (law == Law::pyramid_k) return scale.mu * contact::pyramid_support(-u.tail<2>(), facets);
  return 0;
}

}  // namespace nilas::solvers
