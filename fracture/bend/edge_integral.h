#pragma once
/// Fourier solution of a semi-infinite floating plate that is loaded on its free edge, by quadrature.
#include <vector>

namespace nilas::fracture {

/// The integral over the wavenumber a along the edge. Lengths are in l, loads in P, deflections in P / (k l^2). With x
/// into the sheet and y along the edge, w = Re(A exp(-m x)) cos(a y), m^2 = a^2 + i. The edge bears no moment,
/// w'' - nu a^2 w = 0, which gives A = i c / (s + i) with s = (1 - nu) a^2. The edge's shear w''' - (2 - nu) a^2 w' is
/// the load, so that the deflection of the edge per load is
///     G(a) = 1 / (2 s Re m + (1 - s^2) Im m).
/// The moment along the edge is M_y = (1 - nu^2) a^2 G. docs/theory/fracture.md has the derivation. Westergaard (1948)
/// and Kerr and Kwak (1993) treat plates that are loaded at such an edge.
class EdgeIntegral {
 public:
  /// Takes Poisson's ratio. Throws ContractError unless 0 <= nu <= 0.5.
  explicit EdgeIntegral(double nu);

  /// S(u) = 1/pi int_0^inf (1 - nu^2) a G(a) sin(a u) da, odd in u. The error is 1e-10 of it for u in (0, 1], and 1e-11
  /// absolute up to u = 20. A line load P over |y| < b bends the edge at y with M_y = P (S(b + y) + S(b - y)) / (2 b).
  double moment(double u) const;
  /// The deflection w k l^2 / P under a point load on the edge, with an error of 1e-10.
  double deflection() const;
  /// The slope of 6 M_y / P at the middle of the load against -ln b for b -> 0: 12 (1 + nu) / (pi (3 + nu)).
  double log_slope() const;

 private:
  double transfer(double a) const;

  double nu_;
  struct Node {
    double a, weight;  ///< Place, and weight of sin(a u).
  };
  std::vector<Node> rest_;  ///< The integrand without its slowly decaying part.
};

}  // namespace nilas::fracture
