#include "core/vessel/control/observer.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace observer_test {

using namespace nilas;
using vessel::ObserverSettings;
using vessel::PassiveObserver;

ObserverSettings settings() {
  return {
      .mass = Vec3(6.8e6, 1.13e7, 4.4e9), .damping = Vec3::Zero(), .bandwidth = Vec3(0.5, 0.5, 1), .wave_period = {}};
}

// (I - L C) F has its poles at exp(-w T): with a triple pole the eigenvalues carry the cube root of rounding.
TEST(Observer, PlacesItsPolesAtAnySampleTime) {
  const PassiveObserver observer(settings(), Vec3::Zero(), Vec3::Zero());
  for (const double period : {0.02, 0.5, 2.0})
    EXPECT_NEAR(observer.spectral_radius(period), std::exp(-0.5 * period), 1e-4) << period;
}

/// A vessel with constant loads in G that moves exactly, at a heading that turns.
struct Drifter {
  Vec3 position = Vec3(10, -5, 3.0), velocity = Vec3(0.4, -0.2, 0.01);

  void move(const Vec3& load, const Vec3& bias, const Vec3& mass, double h) {
    const Vec3 a = (load + vessel::plane_rotation(position.z()).transpose() * bias).cwiseQuotient(mass);
    const Vec3 mean = velocity + 0.5 * h * a;
    position += h * (vessel::plane_rotation(position.z() + 0.5 * h * mean.z()) * mean);
    velocity += h * a;
  }
};

// A bias of 100 kN and 50 kN, and 2 MN m, that the observer does not know at first. After 20 time constants the rest
// of a triple pole is below 1e-6.
TEST(Observer, FindsTheBiasAndTheVelocity) {
  PassiveObserver observer(settings(), Vec3::Zero(), Vec3::Zero());
  Drifter vessel;
  const Vec3 bias(1e5, -5e4, 2e6), load(3e4, 0, -1e6);
  for (int k = 0; k < 500; ++k) {
    vessel.move(load, bias, settings().mass, 0.1);
    observer.predict(load, 0.1);
    observer.correct(vessel.position, 0.1);
  }
  EXPECT_LT((observer.position() - vessel.position).norm(), 1e-5);
  EXPECT_LT((observer.velocity() - vessel.velocity).norm(), 1e-5);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(observer.bias()[k], bias[k], 1e-3 * bias.cwiseAbs()[k]);
}

TEST(Observer, ConvergesWithSamplesThatAreRare) {
  Drifter vessel;
  PassiveObserver observer(settings(), Vec3(0, 0, vessel.position.z()), Vec3::Zero());
  vessel.velocity.z() = 0;
  const Vec3 bias(1e5, -5e4, 0);
  for (int k = 1; k <= 1000; ++k) {
    vessel.move(Vec3::Zero(), bias, settings().mass, 0.1);
    observer.predict(Vec3::Zero(), 0.1);
    if (k % 20 == 0) observer.correct(vessel.position, 2);
  }
  EXPECT_LT((observer.velocity() - vessel.velocity).norm(), 1e-4 * vessel.velocity.norm());
  EXPECT_NEAR(observer.bias().x(), bias.x(), 10);
}

// The estimate scatters less than the measurements: with critical damping and w T << 1 the variance of the position is
// that of the noise times about 1.6 w T.
TEST(Observer, TakesTheNoiseOutOfThePosition) {
  PassiveObserver observer(settings(), Vec3::Zero(), Vec3::Zero());
  RandomStream stream(1, "noise");
  double sum = 0;
  constexpr int k_samples = 20000, k_settled = 1000;
  for (int k = 0; k < k_samples; ++k) {
    observer.predict(Vec3::Zero(), 0.1);
    observer.correct(Vec3(stream.normal(), 0, 0), 0.1);
    if (k >= k_settled) sum += observer.position().x() * observer.position().x();
  }
  const double variance = sum / (k_samples - k_settled);
  EXPECT_LT(variance, 0.16);
  EXPECT_GT(variance, 0.04);
}

// Waves of 8 s and 1 m pass the plain observer, and mostly not that with a filter.
TEST(Observer, LeavesWavesOutWithItsFilter) {
  ObserverSettings filtered = settings();
  filtered.bandwidth = Vec3(0.1, 0.1, 0.2);
  filtered.wave_period = 8;
  ObserverSettings plain = settings();
  PassiveObserver with(filtered, Vec3::Zero(), Vec3::Zero()), without(plain, Vec3::Zero(), Vec3::Zero());
  EXPECT_LT(with.spectral_radius(0.1), 1);
  double most_with = 0, most_without = 0;
  for (int k = 0; k < 4000; ++k) {
    const Vec3 wave(std::sin(2 * k_pi / 8 * 0.1 * k), 0, 0);
    for (PassiveObserver* observer : {&with, &without}) {
      observer->predict(Vec3::Zero(), 0.1);
      observer->correct(wave, 0.1);
    }
    if (k < 2000) continue;
    most_with = std::max(most_with, std::abs(with.position().x()));
    most_without = std::max(most_without, std::abs(without.position().x()));
  }
  EXPECT_GT(most_without, 0.8);
  EXPECT_LT(most_with, 0.15);
}

}  // namespace observer_test
