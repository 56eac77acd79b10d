/// Hulls by given derivatives: names of terms, systems of units, added mass, and a supply vessel at low speed.
#include "hydro/manoeuvring/derivatives_hull.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hydro/manoeuvring/ship_presets.h"
#include "tests/hydro/manoeuvring/ship_motion.h"

namespace nilas::derivatives_hull_test {

using hydro::DerivativesHull;
using hydro::PlanarLoads;

constexpr double k_sea = 1025;  // [kg/m^3]

DerivativesHull hull_with(DerivativeScaling scaling, const std::vector<std::pair<std::string, double>>& terms) {
  DerivativesHull hull;
  hull.scaling = scaling;
  hull.length = 50;
  hull.draught = 4;
  hull.mass = 2e6;
  hull.gravity = 9.81;
  for (const auto& [name, value] : terms) {
    hull.terms.push_back(hydro::derivative_term(name).value());
    hull.terms.back().value = value;
  }
  return hull;
}

TEST(DerivativesHull, ReadsTheNamesOfTerms) {
  const auto term = hydro::derivative_term("N_vvr");
  ASSERT_TRUE(term.has_value());
  EXPECT_EQ(term->load, hydro::DerivativeTerm::Load::N);
  EXPECT_EQ(term->powers, (std::array<int, 4>{0, 2, 1, 0}));
  EXPECT_EQ(hydro::derivative_term("X_u|u|")->absolute_powers, (std::array<int, 4>{1, 0, 0, 0}));
  EXPECT_EQ(hydro::derivative_term("X_0")->powers, (std::array<int, 4>{}));
  for (const char* name : {"Y_", "Z_v", "Y_w", "Y_v|r", "Y_||", "Yv", "Y_0v"})
    EXPECT_FALSE(hydro::derivative_term(name).has_value()) << name;
}

/// With a reference speed of 2 m/s and u = 5: X = -10 (3)|3| + 7, Y = 100 x 2 x 0.1^2 + 40 x 0.2.
TEST(DerivativesHull, SumsTermsWithDimension) {
  DerivativesHull hull =
      hull_with(DerivativeScaling::si, {{"X_u|u|", -10}, {"X_0", 7}, {"Y_vrr", 100}, {"Y_d", 40}, {"N_ur", -2}});
  hull.reference_speed = 2;
  const PlanarLoads loads = derivatives_loads(hull, k_sea, {5, 2, 0.1}, 0.2);
  EXPECT_NEAR(loads.X, -83, 1e-12);
  EXPECT_NEAR(loads.Y, 10, 1e-12);
  EXPECT_NEAR(loads.N, -0.6, 1e-12);
}

/// Each system gives back the load of the same term with dimension: Y = c v (bis: c m g/sqrt(g L); prime: c 0.5 rho L^2
/// U).
TEST(DerivativesHull, SystemsDifferByTheirUnitsOnly) {
  const hydro::PlanarMotion m{3, 4, 0.02};  // U = 5
  const auto sway = [&](DerivativeScaling scaling) {
    return derivatives_loads(hull_with(scaling, {{"Y_v", -0.1}, {"N_r", -0.1}}), k_sea, m, 0);
  };
  const double g = 9.81, L = 50, d = 4, mass = 2e6;
  EXPECT_NEAR(sway(DerivativeScaling::bis).Y / (-0.1 * 4 * mass * std::sqrt(g / L)), 1, 1e-12);
  EXPECT_NEAR(sway(DerivativeScaling::bis).N / (-0.1 * 0.02 * mass * L * L * std::sqrt(g / L)), 1, 1e-12);
  EXPECT_NEAR(sway(DerivativeScaling::prime).Y / (-0.1 * 4 * 0.5 * k_sea * L * L * 5), 1, 1e-12);
  EXPECT_NEAR(sway(DerivativeScaling::prime_draught).N / (-0.1 * 0.02 * 0.5 * k_sea * L * L * L * d * 5), 1, 1e-12);
}

/// The prime systems about a reference speed of 8 m/s. Down to half of it the load is the given series; below, that at
/// half of the speed times (u/4)^2, ahead and astern. Without a bound X_uuu would give 2e8 N at 0.01 m/s.
TEST(DerivativesHull, AReferenceSpeedGivesNoLoadAtRest) {
  for (const auto scaling : {DerivativeScaling::prime, DerivativeScaling::prime_draught}) {
    DerivativesHull hull =
        hull_with(scaling, {{"X_u", -0.002}, {"X_uu", 0.001}, {"X_uuu", -0.003}, {"Y_uuv", 0.01}, {"N_uud", 0.004}});
    hull.reference_speed = 8;
    const auto at = [&](double u, double v) { return derivatives_loads(hull, k_sea, {u, v, 0}, 0.2); };
    const double unit = 0.5 * k_sea * 50 * (scaling == DerivativeScaling::prime ? 50 : 4);
    const double x = (5.0 - 8) / 5;
    EXPECT_NEAR(at(5, 0).X / (unit * 25 * (-0.002 * x + 0.001 * x * x - 0.003 * x * x * x)), 1, 1e-12);
    const PlanarLoads half = at(4, 0);
    for (const double u : {2.0, 0.01, -0.01, -2.0}) {
      EXPECT_NEAR(at(u, 0).X / half.X, u * u / 16, 1e-12) << u;
      EXPECT_NEAR(at(u, 0).N / half.N, u * u / 16, 1e-12) << u;
    }
    EXPECT_NEAR(at(4 - 1e-9, 0).X / half.X, 1, 1e-8) << "without a jump";
    EXPECT_NEAR(at(0, 1e-3).Y, unit * 1e-6 * 0.01, 1e-12);
    EXPECT_EQ(at(0, 0).X, 0);
  }
}

/// MMG's polynomials as terms of the prime system with the draught: the same loads within MMG's range.
TEST(DerivativesHull, HoldsMmgAsASpecialCase) {
  const auto mmg = std::get<hydro::MmgHull>(hydro::kvlcc2(320).hull);
  DerivativesHull hull = hull_with(DerivativeScaling::prime_draught, {{"X_0", -mmg.R_0},
                                                                      {"X_vv", mmg.X_vv},
                                                                      {"X_vr", mmg.X_vr},
                                                                      {"X_rr", mmg.X_rr},
                                                                      {"X_vvvv", mmg.X_vvvv},
                                                                      {"Y_v", mmg.Y_v},
                                                                      {"Y_r", mmg.Y_r},
                                                                      {"Y_vvv", mmg.Y_vvv},
                                                                      {"Y_vvr", mmg.Y_vvr},
                                                                      {"Y_vrr", mmg.Y_vrr},
                                                                      {"Y_rrr", mmg.Y_rrr},
                                                                      {"N_v", mmg.N_v},
                                                                      {"N_r", mmg.N_r},
                                                                      {"N_vvv", mmg.N_vvv},
                                                                      {"N_vvr", mmg.N_vvr},
                                                                      {"N_vrr", mmg.N_vrr},
                                                                      {"N_rrr", mmg.N_rrr}});
  hull.length = mmg.length;
  hull.draught = mmg.draught;
  const hydro::PlanarMotion m{7, -2, 0.01};
  const PlanarLoads a = mmg_hull_loads(mmg, k_sea, m), b = derivatives_loads(hull, k_sea, m, 0);
  EXPECT_NEAR(b.X / a.X, 1, 1e-12);
  EXPECT_NEAR(b.Y / a.Y, 1, 1e-12);
  EXPECT_NEAR(b.N / a.N, 1, 1e-12);
}

/// The matrices of the source, in units of the bis system: M = m T Mb T with T = diag(1, 1, L), and D.
TEST(DerivativesHull, TheSupplyVesselHasTheMatricesOfItsSource) {
  const auto ship = hydro::supply_vessel(76.2, 9.81);
  const double m = 6000e3, L = 76.2;
  const auto added = planar_added_mass(ship, k_sea);
  EXPECT_NEAR((m + added.surge) / m, 1.1274, 1e-12);
  EXPECT_NEAR((m + added.sway) / m, 1.8902, 1e-12);
  EXPECT_NEAR(added.sway_yaw / (m * L), -0.0744, 1e-12);
  EXPECT_NEAR((m * L * L / 16 + added.yaw) / (m * L * L), 0.1278, 1e-12);
  const PlanarLoads sway = derivatives_loads(std::get<DerivativesHull>(ship.hull), k_sea, {0, 1, 0}, 0);
  EXPECT_NEAR(sway.Y / (m * std::sqrt(9.81 / L)), -0.1183, 1e-12);
  EXPECT_NEAR(sway.N / (m * L * std::sqrt(9.81 / L)), 0.0041, 1e-12);
}

/// A rigid body with Kirchhoff's added mass and kirchhoff_terms_in_model() obeys the equations of derivatives, where
/// the added mass has no quadratic terms: with the derivatives alone, (m + A11) u' = X + m v r + ..., so at v = r = 0
/// there is no yaw moment of u and v, and the terms of Kirchhoff cancel in all three equations.
TEST(DerivativesHull, KirchhoffsTermsCancel) {
  const auto ship = hydro::supply_vessel(76.2, 9.81);
  const auto planar = planar_added_mass(ship, k_sea);
  const hydro::PlanarMotion m{3, 0.7, -0.02};
  const PlanarLoads cancel = kirchhoff_terms_in_model(ship, planar, m);
  const double linear_x = planar.surge * m.u, linear_y = planar.sway * m.v + planar.sway_yaw * m.r;
  EXPECT_NEAR(cancel.X + linear_y * m.r, 0, 1e-6);
  EXPECT_NEAR(cancel.Y - linear_x * m.r, 0, 1e-6);
  EXPECT_NEAR(cancel.N - (m.u * linear_y - m.v * linear_x), 0, 1e-3);
}

}  // namespace nilas::derivatives_hull_test
