#include "hydro/database/self_check.h"

#include <algorithm>
#include <cmath>

#include "hydro/database/heading_circle.h"
#include "hydro/database/response.h"
#include "hydro/database/wave_number.h"

namespace nilas::hydro {

namespace {

constexpr int k_checked_modes = 6;

/// The largest diagonal term of each mode over all frequencies.
Vec6 peaks(const std::vector<Mat6>& matrices) {
  Vec6 peak = Vec6::Zero();
  for (const Mat6& matrix : matrices) peak = peak.cwiseMax(Vec6(matrix.diagonal().cwiseAbs()));
  return peak;
}

/// The asymmetry of one pair of modes over all matrices; its share is 0 where the terms are noise.
Asymmetry pair_asymmetry(const std::vector<Mat6>& matrices, const std::vector<double>& frequency, int i, int j,
                         double noise) {
  Asymmetry pair;
  pair.i = i;
  pair.j = j;
  double differences = 0, values = 0, peak = 0, largest = -1;
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    const double one = matrices[k](i, j), other = matrices[k](j, i), value = std::max(std::abs(one), std::abs(other));
    differences += std::abs(one - other);
    values += value;
    peak = std::max(peak, value);
    if (std::abs(one - other) <= largest) continue;
    largest = std::abs(one - other);
    pair.frequency = frequency[k];
    pair.value = one;
    pair.transposed = other;
  }
  pair.share = peak > noise ? differences / values : 0;
  return pair;
}

Asymmetry asymmetry_of(const Database& database) {
  // Shares of the modes' scales below which errors of the panels set the terms; they are larger in damping.
  constexpr double k_noise_mass = 5e-3, k_noise_damping = 2e-2;
  Asymmetry worst;
  for (const bool damping : {false, true}) {
    const std::vector<Mat6>& matrices = damping ? database.damping : database.added_mass;
    const Vec6 scale = mode_scale(database, matrices);
    for (int i = 0; i < k_checked_modes; ++i)
      for (int j = i + 1; j < k_checked_modes; ++j) {
        Asymmetry pair = pair_asymmetry(matrices, database.frequency, i, j,
                                        (damping ? k_noise_damping : k_noise_mass) * std::sqrt(scale[i] * scale[j]));
        pair.in_damping = damping;
        if (pair.share > worst.share) worst = pair;
      }
  }
  return worst;
}

/// Modes whose damping is negative over the frequencies as a whole.
std::vector<int> reversed_modes(const Database& database) {
  constexpr double k_some = 1e-3;  // share of the scale of the mode above which damping is more than noise
  const Vec6 peak = peaks(database.damping), scale = mode_scale(database, database.damping);
  std::vector<int> modes;
  for (int i = 0; i < k_checked_modes; ++i) {
    double sum = 0;
    for (const Mat6& b : database.damping) sum += b(i, i);
    if (sum < 0 && peak[i] > k_some * scale[i]) modes.push_back(i);
  }
  return modes;
}

std::vector<NegativeDamping> negative_damping(const Database& database) {
  constexpr double k_noise = 1e-4;  // share of the largest damping of its kind: the digits of a BEM result
  const Vec6 scale = mode_scale(database, database.damping);
  std::vector<NegativeDamping> found;
  for (std::size_t k = 0; k < database.frequency.size(); ++k)
    for (int i = 0; i < k_checked_modes; ++i) {
      const double value = database.damping[k](i, i);
      if (value < -k_noise * scale[i]) found.push_back({i, database.frequency[k], value, value / scale[i]});
    }
  return found;
}

/// The damping that follows from the excitation, and the same from every other heading.
struct HaskindDamping {
  Mat6 all = Mat6::Zero(), half = Mat6::Zero();
};

HaskindDamping haskind_damping(const Database& database, std::size_t k, const std::vector<CircleHeading>& circle) {
  HaskindDamping result;
  const bool turned = circle[1].turned != 0;
  for (std::size_t h = 0; h < circle.size(); ++h) {
    const ComplexVec6 load = excitation_of(database, k, circle[h]);
    const Mat6 part = circle[h].weight * (load * load.adjoint()).real();
    result.all += part;
    if (h % 2 == 0 || turned) result.half += (turned ? 1 : 2) * part;
  }
  const double w = database.frequency[k], g = database.gravity;
  constexpr double k_energy = 8;  // from the energy flux of a wave of unit amplitude, rho g c_g / 2
  const double unit = wave_number(w, g, database.depth) /
                      (k_energy * k_pi * database.density * g * group_velocity(w, g, database.depth));
  return {unit * result.all, unit * result.half};
}

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

void check_haskind(const Database& database, SelfCheck& check) {
  const std::vector<CircleHeading> circle = heading_circle(database);
  if (circle.empty()) {
    check.no_haskind = database.excitation.empty()
                           ? "the database has no wave excitation"
                           : "the headings do not cover a circle with gaps of 45 degrees at most";
    return;
  }
  constexpr double k_counted = 0.05;  // share of the mode's peak; below it, errors of the file prevail
  constexpr double k_coarse = 0.05;   // half of the headings change the integral by more: they are too few for the wave
  constexpr double k_some = 1e-4;     // share of the mode's scale below which its damping is noise
  const Vec6 peak = peaks(database.damping), scale = mode_scale(database, database.damping);
  std::array<std::vector<double>, k_checked_modes> ratios;
  std::array<HaskindRatio, k_checked_modes> results;
  for (std::size_t k = 0; k < database.frequency.size(); ++k) {
    const HaskindDamping from_loads = haskind_damping(database, k, circle);
    for (int i = 0; i < k_checked_modes; ++i) {
      const double b = database.damping[k](i, i);
      if (b < k_counted * peak[i] || peak[i] < k_some * scale[i]) continue;
      const double all = from_loads.all(i, i);
      if (std::abs(from_loads.half(i, i) - all) > k_coarse * all) continue;
      if (ratios[i].empty()) results[i].lowest = database.frequency[k];
      results[i].highest = database.frequency[k];
      ratios[i].push_back(all / b);
    }
  }
  for (int i = 0; i < k_checked_modes; ++i) {
    if (ratios[i].empty()) continue;
    HaskindRatio& result = results[i];
    result.mode = i;
    result.frequencies = static_cast<int>(ratios[i].size());
    result.median = median_of(ratios[i]);
    result.least = *std::min_element(ratios[i].begin(), ratios[i].end());
    result.largest = *std::max_element(ratios[i].begin(), ratios[i].end());
    check.haskind.push_back(result);
  }
}

std::optional<LongWave> long_wave(const Database& database) {
  if (database.excitation.empty()) return std::nullopt;
  LongWave wave;
  wave.frequency = database.frequency.front();
  const double k = wave_number(wave.frequency, database.gravity, database.depth);
  const Mat6& a = database.added_mass.front();
  const double mass = database.volume ? database.density * *database.volume : 0;
  wave.steepness = k * body_size(database);
  double load = 0, inertia = 0;
  std::complex<double> heave = 0;
  for (std::size_t h = 0; h < database.heading.size(); ++h) {
    const ComplexVec6& x = database.excitation.front()[h];
    const double c = std::cos(database.heading[h]), s = std::sin(database.heading[h]);
    load += x[0].imag() * c + x[1].imag() * s;
    inertia += database.gravity * k * (mass + a(0, 0) * c * c + a(1, 1) * s * s);
    heave += x[2];
  }
  wave.horizontal_sign = load;
  if (mass > 0) wave.horizontal = load / inertia;
  if (database.restoring && (*database.restoring)(2, 2) > 0)
    wave.heave = heave.real() / (static_cast<double>(database.heading.size()) * (*database.restoring)(2, 2));
  return wave;
}

void check_closure(const Database& database, const std::optional<Mat6>& mass, SelfCheck& check) {
  if (database.motion.empty()) check.no_closure = "the file has no motions";
  if (!database.motion.empty() && !mass) check.no_closure = "the mass of the body is not given";
  if (!database.restoring) check.no_closure = "the database has no hydrostatic stiffness";
  if (!check.no_closure.empty()) return;
  constexpr double k_counted = 0.2;  // share of the mode's largest motion
  const auto computed = responses(database, *mass);
  for (int i = 0; i < k_checked_modes; ++i) {
    Closure closure;
    closure.mode = i;
    double largest = 0;
    for (const auto& of_frequency : database.motion)
      for (const ComplexVec6& motion : of_frequency) largest = std::max(largest, std::abs(motion[i]));
    for (std::size_t k = 0; k < computed.size(); ++k)
      for (std::size_t h = 0; h < computed[k].size(); ++h) {
        const double motion = std::abs(database.motion[k][h][i]);
        const double off = std::abs(computed[k][h][i] - database.motion[k][h][i]);
        if (off > closure.worst) {
          closure.worst = off;
          closure.worst_frequency = database.frequency[k];
        }
        if (motion > k_counted * largest) closure.share = std::max(closure.share, off / motion);
      }
    check.closure.push_back(closure);
  }
}

}  // namespace

SelfCheck check_database(const Database& database, const std::optional<Mat6>& mass) {
  SelfCheck check;
  check.asymmetry = asymmetry_of(database);
  check.negative = negative_damping(database);
  check.reversed = reversed_modes(database);
  check_haskind(database, check);
  check.long_wave = long_wave(database);
  check_closure(database, mass ? mass : database.mass, check);
  return check;
}

}  // namespace nilas::hydro
