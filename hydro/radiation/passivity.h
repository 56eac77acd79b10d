#pragma once
/// Whether a rational model can give energy to the body.
#include <vector>

#include "hydro/radiation/rational.h"

namespace nilas::hydro {

/// The frequencies [rad/s] at which an eigenvalue of the Hermitian part of H(i w) passes through -margin, rising. They
/// are the imaginary eigenvalues of the Hamiltonian matrix of H + margin [Boyd, Balakrishnan & Kabamba 1989;
/// Grivet-Talocia 2004], so none lies hidden between sampled frequencies. H falls to zero at w = 0 and at infinity;
/// therefore the margin must be above rounding.
std::vector<double> crossings(const RationalModel& model, double margin);

/// The smallest eigenvalue of the Hermitian part of H(i w).
double lowest_damping(const RationalModel& model, double w);

/// Whether the Hermitian part of H(i w) is at least -margin at all w: no crossing, and not below at one frequency.
bool is_passive(const RationalModel& model, double margin);

}  // namespace nilas::hydro
