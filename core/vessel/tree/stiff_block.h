#pragma once
/// One step of a linear multi-coordinate system with springs of any stiffness.
#include <limits>
#include <vector>

#include "core/base/math.h"

namespace nilas::vessel {

/// The step of M u' + damping_time K u + K q = F with an unknown impulse r, in the speeds u = (q - q of the step
/// before) / h:
///
///   u+ = kept u + response (h (F - damping_time K u - K q) + r),    q+ = q + h u+,
///
/// so all forces are those at the step's start, springs and dampers included. Each mode of K phi = omega^2 M phi,
/// phi^T M phi = 1, takes the exact step of exponential_mode.h, whose decay holds the damper's part: kept_j = decay_j +
/// response_j h damping_time omega_j^2. With Phi the modes as columns: response = Phi diag(response_j) Phi^T and kept =
/// Phi diag(kept_j) Phi^T M.
///
/// Coordinates that neither M nor K couples are solved apart, so that all entries between them are exactly zero. Else
/// the rounding of the modes would couple them, and a vessel that is its own mirror image would begin to sway.
struct StiffBlock {
  MatX mass;      ///< n x n, response^-1, symmetric positive definite: M itself for coordinates without spring
  MatX response;  ///< n x n, symmetric positive definite
  MatX kept;      ///< n x n: factor of the speeds before the step
};

/// Entries a_ij of M or K below this share of sqrt(a_ii a_jj) are rounding and count as zero. Entries are sums of a few
/// products, and each product rounds by at most half an eps of that root.
constexpr double k_coupling_floor = 32 * std::numeric_limits<double>::epsilon();

/// Sets of coordinates that M and K couple, directly or through others. Each set is in rising order, and the sets are
/// ordered by their first coordinate. M and K as below.
std::vector<std::vector<int>> coupled_sets(const MatX& mass, const MatX& stiffness);

/// The coefficients of the step. `mass`: M, n x n, symmetric positive definite. `stiffness`: K, n x n, symmetric; its
/// rows and columns of the coordinates `free` are exactly zero, and it is positive definite on the others.
/// `damping_time` [s]. `h`: step [s]. Throws SimulationError when M or K is not positive definite.
StiffBlock stiff_block(const MatX& mass, const MatX& stiffness, double damping_time, const std::vector<int>& free,
                       double h);

}  // namespace nilas::vessel
