#pragma once
/// Splitting of a floe by a crack from its edge, by linear elastic fracture mechanics.
#include <Eigen/Core>

#include "fracture/split/tabulate.h"

namespace nilas::fracture {

/// A rectangular floe with an edge crack.
struct SplittingFloe {
  double length = 1;         ///< L: along the crack's direction [m].
  double width = 1;          ///< W: across it; the crack lies at mid width [m].
  double thickness = 1;      ///< h [m]
  double toughness = 115e3;  ///< K_IC [Pa sqrt(m)]
};

/// The function H of K = F_Y H(A/L, W/L) / (h sqrt(L)). Two opposed forces F_Y pull open the mouth of an edge crack of
/// the length A, in plane stress. The inertia of the halves and forces along the crack are neglected. H is interpolated
/// by polynomials through Chebyshev points in values of finite elements (tests/bench/split_table.cpp). It is within
/// 2e-4 of them for 0 < A/L <= 0.9 and 1/8 <= W/L <= 8. For short cracks it has the exact limit of the half-plane, 2 pi
/// / sqrt(pi^2 - 4) / sqrt(pi A/L), whose factor is 2.5934 (docs/theory/fracture.md). Wider floes count as W/L = 8,
/// where H has long become constant, narrower ones as 1/8. Beyond A/L = 0.9 H grows with the power -3/2 of 1 - A/L, as
/// for a short ligament.
class SplittingTable {
 public:
  SplittingTable();

  /// H for crack = A/L and width = W/L. Throws ContractError unless 0 < crack < 1 and width > 0.
  double H(double crack, double width) const;

  /// The least H, and the A/L that has it.
  struct Least {
    double crack = 0, H = 0;
  };
  /// The least H over all crack lengths, 5.348 at A/L = 0.142 for the square floe. The minimum is flat. A shorter crack
  /// grows only while the force rises, a longer one runs through.
  Least least(double width) const;

  static constexpr int cracks = 33, widths = 21;

 private:
  using WidthShares = Eigen::Matrix<double, widths, 1>;
  static WidthShares width_shares(double width);

  Eigen::Matrix<double, cracks, widths> log_shape_;  ///< ln(H sqrt(A/L) (1 - A/L)^(3/2)) at the Chebyshev points.
  TableSpline least_crack_, least_H_;                ///< Functions of ln(W/L).
};

/// The stress intensity K [Pa sqrt(m)] of a crack of length A [m] under the forces F_Y [N]. This and the next two
/// functions throw ContractError unless lengths, thickness and toughness are positive and A < L.
double stress_intensity(const SplittingTable& table, const SplittingFloe& floe, double F_Y, double A);
/// The force F_Y [N] at which a crack of length A [m] grows.
double growth_force(const SplittingTable& table, const SplittingFloe& floe, double A);
/// The largest force F_Y [N] that a floe with a starter crack A0 [m] bears: the largest growth_force over A >= A0. For
/// a short starter crack it is that of the least H.
double splitting_force(const SplittingTable& table, const SplittingFloe& floe, double A0);

/// The force F_X [N] along the crack of a symmetric wedge (half angle psi [rad], friction mu) that opens it with F_Y on
/// each side. The balance of normal and friction force on its faces gives
/// F_X = 2 F_Y (tan psi + mu) / (1 - mu tan psi); docs/theory/fracture.md has the derivation. Throws ContractError
/// unless 0 < psi < pi / 2, mu >= 0 and mu tan psi < 1.
double wedge_force(double F_Y, double psi, double mu);
/// The inverse of wedge_force: F_Y [N] of a wedge that presses with F_X [N].
double opening_force(double F_X, double psi, double mu);

}  // namespace nilas::fracture
