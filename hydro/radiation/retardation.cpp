#include "hydro/radiation/retardation.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"

namespace nilas::hydro {

namespace {

constexpr int k_entries = 36;
/// Root of the share of int K^2 that the default memory leaves out.
constexpr double k_left_by_default = 1e-3;
/// The kernel is computed over this many periods of the peak; later it is below rounding of usual files.
constexpr double k_horizon_periods = 10;
/// Phase of the highest frequency over one knot; the spline then errs by about (phase)^4 / 384, 1e-6.
constexpr double k_phase_of_step = 0.15;
constexpr std::size_t k_most_knots = 20000;

Mat6 unscaled(const Eigen::Ref<const Eigen::RowVectorXd>& row, const Vec6& scale) {
  const Mat6 entries = Eigen::Map<const Mat6>(VecX(row.transpose()).data());
  return scale.asDiagonal() * entries * scale.asDiagonal();
}

PiecewiseCubic scaled_kernel(const RadiationDamping& damping, double horizon) {
  const auto count = static_cast<std::size_t>(std::ceil(horizon * damping.high_frequency / k_phase_of_step)) + 1;
  const std::size_t knots = std::clamp<std::size_t>(count, 3, k_most_knots);
  std::vector<double> t(knots);
  MatX rows(knots, k_entries);
  for (std::size_t k = 0; k < knots; ++k) {
    t[k] = horizon * static_cast<double>(k) / static_cast<double>(knots - 1);
    rows.row(static_cast<Eigen::Index>(k)) = 2 / k_pi * damping.scaled.fourier(t[k]).real().transpose();
  }
  // K is even in t, so its slope at 0 is zero.
  return {std::move(t), std::move(rows), 0.0};
}

/// The root of the share of int K^2 beyond each knot.
std::vector<double> left_after(const PiecewiseCubic& kernel) {
  const auto& t = kernel.knots();
  std::vector<double> left(t.size(), 0);
  for (std::size_t k = t.size() - 1; k-- > 0;)
    left[k] = left[k + 1] + 0.5 * (t[k + 1] - t[k]) *
                                (kernel.values().row(static_cast<Eigen::Index>(k)).squaredNorm() +
                                 kernel.values().row(static_cast<Eigen::Index>(k) + 1).squaredNorm());
  const double whole = left[0];
  for (double& x : left) x = std::sqrt(x / whole);
  return left;
}

/// Ogilvie's (1 / w) int K sin(w t) dt, in physical units.
Mat6 ogilvie_term(const PiecewiseCubic& kernel, const Vec6& scale, double w) {
  return unscaled(kernel.fourier(w).imag().transpose() / w, scale);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Retardation retardation(const RadiationDamping& damping, std::optional<double> memory) {
  const double usual = k_horizon_periods * 2 * k_pi / damping.peak_frequency;
  Retardation out;
  out.scaled = scaled_kernel(damping, std::max(usual, memory.value_or(0)));
  const auto& t = out.scaled.knots();
  out.step = t[1];
  const std::vector<double> left = left_after(out.scaled);
  std::size_t last = 1;
  while (last + 1 < t.size() && (memory ? t[last] < *memory : left[last] > k_left_by_default)) ++last;
  out.memory = memory.value_or(t[last]);
  out.left = left[last];
  for (std::size_t k = t.size(); k-- > 0 && t[k] > damping.longest_memory;) out.unresolved = left[k];

  const MatX first = out.scaled.integrals();
  // K1 is a spline whose slope at zero is K(0); its values suffice for K2 at the knots to the order of the spline.
  constexpr double k_slope_share = 1.0 / 12;
  Mat6 second = Mat6::Zero();
  for (std::size_t k = 0; k <= last; ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    out.K.push_back(unscaled(out.scaled.values().row(row), damping.scale));
    out.K1.push_back(unscaled(first.row(row), damping.scale));
    if (k > 0)
      second += 0.5 * out.step * (out.K1[k - 1] + out.K1[k]) +
                k_slope_share * out.step * out.step * (out.K[k - 1] - out.K[k]);
    out.K2.push_back(second);
  }
  return out;
}

InfiniteAddedMass infinite_added_mass(const Database& database, const RadiationDamping& damping,
                                      const Retardation& kernel) {
  std::vector<Mat6> each, terms;
  std::vector<double> w;
  for (std::size_t k = 0; k < database.frequency.size(); ++k) {
    if (database.frequency[k] > damping.report.last_frequency) break;
    w.push_back(database.frequency[k]);
    terms.push_back(ogilvie_term(kernel.scaled, damping.scale, w.back()));
    const Mat6& A = database.added_mass[k];
    each.emplace_back(0.5 * (A + A.transpose()) + terms.back());
  }
  InfiniteAddedMass out;
  out.from_file = database.added_mass_infinite.has_value();
  Vec6 most = Vec6::Zero();
  for (std::size_t k = 0; k < w.size(); ++k) most = most.cwiseMax((each[k] - terms[k]).diagonal().cwiseAbs());
  for (int i = 0; i < most.size(); ++i)
    for (int j = 0; j < most.size(); ++j) {
      std::vector<double> entry;
      for (const Mat6& at : each) entry.push_back(at(i, j));
      out.value(i, j) = out.from_file
                            ? 0.5 * ((*database.added_mass_infinite)(i, j) + (*database.added_mass_infinite)(j, i))
                            : median(entry);
      for (double& x : entry) x = std::abs(x - out.value(i, j));
      out.scatter(i, j) = median(entry);
    }
  double squares = 0;
  for (std::size_t k = 0; k < w.size(); ++k) {
    double worst = 0;
    for (int i = 0; i < most.size(); ++i)
      for (int j = 0; j < most.size(); ++j)
        if (damping.scale[i] > 0 && damping.scale[j] > 0)
          worst = std::max(worst, std::abs(each[k](i, j) - out.value(i, j)) / std::sqrt(most[i] * most[j]));
    squares += worst * worst;
    if (worst > out.worst) {
      out.worst = worst;
      out.worst_frequency = w[k];
    }
  }
  out.root_mean_square = std::sqrt(squares / static_cast<double>(w.size()));
  return out;
}

Database with_infinite_added_mass(Database database) {
  if (database.added_mass_infinite)
    throw InputError(database.source +
                     ": has the added mass at infinite frequency already; nothing is to be completed");
  const RadiationDamping damping = prepare_damping(database);
  const InfiniteAddedMass found = infinite_added_mass(database, damping, retardation(damping));
  database.added_mass_infinite = found.value;
  database.notes.insert(database.notes.end(), damping.report.notes.begin(), damping.report.notes.end());
  database.notes.push_back(fmt::format(
      "The added mass at infinite frequency is that of Ogilvie's relation between added mass and damping; over the "
      "frequencies it scatters by {:.3g} kg in surge, {:.3g} kg in heave and {:.3g} kg m^2 in pitch.",
      found.scatter(0, 0), found.scatter(2, 2), found.scatter(4, 4)));
  return database;
}

}  // namespace nilas::hydro
