#pragma once
/// Splitting of a floe by a crack that runs in from its edge: linear elastic fracture mechanics.
#include <Eigen/Core>

#include "fracture/split/tabulate.h"

namespace nilas {

/// Rectangular floe with an edge crack, as the crack sees it.
struct SplittingFloe {
  double length = 1;         ///< L along the crack's direction [m]
  double width = 1;          ///< W across it; the crack enters at mid-width [m]
  double thickness = 1;      ///< h [m]
  double toughness = 115e3;  ///< K_IC [Pa sqrt(m)]
};

/// Two opposed forces F_Y pull the mouth of an edge crack of length A open (plane stress, no other loads, inertia of
/// the halves neglected; forces along the crack do not load it):  K = F_Y H(A/L, W/L) / (h sqrt(L)).
/// H is interpolated (polynomials through Chebyshev points, infinitely smooth) in finite-element values of our own,
/// tests/bench/split_table.cpp, within 2e-4 of them for 0 < A/L <= 0.9 and 1/8 <= W/L <= 8. For short cracks it has the
/// exact limit of the half-plane, 2 pi / sqrt(pi^2 - 4) / sqrt(pi A/L), whose 2.5934 is 2.594 in handbooks. Wider floes
/// count as W/L = 8, where H has long become constant, narrower ones as 1/8; beyond A/L = 0.9 H grows with the power
/// -3/2 of 1 - A/L, as it does for a short ligament.
class SplittingTable {
 public:
  SplittingTable();

  /// 0 < crack = A/L < 1, width = W/L > 0, else ContractError.
  double H(double crack, double width) const;

  struct Least {
    double crack = 0, H = 0;
  };
  /// Least H over all crack lengths, and where: 5.348 at A/L = 0.142 for the square floe (flat: the literature's 0.145
  /// is as good). A crack up to there grows only while the force rises, a longer one runs through.
  Least least(double width) const;

  static constexpr int cracks = 33, widths = 21;

 private:
  using WidthShares = Eigen::Matrix<double, widths, 1>;
  static WidthShares width_shares(double width);

  Eigen::Matrix<double, cracks, widths> log_shape_;  ///< ln(H sqrt(A/L) (1 - A/L)^(3/2)) at the Chebyshev points
  TableSpline least_crack_, least_H_;                ///< of ln(W/L)
};

/// All below throw ContractError unless lengths, thickness and toughness are positive and A < L.
/// Stress intensity K [Pa sqrt(m)] of a crack of length A [m] under the forces F_Y [N].
double stress_intensity(const SplittingTable& table, const SplittingFloe& floe, double F_Y, double A);
/// Force F_Y [N] at which a crack of length A [m] grows.
double growth_force(const SplittingTable& table, const SplittingFloe& floe, double A);
/// Largest force [N] that a floe with a starter crack A0 [m] bears: the largest growth_force over A >= A0, that of the
/// least H for short starters.
double splitting_force(const SplittingTable& table, const SplittingFloe& floe, double A0);

/// Force along the crack of a symmetric wedge (half angle psi [rad], friction mu) that opens it with F_Y on each side:
/// F_X = 2 F_Y (tan psi + mu) / (1 - mu tan psi), from the balance of normal and friction force on its faces
/// (the form that Bhat 1988 and Lu, Lubbad & Loset 2015 are quoted with). 0 < psi, mu >= 0, mu tan psi < 1.
double wedge_force(double F_Y, double psi, double mu);
/// Its inverse: F_Y of a wedge that presses with F_X.
double opening_force(double F_X, double psi, double mu);

}  // namespace nilas
