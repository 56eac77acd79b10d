#include "hydro/radiation/damping.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "core/base/error.h"

namespace nilas::hydro {

namespace {

constexpr int k_mode_count = 6, k_translations = 3;
constexpr std::array<const char*, k_mode_count> k_mode_names{"surge", "sway", "heave", "roll", "pitch", "yaw"};
/// Modes below this share of the largest of their kind radiate nothing: rotations of a sphere, by the digits of a file.
constexpr double k_silent_share = 1e-6;
constexpr double k_least_coupling = 1e-3, k_most_asymmetry = 0.1, k_most_removed = 0.05;
constexpr double k_bad_eigenvalue = -0.01;
/// A negative eigenvalue above this is rounding of the file.
constexpr double k_rounding = -1e-5;
constexpr double k_high_share = 1e-3, k_doubtful_last = 0.1;
constexpr std::size_t k_fewest_frequencies = 8;
/// The tail has knots at this ratio; 24 of them reach 10 times the last frequency.
constexpr double k_tail_ratio = 1.1, k_least_power = 3, k_most_power = 8, k_power_from = 0.8;
constexpr int k_tail_knots = 24;

struct Eigenvalues {
  Vec6 values;
  Mat6 vectors;
};

Eigenvalues eigenvalues(const Mat6& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Mat6> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

std::vector<Mat6> symmetric_damping(const Database& database) {
  std::vector<Mat6> B;
  for (const Mat6& of_file : database.damping) B.emplace_back(0.5 * (of_file + of_file.transpose()));
  return B;
}

/// The root of each mode's peak of |B_ii|, so that a damping of the wrong sign shows; zero where the mode does not
/// radiate.
Vec6 scale_of(const std::vector<Mat6>& B, const std::optional<double>& volume) {
  Vec6 peak = Vec6::Zero();
  for (const Mat6& at : B) peak = peak.cwiseMax(at.diagonal().cwiseAbs());
  const double of_translation = peak.head<k_translations>().maxCoeff();
  double of_rotation = peak.tail<k_translations>().maxCoeff();
  if (volume) of_rotation = std::max(of_rotation, of_translation * std::pow(std::cbrt(*volume), 2));
  Vec6 scale = Vec6::Zero();
  for (int mode = 0; mode < k_mode_count; ++mode)
    if (peak[mode] > k_silent_share * (mode < k_translations ? of_translation : of_rotation))
      scale[mode] = std::sqrt(peak[mode]);
  return scale;
}

Mat6 scaled(const Mat6& B, const Vec6& scale) {
  Mat6 out = Mat6::Zero();
  for (int i = 0; i < k_mode_count; ++i)
    for (int j = 0; j < k_mode_count; ++j)
      if (scale[i] > 0 && scale[j] > 0) out(i, j) = B(i, j) / (scale[i] * scale[j]);
  return out;
}

std::vector<std::vector<int>> coupled_modes(const std::vector<Mat6>& Bhat, const Vec6& scale) {
  std::array<int, k_mode_count> group{};
  std::iota(group.begin(), group.end(), 0);
  for (const Mat6& at : Bhat)
    for (int i = 0; i < k_mode_count; ++i)
      for (int j = 0; j < i; ++j) {
        const int from = group[i], to = group[j];
        if (std::abs(at(i, j)) > k_least_coupling && from != to)
          for (int& g : group)
            if (g == std::max(from, to)) g = std::min(from, to);
      }
  std::vector<std::vector<int>> groups;
  for (int first = 0; first < k_mode_count; ++first) {
    std::vector<int> modes;
    for (int mode = 0; mode < k_mode_count; ++mode)
      if (group[mode] == first && scale[mode] > 0) modes.push_back(mode);
    if (!modes.empty()) groups.push_back(std::move(modes));
  }
  return groups;
}

void leave_out_weak_coupling(const std::vector<std::vector<int>>& groups, std::vector<Mat6>& Bhat) {
  Mat6 kept = Mat6::Zero();
  for (const auto& modes : groups)
    for (const int i : modes)
      for (const int j : modes) kept(i, j) = 1;
  for (Mat6& at : Bhat) at = at.cwiseProduct(kept);
}

double asymmetry_of(const Database& database, const Vec6& scale, DampingReport& report) {
  double worst_frequency = 0;
  for (std::size_t k = 0; k < database.damping.size(); ++k) {
    const Mat6 difference = scaled(database.damping[k] - database.damping[k].transpose(), scale);
    const double most = difference.cwiseAbs().maxCoeff();
    if (most > report.asymmetry) {
      report.asymmetry = most;
      worst_frequency = database.frequency[k];
    }
  }
  return worst_frequency;
}

/// Number of frequencies that are used: up to the first whose damping is clearly negative, once it has fallen from the
/// peak.
std::size_t usable(const std::vector<double>& w, const std::vector<Mat6>& Bhat, double peak, DampingReport& report) {
  std::size_t used = w.size();
  for (std::size_t k = 0; k < w.size(); ++k) {
    const Vec6 found = eigenvalues(Bhat[k]).values;
    if (found[0] < report.lowest) {
      report.lowest = found[0];
      report.lowest_frequency = w[k];
    }
    const bool has_fallen = w[k] > peak && k > 0 && Bhat[k - 1].diagonal().maxCoeff() < k_doubtful_last;
    if (found[0] < k_bad_eigenvalue && has_fallen) used = std::min(used, k);
  }
  report.dropped = static_cast<int>(w.size() - used);
  if (used < w.size())
    report.notes.push_back(fmt::format(
        "The damping is negative at {:.4g} rad/s ({:.2g} of its peak), so {} frequencies from there on are not used.",
        w[used], eigenvalues(Bhat[used]).values[0], report.dropped));
  return used;
}

void remove_negative(const std::vector<double>& w, std::vector<Mat6>& Bhat, DampingReport& report) {
  double removed = 0, whole = 0;
  for (std::size_t k = 0; k < w.size(); ++k) {
    const double width = 0.5 * (w[std::min(k + 1, w.size() - 1)] - w[k > 0 ? k - 1 : 0]);
    whole += width * Bhat[k].squaredNorm();
    const Eigenvalues found = eigenvalues(Bhat[k]);
    if (!(found.values[0] < 0)) continue;
    if (found.values[0] < k_rounding) ++report.negative;
    const Mat6 repaired = found.vectors * found.values.cwiseMax(0).asDiagonal() * found.vectors.transpose();
    removed += width * (repaired - Bhat[k]).squaredNorm();
    Bhat[k] = 0.5 * (repaired + repaired.transpose());
  }
  report.removed = std::sqrt(removed / whole);
}

double tail_power(const std::vector<double>& w, const std::vector<Mat6>& Bhat) {
  const double last = Bhat.back().trace();
  std::size_t from = w.size() - 1;
  while (from > 0 && w[from] > k_power_from * w.back()) --from;
  if (!(last > 0) || !(Bhat[from].trace() > 0) || from + 1 == w.size()) return k_most_power;
  const double power = std::log(Bhat[from].trace() / last) / std::log(w.back() / w[from]);
  return std::clamp(power, k_least_power, k_most_power);
}

PiecewiseCubic extended(std::vector<double> w, std::vector<Mat6> Bhat, double power) {
  const double last = w.back();
  const Mat6 at_last = Bhat.back();
  w.insert(w.begin(), 0.0);
  Bhat.insert(Bhat.begin(), Mat6::Zero());
  for (int k = 0; k < k_tail_knots; ++k) {
    w.push_back(w.back() * k_tail_ratio);
    Bhat.emplace_back(at_last * std::pow(last / w.back(), power));
  }
  MatX rows(w.size(), k_mode_count * k_mode_count);
  for (std::size_t k = 0; k < w.size(); ++k)
    rows.row(static_cast<Eigen::Index>(k)) =
        Eigen::Map<const Eigen::RowVectorXd>(Bhat[k].data(), k_mode_count * k_mode_count);
  return {std::move(w), std::move(rows)};
}

/// Half of 2 pi over the widest spacing of frequencies between which a thousandth of the damping's square lies.
double longest_memory(const std::vector<double>& w, const std::vector<Mat6>& Bhat) {
  double whole = 0, widest = w.front();
  for (std::size_t k = 1; k < w.size(); ++k) whole += (w[k] - w[k - 1]) * Bhat[k].squaredNorm();
  for (std::size_t k = 1; k < w.size(); ++k)
    if ((w[k] - w[k - 1]) * Bhat[k].squaredNorm() > k_high_share * whole) widest = std::max(widest, w[k] - w[k - 1]);
  return k_pi / widest;
}

std::string modes_with_negative(const Vec6& scale, const std::vector<Mat6>& B) {
  std::string names;
  for (int mode = 0; mode < k_mode_count; ++mode) {
    const bool negative = std::any_of(B.begin(), B.end(), [&](const Mat6& at) {
      return scale[mode] > 0 && at(mode, mode) < k_rounding * scale[mode] * scale[mode];
    });
    if (negative) names += (names.empty() ? "" : ", ") + std::string(k_mode_names[mode]);
  }
  return names.empty() ? "a combination of modes" : names;
}

void note_repairs(const std::string& modes, DampingReport& report) {
  if (report.negative > 0)
    report.notes.push_back(fmt::format(
        "The damping of {} is negative at {} used frequencies (lowest in the file {:.2g} of its peak, at {:.4g} "
        "rad/s); it was set to zero there, which removed {:.2g} % of the damping.",
        modes, report.negative, report.lowest, report.lowest_frequency, 1e2 * report.removed));
  if (report.last_share > k_doubtful_last)
    report.notes.push_back(fmt::format(
        "At the last used frequency, {:.4g} rad/s, the damping is still {:.2g} of its peak; the memory follows from "
        "the assumed tail w^-{:.2g}.",
        report.last_frequency, report.last_share, report.tail_power));
}

void demand_usable(const Database& database) {
  const auto& w = database.frequency;
  if (w.size() < k_fewest_frequencies || database.damping.size() != w.size() || database.added_mass.size() != w.size())
    throw InputError(
        fmt::format("{}: found radiation at {} frequencies; allowed: at least {}, with added mass and "
                    "damping at each",
                    database.source, w.size(), k_fewest_frequencies));
}

double peak_of(const std::vector<double>& w, const std::vector<Mat6>& Bhat) {
  const auto less = [](const Mat6& a, const Mat6& b) { return a.trace() < b.trace(); };
  return w[std::max_element(Bhat.begin(), Bhat.end(), less) - Bhat.begin()];
}

}  // namespace

RadiationDamping prepare_damping(const Database& database, std::optional<double> highest) {
  demand_usable(database);
  RadiationDamping out;
  std::vector<double> w = database.frequency;
  std::vector<Mat6> B = symmetric_damping(database);
  if (highest) w.resize(std::upper_bound(w.begin(), w.end(), *highest) - w.begin());
  out.report.dropped = static_cast<int>(B.size() - w.size());
  B.resize(w.size());
  out.scale = scale_of(B, database.volume);
  if (w.size() < k_fewest_frequencies || !(out.scale.maxCoeff() > 0))
    throw InputError(database.source + ": found no radiation damping above zero" +
                     (highest ? fmt::format(" up to {:.4g} rad/s", *highest) : "") +
                     "; allowed: a body that makes waves at 8 frequencies or more");

  const double asymmetric_at = asymmetry_of(database, out.scale, out.report);
  std::vector<Mat6> Bhat;
  for (const Mat6& at : B) Bhat.push_back(scaled(at, out.scale));
  out.peak_frequency = peak_of(w, Bhat);
  const std::size_t used = usable(w, Bhat, out.peak_frequency, out.report);
  if (used < k_fewest_frequencies)
    throw InputError(
        fmt::format("{}: the damping is negative at {:.4g} rad/s ({:.2g} of its peak), so only {} "
                    "frequencies are of use; allowed: damping that is not negative",
                    database.source, out.report.lowest_frequency, out.report.lowest, used));
  w.resize(used);
  Bhat.resize(used);
  if (out.report.asymmetry > k_most_asymmetry && asymmetric_at <= w.back())
    throw InputError(
        fmt::format("{}: the damping matrix is not symmetric: at {:.4g} rad/s B_ij and B_ji differ by "
                    "{:.2g} of the peaks; allowed: {}",
                    database.source, asymmetric_at, out.report.asymmetry, k_most_asymmetry));
  out.groups = coupled_modes(Bhat, out.scale);
  leave_out_weak_coupling(out.groups, Bhat);
  remove_negative(w, Bhat, out.report);
  if (out.report.removed > k_most_removed)
    throw InputError(
        fmt::format("{}: the damping is negative at {} frequencies, the worst {:.4g} rad/s ({:.2g} of its peak); "
                    "setting it to zero "
                    "would change {:.2g} % of the damping; allowed: {:.2g} %",
                    database.source, out.report.negative, out.report.lowest_frequency, out.report.lowest,
                    1e2 * out.report.removed, 1e2 * k_most_removed));
  out.report.last_frequency = w.back();
  out.report.last_share = Bhat.back().diagonal().maxCoeff();
  out.report.tail_power = tail_power(w, Bhat);
  note_repairs(modes_with_negative(out.scale, B), out.report);
  out.longest_memory = longest_memory(w, Bhat);
  const double peak = Bhat[std::find(w.begin(), w.end(), out.peak_frequency) - w.begin()].trace();
  out.high_frequency = out.peak_frequency;
  for (std::size_t k = 0; k < w.size(); ++k)
    if (Bhat[k].trace() > k_high_share * peak) out.high_frequency = w[k];
  out.scaled = extended(std::move(w), std::move(Bhat), out.report.tail_power);
  return out;
}

}  // namespace nilas::hydro
