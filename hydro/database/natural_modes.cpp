#include <algorithm>
#include <cmath>

#include "hydro/database/self_check.h"

namespace nilas::hydro {

Mat6 added_mass_at(const Database& database, double frequency) {
  const auto& w = database.frequency;
  if (frequency <= w.front()) return database.added_mass.front();
  if (frequency >= w.back()) return database.added_mass.back();
  const auto above = static_cast<std::size_t>(std::upper_bound(w.begin(), w.end(), frequency) - w.begin());
  const double share = (frequency - w[above - 1]) / (w[above] - w[above - 1]);
  return (1 - share) * database.added_mass[above - 1] + share * database.added_mass[above];
}

namespace {

/// The n-th square of a natural frequency, from the lowest, with the added mass held, and its mode.
struct HeldMode {
  double square = 0;
  int mode = 0;
};

HeldMode held_mode(const Database& database, const Mat6& mass, double frequency, Eigen::Index n) {
  Mat6 inertia = mass + added_mass_at(database, frequency);
  Mat6 stiffness = *database.restoring;
  inertia = Mat6(0.5 * (inertia + inertia.transpose()));
  stiffness = Mat6(0.5 * (stiffness + stiffness.transpose()));
  const Eigen::GeneralizedSelfAdjointEigenSolver<Mat6> solver(stiffness, inertia);
  HeldMode held{solver.eigenvalues()[n], 0};
  const Vec6 shape = solver.eigenvectors().col(n);
  Vec6 energy = shape.cwiseAbs2().cwiseProduct(inertia.diagonal());
  energy.maxCoeff(&held.mode);
  return held;
}

}  // namespace

std::vector<NaturalMode> natural_modes(const Database& database, const Mat6& mass) {
  std::vector<NaturalMode> modes;
  if (!database.restoring) return modes;
  // An inertia that is not positive has no natural modes.
  if (Eigen::LLT<Mat6>(mass + database.added_mass.front()).info() != Eigen::Success) return modes;
  constexpr double k_some = 1e-9;  // share of the largest square below which a mode is free
  for (Eigen::Index n = 0; n < Vec6::SizeAtCompileTime; ++n) {
    double low = 0, high = std::sqrt(std::max(0.0, held_mode(database, mass, 0, Vec6::SizeAtCompileTime - 1).square));
    const double start = held_mode(database, mass, 0, n).square;
    if (start <= k_some * high * high) continue;
    high *= 2;  // added mass falls by less than a factor four between the limits
    constexpr int k_halvings = 60;
    for (int step = 0; step < k_halvings; ++step) {
      const double middle = 0.5 * (low + high);
      (held_mode(database, mass, middle, n).square > middle * middle ? low : high) = middle;
    }
    modes.push_back({held_mode(database, mass, low, n).mode, 2 * k_pi / low});
  }
  return modes;
}

}  // namespace nilas::hydro
