#pragma once
/// Nearest points of friction cones. Vectors are (N, T1, T2), distances Euclidean.
#include <cmath>

#include "core/base/math.h"

namespace nilas::contact {

/// |x_T|
inline double tangential_norm(const Vec3& x) { return std::sqrt(x[1] * x[1] + x[2] * x[2]); }

/// Nearest point of {|x_T| <= mu x_N}. mu = 0 is the normal half line, mu infinite the half space x_N >= 0.
Vec3 project_cone(const Vec3& x, double mu);

/// Nearest point of the truncated cone {|x_T| <= mu x_N, x_N <= cap}, cap >= 0 or infinite.
Vec3 project_cone(const Vec3& x, double mu, double cap);

/// Nearest point of the inscribed pyramid {x_T in x_N mu P, x_N <= cap}; P is the regular polygon with `facets` >= 3
/// corners e_k = (cos, sin)(2 pi k / facets). mu finite.
Vec3 project_pyramid(const Vec3& x, double mu, int facets, double cap);

/// max over corners of e_k . t: the support function of P.
double pyramid_support(const Vec2& t, int facets);

}  // namespace nilas::contact
