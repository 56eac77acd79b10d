#include "hydro/waves/wave_train.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/random.h"
#include "hydro/database/wave_number.h"

namespace nilas::hydro {

namespace {

/// The shape of the spectrum over x = w / w_p, without a factor.
double spectrum_shape(const WaveTrain& train, double x) {
  constexpr double k_tail = 5, k_fall = 1.25;                   // S ~ x^-5 exp(-1.25 x^-4)
  constexpr double k_width_below = 0.07, k_width_above = 0.09;  // of the peak [share of w_p]
  const double square = x * x;
  const double base = std::pow(x, -k_tail) * std::exp(-k_fall / (square * square));
  if (train.kind != WaveKind::jonswap) return base;
  const double distance = (x - 1) / (x <= 1 ? k_width_below : k_width_above);
  return base * std::pow(train.gamma, std::exp(-0.5 * distance * distance));
}

TabulatedDensity shape_table(const WaveTrain& train) {
  // Below this share of the peak's frequency lies less than 1e-13 of the energy.
  constexpr double k_lowest = 0.45;
  NILAS_DEMAND(train.shortest_period > 0);
  const double highest = train.period / train.shortest_period;
  if (!(highest > 1)) throw InputError("the shortest period of waves must be below the period of the peak");
  return {k_lowest, highest, [&](double x) { return spectrum_shape(train, x); }};
}

WaveComponent component_of(const WaveTrain& train, double gravity, double frequency) {
  WaveComponent wave;
  wave.frequency = frequency;
  wave.number =
      wave_number(frequency, gravity, train.depth == k_deep_water ? std::nullopt : std::optional(train.depth));
  wave.decay = 0.5 * train.ice.energy_rate(2 * k_pi / frequency);
  return wave;
}

}  // namespace

double IceCover::energy_rate(double period) const {
  constexpr double k_a = 2.12e-3, k_b = 4.59e-2;  // Meylan, Bennetts and Kohout 2014 [s^2/m, s^4/m]
  switch (model) {
    case WaveAttenuation::none:
      return 0;
    case WaveAttenuation::exponential:
      return rate;
    case WaveAttenuation::meylan: {
      const double square = 1 / (period * period);
      return k_a * square + scale * k_b * square * square;
    }
  }
  return 0;
}

Vec2 wave_direction(double heading) {
  constexpr double k_right_angle = 0.5 * k_pi;
  constexpr int k_quarters = 4;
  constexpr double k_rounding = 1e-12;  // of degrees in radians
  const double quarter = std::round(heading / k_right_angle);
  if (std::abs(heading - quarter * k_right_angle) > k_rounding) return direction_of(heading);
  const int turn = ((static_cast<int>(quarter) % k_quarters) + k_quarters) % k_quarters;
  const double sign = turn < 2 ? 1 : -1;
  return turn % 2 == 0 ? Vec2(sign, 0) : Vec2(0, sign);
}

TabulatedDensity::TabulatedDensity(double low, double high, const std::function<double(double)>& density) : low_(low) {
  constexpr int k_intervals = 4000;                      // the peak of JONSWAP has more than a hundred of them
  constexpr double k_simpson = 1.0 / 6.0, k_middle = 4;  // weights 1 4 1
  step_ = (high - low) / k_intervals;
  sum_.push_back(0);
  double left = density(low);
  for (int i = 0; i < k_intervals; ++i) {
    const double right = density(low + (i + 1) * step_), middle = density(low + (i + 0.5) * step_);
    sum_.push_back(sum_.back() + step_ * k_simpson * (left + k_middle * middle + right));
    left = right;
  }
}

double TabulatedDensity::quantile(double share) const {
  const double wanted = share * total();
  const auto above = std::upper_bound(sum_.begin() + 1, sum_.end() - 1, wanted);
  const double before = *(above - 1), within = *above - before;
  const double part = within > 0 ? std::clamp((wanted - before) / within, 0.0, 1.0) : 0.5;
  return low_ + step_ * (static_cast<double>(above - sum_.begin() - 1) + part);
}

WaveSpectrum::WaveSpectrum(const WaveTrain& train)
    : train_(train), peak_(2 * k_pi / train.period), shape_(shape_table(train)) {}

double WaveSpectrum::density(double frequency) const {
  constexpr double k_share = 16;  // m0 = height^2 / 16 by the definition of the significant height
  const double x = frequency / peak_;
  if (!(x > 0) || x > train_.period / train_.shortest_period) return 0;
  return train_.height * train_.height / k_share * spectrum_shape(train_, x) / (shape_.total() * peak_);
}

double WaveSpectrum::quantile(double share) const { return peak_ * shape_.quantile(share); }

std::vector<WaveComponent> waves_of(const WaveTrain& train, double gravity, std::uint64_t seed,
                                    const std::string& stream) {
  if (!(train.height >= 0 && train.period > 0 && train.depth > 0 && train.components > 0))
    throw InputError("waves need a height of 0 or more, a period and a depth above 0 and at least one component");
  if (train.height == 0) return {};
  if (!(gravity > 0)) throw InputError("waves need gravity");
  if (train.kind == WaveKind::regular) {
    WaveComponent wave = component_of(train, gravity, 2 * k_pi / train.period);
    wave.amplitude = 0.5 * train.height;
    wave.phase = train.phase;
    wave.heading = train.heading;
    wave.direction = wave_direction(train.heading);
    return {wave};
  }
  constexpr double k_share = 0.25;  // sqrt(m0) = height / 4
  const double amplitude = k_share * train.height * std::sqrt(2.0 / train.components);
  const WaveSpectrum spectrum(train);
  RandomStream places(seed, stream + " frequencies"), phases(seed, stream + " phases");
  RandomStream directions(seed, stream + " directions");
  std::optional<TabulatedDensity> spread;
  if (train.spreading)
    spread.emplace(-k_pi, k_pi, [&](double b) { return std::pow(std::cos(0.5 * b), 2 * *train.spreading); });
  std::vector<WaveComponent> waves;
  for (int i = 0; i < train.components; ++i) {
    WaveComponent wave = component_of(train, gravity, spectrum.quantile((i + places.uniform()) / train.components));
    wave.amplitude = amplitude;
    wave.phase = phases.uniform(0, 2 * k_pi);
    wave.heading = train.heading + (spread ? spread->quantile(directions.uniform()) : 0.0);
    wave.direction = wave_direction(wave.heading);
    waves.push_back(wave);
  }
  return waves;
}

}  // namespace nilas::hydro
