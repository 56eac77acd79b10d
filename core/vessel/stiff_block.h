#pragma once
/// One step of a linear multi-coordinate system with springs of any stiffness.
#include <vector>

#include "core/base/math.h"

namespace nilas {

/// The step of M u' + damping_time K u + K q = F with an unknown impulse r, in the speeds u = (q - q of the step
/// before) / h:
///
///   u+ = decay u + response (h (F - K q) + r),    q+ = q + h u+.
///
/// Each mode of K phi = omega^2 M phi, phi^T M phi = 1, takes the exact step of exponential_mode.h. With Phi the modes
/// as columns: response = Phi diag(response_j) Phi^T and decay = Phi diag(decay_j) Phi^T M.
struct StiffBlock {
  MatX mass;      ///< n x n, response^-1, symmetric positive definite: M itself for coordinates without spring
  MatX response;  ///< n x n, symmetric positive definite
  MatX decay;     ///< n x n
};

/// mass: M, n x n, symmetric positive definite. stiffness: K, n x n, symmetric, its rows and columns of the coordinates
/// `free` exactly zero, positive definite on the others. damping_time [s]. h: step [s].
/// Throws SimulationError when M or K is not positive definite.
StiffBlock stiff_block(const MatX& mass, const MatX& stiffness, double damping_time, const std::vector<int>& free,
                       double h);

}  // namespace nilas
