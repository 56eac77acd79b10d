#include "hydro/waves/wave_field.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wave_field_test {

using namespace nilas;
using namespace nilas::hydro;

constexpr double k_gravity = 9.81;

WaveTrain regular(double height, double period, double heading = 0, double depth = k_deep_water) {
  WaveTrain train;
  train.height = height;
  train.period = period;
  train.heading = heading;
  train.depth = depth;
  return train;
}

WaveField field_of(const WaveTrain& train, double level = 0, double start = 0) {
  return {{train}, k_gravity, level, start, 1};
}

/// Re(a exp(i (w t - k x) + phase)): the crest of a wave towards +x passes x at t = k x / w.
TEST(WaveField, ACrestTravelsTowardsTheHeading) {
  for (const double heading : {0.0, 0.7, k_pi}) {
    const WaveField field = field_of(regular(0.2, 5, heading));
    const WaveComponent& wave = field.components().front();
    const double t = 1.3;
    const Vec2 crest = wave.frequency * t / wave.number * wave_direction(heading);
    EXPECT_NEAR(field.elevation(crest, t), 0.1, 1e-15);
    EXPECT_NEAR(field.elevation(Vec2::Zero(), t), 0.1 * std::cos(wave.frequency * t), 1e-15);
  }
}

/// With small waves the profiles are those of linear theory. Velocity and acceleration belong together, div v = 0 and
/// dv/dt = -grad p / rho: all by central differences of 1e-4, whose error is below 1e-7 of the amplitude of the motion,
/// beside terms of second order in the wave's height of 1e-6 m.
TEST(WaveField, ObeysTheLinearEquations) {
  constexpr double k_height = 2e-6, k_step = 1e-4;
  for (const double depth : {0.4, 3.0, k_deep_water}) {
    const WaveField field = field_of(regular(k_height, 3, 0.6, depth), 0.5);
    const Vec3 p(0.3, -0.2, 0.5 - 0.25);
    const double t = 0.4, scale = 0.5 * k_height, tolerance = scale * 2e-5;
    const auto head = [&](const Vec3& at) { return WaveColumn(field, at.head<2>(), t).pressure_head(at.z() - 0.5); };
    const WaveColumn column(field, p.head<2>(), t);
    const Vec3 acceleration = column.acceleration(p.z() - 0.5);
    double divergence = 0;
    for (int i = 0; i < 3; ++i) {
      const Vec3 e = k_step * Vec3::Unit(i);
      divergence += (field.velocity(p + e, t)[i] - field.velocity(p - e, t)[i]) / (2 * k_step);
      EXPECT_NEAR(acceleration[i], -k_gravity * (head(p + e) - head(p - e)) / (2 * k_step), tolerance * k_gravity);
    }
    EXPECT_NEAR(divergence, 0, tolerance);
    const Vec3 rate = (field.velocity(p, t + k_step) - field.velocity(p, t - k_step)) / (2 * k_step);
    EXPECT_LT((rate - acceleration).norm(), tolerance);
  }
}

/// At the surface the water moves up with it, and the whole pressure is zero, at any height of the wave.
TEST(WaveField, KeepsTheConditionsAtTheSurface) {
  for (const double depth : {2.0, k_deep_water}) {
    const WaveField field = field_of(regular(0.4, 3, 0.2, depth), 0.1);
    const Vec2 x(1, 2);
    constexpr double k_step = 1e-5;
    for (double t = 0; t < 3; t += 0.37) {
      const WaveColumn column(field, x, t);
      const double rise = (field.elevation(x, t + k_step) - field.elevation(x, t - k_step)) / (2 * k_step);
      EXPECT_NEAR(column.velocity(column.elevation()).z(), rise, 1e-9);
      EXPECT_NEAR(column.pressure_head(column.elevation()), column.elevation(), 1e-15);
      EXPECT_EQ(column.velocity(column.elevation() + 1), column.velocity(column.elevation()));
    }
  }
}

/// At the bottom nothing moves up.
TEST(WaveField, NothingPassesTheBottom) {
  const WaveField field = field_of(regular(0.4, 3, 0.2, 2.0));
  for (double t = 0; t < 3; t += 0.37) EXPECT_NEAR(WaveColumn(field, {1, 2}, t).velocity(-2).z(), 0, 1e-15);
}

/// The tilt of the surface's acceleration is the gradient of a_z, by central differences.
TEST(WaveField, TiltsByTheGradientOfTheVerticalAcceleration) {
  const WaveField field = field_of(regular(2e-6, 4, 0.9));
  constexpr double k_step = 1e-4;
  const Vec2 x(0.3, 0.8);
  const auto up = [&](const Vec2& at) { return WaveColumn(field, at, 0.7).acceleration(0).z(); };
  const Vec3 tilt = WaveColumn(field, x, 0.7).tilt_acceleration(0);
  const Vec2 ex(k_step, 0), ey(0, k_step);
  EXPECT_NEAR(tilt.x(), (up(x + ey) - up(x - ey)) / (2 * k_step), 1e-11);
  EXPECT_NEAR(tilt.y(), -(up(x + ex) - up(x - ex)) / (2 * k_step), 1e-11);
}

/// The ramp begins at the start of the run, is half way at half its time, and is over after it.
TEST(WaveField, RisesInTheRamp) {
  WaveTrain train = regular(2, 5);
  train.ramp = 10;
  const WaveField field = field_of(train, 0, 100), full = field_of(regular(2, 5));
  EXPECT_EQ(field.ramp(0, 99), 0);
  EXPECT_EQ(field.elevation(Vec2::Zero(), 100), 0);
  EXPECT_NEAR(field.elevation(Vec2::Zero(), 105), 0.5 * full.elevation(Vec2::Zero(), 105), 1e-14);
  EXPECT_EQ(field.elevation(Vec2::Zero(), 110), full.elevation(Vec2::Zero(), 110));
  EXPECT_EQ(full.ramp(0, -5), 1);
}

/// 200 m behind the edge an energy rate of 0.01 per metre leaves exp(-1) of the amplitude; before it all.
TEST(WaveField, DecaysBehindTheIceEdge) {
  WaveTrain train = regular(2, 5);
  train.ice = {WaveAttenuation::exponential, 0.01, {50, 0}, {1, 0}};
  const WaveField field = field_of(train);
  const auto amplitude = [&](double x) {
    const WavePhasor at = WaveColumn(field, {x, 30}, 1).phasors().front();
    return std::hypot(at.cos, at.sin);
  };
  EXPECT_NEAR(amplitude(20), 1, 1e-15);
  EXPECT_NEAR(amplitude(250), std::exp(-1), 1e-15);
}

/// The variance of the elevation over 1000 places and times is m0 = 1/4 within four standard errors of about 2 %.
TEST(WaveField, HasTheVarianceOfItsSpectrum) {
  WaveTrain train = regular(2, 8);
  train.kind = WaveKind::jonswap;
  train.shortest_period = 2;
  train.components = 100;
  const WaveField field = field_of(train);
  constexpr int k_count = 4000;
  double sum = 0;
  for (int i = 0; i < k_count; ++i) sum += std::pow(field.elevation({0, 0}, 13.7 * i), 2);
  EXPECT_NEAR(sum / k_count, 0.25, 0.02);
  EXPECT_NEAR(field.shortest_length(), 2 * k_pi / field.components().back().number, 1e-12);
}

}  // namespace wave_field_test
