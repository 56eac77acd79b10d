#include "hydro/wind/wind_speed.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/random.h"

namespace nilas::hydro {

namespace {

constexpr double k_speed_unit = 10;                                // ISO 19901-1 states speeds as shares of it [m/s]
constexpr double k_lowest_gust = 1.0 / 600, k_highest_gust = 0.5;  // the range of its spectrum [Hz]
constexpr int k_gust_waves = 200;  // Bands 2.9 % wide. A run of an hour holds six of the longest periods.

/// The integral of the spectrum over a band, by Simpson's rule over the logarithm of the frequency.
double energy(double low, double high, double speed) {
  constexpr double k_simpson = 6, k_middle = 4;
  const double middle = std::sqrt(low * high);
  const auto integrand = [&](double f) { return f * npd_spectrum(f, speed); };
  return std::log(high / low) / k_simpson * (integrand(low) + k_middle * integrand(middle) + integrand(high));
}

}  // namespace

double npd_spectrum(double frequency, double speed) {
  constexpr double k_scale = 320, k_frequency = 172, k_power = 0.75, k_n = 0.468;
  constexpr double k_decay = 5 / (3 * k_n);
  if (!(speed > 0)) return 0;
  const double relative = speed / k_speed_unit, F = k_frequency * frequency * std::pow(relative, -k_power);
  return k_scale * relative * relative / std::pow(1 + std::pow(F, k_n), k_decay);
}

Gusts::Gusts(double speed, std::uint64_t seed) {
  RandomStream random(seed, "wind gusts");
  const double ratio = std::pow(k_highest_gust / k_lowest_gust, 1.0 / k_gust_waves);
  double low = k_lowest_gust;
  for (int k = 0; k < k_gust_waves; ++k) {
    const double frequency = low * std::pow(ratio, random.uniform());
    waves_.push_back(
        {std::sqrt(2 * energy(low, low * ratio, speed)), 2 * k_pi * frequency, random.uniform(0, 2 * k_pi)});
    low *= ratio;
  }
}

double Gusts::at(double t) const {
  double sum = 0;
  for (const Wave& wave : waves_) sum += wave.amplitude * std::cos(wave.frequency * t + wave.phase);
  return sum;
}

double Gusts::variance() const {
  double sum = 0;
  for (const Wave& wave : waves_) sum += 0.5 * wave.amplitude * wave.amplitude;
  return sum;
}

Wind::Wind(const WindSettings& settings, std::uint64_t seed)
    : settings_(settings),
      root_(std::sqrt(settings.scale)),
      along_(std::cos(settings.direction), std::sin(settings.direction), 0) {
  NILAS_DEMAND(settings.speed >= 0 && settings.density > 0 && settings.scale > 0);
  switch (settings.gusts) {
    case GustSpectrum::none:
      break;
    case GustSpectrum::npd:
      gusts_ = Gusts(settings.speed / root_, seed);
      break;
  }
}

double Wind::mean_speed(double height) const {
  constexpr double k_log = 0.0573, k_log_speed = 0.15;  // ISO 19901-1 [1, s/m]
  const double U = settings_.speed, z = height / (k_wind_height * settings_.scale);
  switch (settings_.profile) {
    case WindProfileKind::uniform:
      return U;
    case WindProfileKind::power:
      return z > 0 ? U * std::pow(z, settings_.exponent) : 0;
    case WindProfileKind::log:
      return z > 0 ? std::max(0.0, U * (1 + k_log * std::sqrt(1 + k_log_speed * U / root_) * std::log(z))) : 0;
  }
  return U;
}

Vec3 Wind::velocity(double height, double t) const {
  return (mean_speed(height) + root_ * gusts_.at(t / root_)) * along_;
}

}  // namespace nilas::hydro
