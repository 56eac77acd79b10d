#include "fracture/crush/crushing_pressure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace nilas::fracture {

TEST(CrushingPressure, PowerOfTheArea) {
  const PressureArea law{3e6, -0.5};
  EXPECT_NEAR(crushing_pressure(law, 1), 3e6, 1e-6);
  EXPECT_NEAR(crushing_pressure(law, 4), 1.5e6, 1e-6);
  EXPECT_NEAR(crushing_force(law, 4), 4 * crushing_pressure(law, 4), 1e-6);
  EXPECT_EQ(crushing_force(law, 0), 0);
  EXPECT_NEAR(crushing_force({2e6, 0}, 0.3), 0.6e6, 1e-6);
}

TEST(CrushingPressure, IsoLocal) {
  EXPECT_NEAR(iso_local_pressure(1), 7.40e6, 1);
  EXPECT_NEAR(iso_local_pressure(2) / iso_local_pressure(1), std::pow(2, -0.7), 1e-12);
  EXPECT_EQ(iso_local_pressure(20), 1.48e6);
  EXPECT_NEAR(iso_local_pressure(10) / 1.48e6, 1, 0.003);
}

/// Computed by hand: h 0.5 m has n = -0.4, so 2.8 MPa 0.5^-0.4 20^-0.16 on 10 m; from 1 m on n = -0.3.
TEST(CrushingPressure, IsoGlobal) {
  EXPECT_NEAR(iso_global_pressure(k_iso_arctic, 0.5, 10), 2.8e6 * 1.31950791 * 0.61920606, 1);
  EXPECT_NEAR(iso_global_pressure(k_iso_baltic, 1, 1), 1.8e6, 1e-6);
  EXPECT_NEAR(iso_global_pressure(k_iso_arctic, 2, 20) / iso_global_pressure(k_iso_arctic, 2, 40), std::pow(2, 0.16),
              1e-12);
  EXPECT_NEAR(iso_global_pressure(k_iso_arctic, 3, 30) / iso_global_pressure(k_iso_arctic, 1.5, 15), std::pow(2, -0.3),
              1e-12);
  EXPECT_NEAR(iso_global_pressure(1, 1 + 1e-9, 10) / iso_global_pressure(1, 1 - 1e-9, 10), 1, 1e-8);
}

/// The work of the force up to the depth, summed by the midpoint rule (1000 steps; error of order 1e-6 of it), is the
/// kinetic energy.
TEST(CrushingPressure, ImpactSpendsItsEnergy) {
  for (const double exponent : {0.0, -0.1, -0.5}) {
    const CrushingImpact impact{2e6, 1.5, 3, 1.2e6, exponent};
    const CrushingStop stop = stop_by_crushing(impact);
    const auto force = [&](double depth) {
      return crushing_force({impact.pressure, exponent}, impact.area_growth * depth * depth);
    };
    double work = 0;
    for (int k = 0; k < 1000; ++k) work += force(stop.depth * (k + 0.5) / 1000) * stop.depth / 1000;
    EXPECT_NEAR(work / (0.5 * impact.mass * impact.speed * impact.speed), 1, 1e-5);
    EXPECT_NEAR(stop.force, force(stop.depth), 1e-9 * stop.force);
  }
}

/// depth ~ (M v^2 / (P0 g^(1 + ex)))^(1 / (3 + 2 ex)).
TEST(CrushingPressure, PowersOfTheImpact) {
  const CrushingImpact impact{2e6, 1.5, 3, 1.2e6, -0.1};
  const double depth = stop_by_crushing(impact).depth, order = 2.8;
  const auto ratio = [&](double CrushingImpact::*field) {
    CrushingImpact changed = impact;
    changed.*field *= 2;
    return stop_by_crushing(changed).depth / depth;
  };
  EXPECT_NEAR(ratio(&CrushingImpact::mass), std::pow(2, 1 / order), 1e-12);
  EXPECT_NEAR(ratio(&CrushingImpact::speed), std::pow(2, 2 / order), 1e-12);
  EXPECT_NEAR(ratio(&CrushingImpact::pressure), std::pow(2, -1 / order), 1e-12);
  EXPECT_NEAR(ratio(&CrushingImpact::area_growth), std::pow(2, -0.9 / order), 1e-12);
  EXPECT_EQ(stop_by_crushing({2e6, 0, 3, 1.2e6, -0.1}).force, 0);
}

TEST(CrushingPressure, RefusesImpossibleInput) {
  EXPECT_THROW(crushing_pressure({1e6, -1}, 1), ContractError);
  EXPECT_THROW(crushing_pressure({1e6, 0.1}, 1), ContractError);
  EXPECT_THROW(crushing_force({0, 0}, 1), ContractError);
  EXPECT_THROW(iso_local_pressure(0), ContractError);
  EXPECT_THROW(iso_global_pressure(2.8e6, 0, 10), ContractError);
  EXPECT_THROW(stop_by_crushing({0, 1, 1, 1e6, 0}), ContractError);
}

}  // namespace nilas::fracture
