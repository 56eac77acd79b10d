#include "hydro/wind/wind_speed.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nilas::hydro {

namespace wind_speed_test {

/// The variance of the gusts is the integral of the spectrum from 1/600 to 0.5 Hz, here by the midpoint rule over f.
TEST(Gusts, VarianceIsTheIntegralOfTheSpectrum) {
  for (const double U : {5.0, 10.0, 25.0}) {
    constexpr int k_steps = 100000;
    const double low = 1.0 / 600, h = (0.5 - low) / k_steps;
    double expected = 0;
    for (int k = 0; k < k_steps; ++k) expected += h * npd_spectrum(low + (k + 0.5) * h, U);
    EXPECT_NEAR(Gusts(U, 3).variance(), expected, 1e-6 * expected) << U;
  }
}

/// The spectrum at U0 = 10 m/s and f = 1/172 Hz: F = 1, so 320 / 2^(5 / 1.404).
TEST(Gusts, SpectrumIsThatOfIso) {
  EXPECT_NEAR(npd_spectrum(1.0 / 172, 10), 320 / std::pow(2, 5 / (3 * 0.468)), 1e-12 * 320);
  EXPECT_EQ(npd_spectrum(0.1, 0), 0);
}

/// The mean square of the series over 1e5 s. The slowest band repeats 167 times in it, so that a cosine's mean square
/// differs from the half by 1/(4 pi 167) of it at most, and products of neighbours by chance: 3 % for all.
TEST(Gusts, MeanSquareOfTheSeriesIsTheVariance) {
  const Gusts gusts(15, 7);
  double sum = 0, square = 0;
  constexpr int k_steps = 40000;
  for (int k = 0; k < k_steps; ++k) {
    const double u = gusts.at(2.5137 * k);
    sum += u;
    square += u * u;
  }
  EXPECT_NEAR(sum / k_steps, 0, 0.02 * std::sqrt(gusts.variance()));
  EXPECT_NEAR(square / k_steps, gusts.variance(), 0.03 * gusts.variance());
}

TEST(Gusts, SeedDecidesTheSeries) {
  EXPECT_EQ(Gusts(12, 1).at(3.5), Gusts(12, 1).at(3.5));
  EXPECT_NE(Gusts(12, 1).at(3.5), Gusts(12, 2).at(3.5));
  EXPECT_EQ(Gusts().at(3.5), 0);
  EXPECT_EQ(Gusts().variance(), 0);
}

TEST(Wind, MeanOverHeight) {
  WindSettings settings;
  settings.speed = 20;
  settings.direction = 30 * k_deg;
  const auto mean = [&](WindProfileKind profile, double z) {
    settings.profile = profile;
    return Wind(settings, 1).mean_speed(z);
  };
  EXPECT_EQ(mean(WindProfileKind::uniform, 3), 20);
  for (const WindProfileKind profile : all_choices<WindProfileKind>()) EXPECT_EQ(mean(profile, 10), 20);
  EXPECT_NEAR(mean(WindProfileKind::power, 40), 20 * std::pow(4, 0.12), 1e-12);
  // C = 0.0573 sqrt(1 + 0.15 * 20) = 0.1146
  EXPECT_NEAR(mean(WindProfileKind::log, 40), 20 * (1 + 0.1146 * std::log(4)), 1e-12);
  EXPECT_EQ(mean(WindProfileKind::log, 0), 0);
  EXPECT_EQ(mean(WindProfileKind::power, -1), 0);
  EXPECT_EQ(mean(WindProfileKind::log, 1e-9), 0);
}

/// Froude's law: heights by 16, times and speeds by 4, to the bit.
TEST(Wind, ScalesByFroude) {
  WindSettings model;
  model.speed = 3;
  model.gusts = GustSpectrum::npd;
  for (const WindProfileKind profile : all_choices<WindProfileKind>()) {
    model.profile = profile;
    WindSettings full = model;
    full.scale = 16;
    full.speed = 4 * model.speed;
    const Wind small(model, 1), large(full, 1);
    for (const double t : {0.0, 3.7, 100.0}) {
      EXPECT_EQ(large.velocity(16 * 0.3, 4 * t), Vec3(4 * small.velocity(0.3, t)));
      EXPECT_EQ(large.reference_velocity(4 * t), Vec3(4 * small.reference_velocity(t)));
    }
  }
}

TEST(Wind, BlowsTowardsItsDirection) {
  WindSettings settings;
  settings.speed = 20;
  settings.direction = 30 * k_deg;
  EXPECT_LT((Wind(settings, 1).velocity(10, 5) - Vec3(20 * std::sqrt(0.75), 10, 0)).norm(), 1e-12);
  settings.gusts = GustSpectrum::npd;
  const Vec3 gusty = Wind(settings, 1).velocity(10, 5);
  EXPECT_LT(gusty.cross(Vec3(std::sqrt(0.75), 0.5, 0)).norm(), 1e-12);
  EXPECT_NEAR(gusty.norm(), 20 + Gusts(20, 1).at(5), 1e-12);
}

}  // namespace wind_speed_test

}  // namespace nilas::hydro
