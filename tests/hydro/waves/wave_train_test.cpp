#include "hydro/waves/wave_train.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace wave_train_test {

using namespace nilas;
using namespace nilas::hydro;

constexpr double k_gravity = 9.81;

WaveTrain sea(WaveKind kind, int components) {
  WaveTrain train;
  train.kind = kind;
  train.height = 2;
  train.period = 8;
  train.shortest_period = 2;
  train.components = components;
  return train;
}

/// The moments int w^n S dw by the midpoint rule over the whole band.
double moment(const WaveTrain& train, int n) {
  constexpr int k_steps = 4000;
  const double high = 2 * k_pi / train.shortest_period, step = high / k_steps;
  const WaveSpectrum spectrum(train);
  double sum = 0;
  for (int i = 0; i < k_steps; ++i) {
    const double w = (i + 0.5) * step;
    sum += step * std::pow(w, n) * spectrum.density(w);
  }
  return sum;
}

double moment(const std::vector<WaveComponent>& waves, int n) {
  double sum = 0;
  for (const WaveComponent& wave : waves) sum += 0.5 * wave.amplitude * wave.amplitude * std::pow(wave.frequency, n);
  return sum;
}

TEST(WaveTrain, ARegularWaveIsOneComponent) {
  WaveTrain train;
  train.height = 3;
  train.period = 5;
  train.phase = 0.3;
  train.heading = 1;
  const auto waves = waves_of(train, k_gravity, 1, "waves");
  ASSERT_EQ(waves.size(), 1u);
  EXPECT_EQ(waves[0].amplitude, 1.5);
  EXPECT_EQ(waves[0].frequency, 2 * k_pi / 5);
  EXPECT_EQ(waves[0].phase, 0.3);
  EXPECT_EQ(waves[0].direction, Vec2(std::cos(1.0), std::sin(1.0)));
}

TEST(WaveTrain, WithoutHeightThereIsNoWave) {
  WaveTrain train;
  EXPECT_TRUE(waves_of(train, k_gravity, 1, "waves").empty());
}

/// Hs = 4 sqrt(m0) by definition: the spectrum's integral is 2^2 / 16. The components have the same sum exactly.
TEST(WaveTrain, ReproducesTheSignificantHeight) {
  for (const WaveKind kind : {WaveKind::jonswap, WaveKind::pierson_moskowitz}) {
    const WaveTrain train = sea(kind, 60);
    EXPECT_NEAR(4 * std::sqrt(moment(train, 0)), 2, 2e-5);
    EXPECT_NEAR(4 * std::sqrt(moment(waves_of(train, k_gravity, 3, "waves"), 0)), 2, 1e-12);
  }
}

/// With 500 bins, each frequency is within a bin. The higher moments agree within 0.5 %.
TEST(WaveTrain, ReproducesHigherMoments) {
  for (const WaveKind kind : {WaveKind::jonswap, WaveKind::pierson_moskowitz}) {
    const WaveTrain train = sea(kind, 500);
    const auto waves = waves_of(train, k_gravity, 3, "waves");
    for (const int n : {-1, 1, 2}) EXPECT_NEAR(moment(waves, n) / moment(train, n), 1, 5e-3) << n;
  }
}

/// Without the cut, Pierson-Moskowitz is 5/16 H^2 w_p^4 w^-5 exp(-5/4 (w_p/w)^4). The band up to 4 w_p holds
/// exp(-1.25 / 256) of it, by which the rest is raised. The peak is at w_p.
TEST(WaveTrain, PiersonMoskowitzIsTheClosedForm) {
  const WaveTrain train = sea(WaveKind::pierson_moskowitz, 1);
  const double peak = 2 * k_pi / 8;
  for (const double x : {0.6, 0.9, 1.0, 1.5, 3.0}) {
    const double closed = 5.0 / 16 * 4 * std::pow(peak, -1) * std::pow(x, -5) * std::exp(-1.25 * std::pow(x, -4));
    EXPECT_NEAR(WaveSpectrum(train).density(x * peak) * std::exp(-1.25 / 256) / closed, 1, 1e-6) << x;
  }
  EXPECT_EQ(WaveSpectrum(train).density(4.01 * peak), 0);
}

/// The factor of JONSWAP against Pierson-Moskowitz is 1 - 0.287 ln(gamma) within 1.5 % for gamma up to 5 [DNV-RP-C205].
TEST(WaveTrain, JonswapKeepsItsHeightForAnyGamma) {
  const double peak = 2 * k_pi / 8;
  WaveTrain train = sea(WaveKind::jonswap, 1);
  const double flat = WaveSpectrum(sea(WaveKind::pierson_moskowitz, 1)).density(peak);
  for (const double gamma : {1.0, 2.0, 3.3, 5.0}) {
    train.gamma = gamma;
    EXPECT_NEAR(WaveSpectrum(train).density(peak) / (flat * gamma * (1 - 0.287 * std::log(gamma))), 1, 0.015) << gamma;
    EXPECT_NEAR(moment(train, 0), 0.25, 1e-5);
  }
}

/// cos^2s(b/2) has the circular moment E[cos b] = s / (s + 1). 4000 directions give it within 4 standard errors, 0.03.
TEST(WaveTrain, SpreadsDirections) {
  WaveTrain train = sea(WaveKind::jonswap, 4000);
  train.heading = 0.4;
  for (const double s : {1.0, 4.0, 25.0}) {
    train.spreading = s;
    double cosine = 0, sine = 0;
    for (const WaveComponent& wave : waves_of(train, k_gravity, 5, "waves")) {
      cosine += std::cos(wave.heading - 0.4) / 4000;
      sine += std::sin(wave.heading - 0.4) / 4000;
    }
    EXPECT_NEAR(cosine, s / (s + 1), 0.03);
    EXPECT_NEAR(sine, 0, 0.05);
  }
}

TEST(WaveTrain, DependsOnSeedAndStreamOnly) {
  const WaveTrain train = sea(WaveKind::jonswap, 10);
  const auto one = waves_of(train, k_gravity, 5, "a"), same = waves_of(train, k_gravity, 5, "a");
  const auto other_seed = waves_of(train, k_gravity, 6, "a"), other_stream = waves_of(train, k_gravity, 5, "b");
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].frequency, same[i].frequency);
    EXPECT_EQ(one[i].phase, same[i].phase);
    EXPECT_NE(one[i].phase, other_seed[i].phase);
    EXPECT_NE(one[i].phase, other_stream[i].phase);
    const double before = i > 0 ? one[i - 1].frequency : 0;
    EXPECT_GT(one[i].frequency, before);
  }
}

TEST(WaveTrain, DirectionsAlongAxesAreExact) {
  EXPECT_EQ(wave_direction(k_pi), Vec2(-1, 0));
  EXPECT_EQ(wave_direction(-0.5 * k_pi), Vec2(0, -1));
  EXPECT_EQ(wave_direction(2.5 * k_pi), Vec2(0, 1));
  EXPECT_EQ(wave_direction(0.3), direction_of(0.3));
}

/// Meylan et al. (2014) at T = 10 s: 2.12e-3 / 100 + 4.59e-2 / 10^4 = 2.579e-5 per metre.
TEST(WaveTrain, RatesUnderIceAreThoseOfTheModels) {
  IceCover ice;
  EXPECT_EQ(ice.energy_rate(10), 0);
  ice.model = WaveAttenuation::exponential;
  ice.rate = 3e-4;
  EXPECT_EQ(ice.energy_rate(10), 3e-4);
  ice.model = WaveAttenuation::meylan;
  EXPECT_NEAR(ice.energy_rate(10), 2.579e-5, 1e-12);
  // Of the same sea at 16 times its lengths, as many wave lengths pass until it is as weak.
  const double whole = ice.energy_rate(10);
  ice.scale = 16;
  EXPECT_EQ(ice.energy_rate(40), whole / 16);
}

/// Froude's law: over like distances waves of like periods lose the same share, at 1:40 and 16:1 of the measured
/// waters.
TEST(WaveTrain, RatesUnderIceFollowTheScale) {
  IceCover measured;
  measured.model = WaveAttenuation::meylan;
  for (const double scale : {1.0 / 40, 1.0 / 16, 16.0}) {
    IceCover scaled = measured;
    scaled.scale = scale;
    for (const double period : {0.5, 3.0, 10.0})
      EXPECT_NEAR(scale * scaled.energy_rate(std::sqrt(scale) * period) / measured.energy_rate(period), 1, 1e-14);
  }
}

TEST(WaveTrain, RefusesASpectrumWithoutItsPeak) {
  WaveTrain train = sea(WaveKind::jonswap, 10);
  train.shortest_period = 8;
  EXPECT_THROW(waves_of(train, k_gravity, 1, "waves"), InputError);
  train = sea(WaveKind::jonswap, 0);
  EXPECT_THROW(waves_of(train, k_gravity, 1, "waves"), InputError);
  train = sea(WaveKind::jonswap, 1);
  EXPECT_THROW(waves_of(train, 0, 1, "waves"), InputError);
  train.depth = 0;
  EXPECT_THROW(waves_of(train, k_gravity, 1, "waves"), InputError);
}

}  // namespace wave_train_test
