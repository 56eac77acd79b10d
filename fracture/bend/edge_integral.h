#pragma once
/// Fourier solution of a semi-infinite floating plate that is loaded on its free edge, by quadrature.
#include <vector>

namespace nilas {

/// Lengths in l, loads in P, deflections in P / (k l^2). With x into the sheet, y along the edge and wavenumber a,
/// w = Re(A exp(-m x)) cos(a y), m^2 = a^2 + i. No edge moment (w'' - nu a^2 w = 0) gives A = i c / (s + i) with
/// s = (1 - nu) a^2; the edge's shear w''' - (2 - nu) a^2 w' = load then gives the deflection of the edge per load
///     G(a) = 1 / (2 s Re m + (1 - s^2) Im m),
/// and the moment along the edge is M_y = (1 - nu^2) a^2 G. (Nevel 1965 and Westergaard 1948 treat the same plate.)
class EdgeIntegral {
 public:
  /// 0 <= nu <= 0.5, else ContractError.
  explicit EdgeIntegral(double nu);

  /// S(u) = 1/pi int_0^inf (1 - nu^2) a G(a) sin(a u) da, to 1e-10 of it for u in (0, 1], 1e-11 absolute to u = 20;
  /// odd in u. A line load P over |y| < b bends the edge at y with M_y = P (S(b + y) + S(b - y)) / (2 b).
  double moment(double u) const;
  /// w k l^2 / P under a point load on the edge, to 1e-10.
  double deflection() const;
  /// Slope of 6 M_y / P at the middle of the load against -ln b for b -> 0: 12 (1 + nu) / (pi (3 + nu)).
  double log_slope() const;

 private:
  double transfer(double a) const;

  double nu_;
  struct Node {
    double a, weight;  ///< weight of sin(a u)
  };
  std::vector<Node> rest_;  ///< what remains of the integrand when its slowly decaying part is taken out
};

}  // namespace nilas
