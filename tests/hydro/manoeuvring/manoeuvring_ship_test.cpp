/// The MMG model against published manoeuvres of KVLCC2, and its equations against a rigid body with added mass.
#include "hydro/manoeuvring/manoeuvring_ship.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"
#include "hydro/manoeuvring/ship_presets.h"
#include "tests/hydro/manoeuvring/ship_motion.h"

namespace nilas::manoeuvring_ship_test {

using hydro::ManoeuvringShip;
using hydro::PlanarLoads;
using hydro::PlanarMotion;
using test::PlanarShip;
using test::PlanarState;

constexpr double k_knot = 1852.0 / 3600;
constexpr double k_speed = 15.5 * k_knot;       // approach speed of the trials [m/s]
constexpr double k_rudder_rate = 2.34 * k_deg;  // [rad/s]
constexpr double k_step = 0.05;                 // [s]; halving it changes no figure below by 1e-4
constexpr double k_sea = 1025;                  // [kg/m^3]

double towards(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

/// The ship at a steady straight course.
struct Trial {
  PlanarShip ship = test::full_scale_kvlcc2(hydro::kvlcc2(320));
  PlanarState state{0, 0, 0, {k_speed, 0, 0}};
  double rps = hydro::self_propulsion(ship.model, k_sea, k_speed);
  double rudder = 0;

  void go(double wanted) {
    rudder = towards(rudder, wanted, k_rudder_rate * k_step);
    state = planar_step(ship, state, rudder, rps, k_step);
  }
};

struct Turn {
  double advance = 0, diameter = 0;  // over L
  double radius = 0, drift_deg = 0, speed_ratio = 0;
};

/// A turning circle to the end; the figures are those of the track of midship.
Turn turn(Trial trial, double rudder_deg) {
  Turn found;
  const double side = rudder_deg > 0 ? 1 : -1, L = trial.ship.model.length();
  for (double t = 0; t < 3000; t += k_step) {
    trial.go(rudder_deg * k_deg);
    const double turned = side * trial.state.heading;
    if (turned < 0.5 * k_pi) found.advance = trial.state.x / L;
    if (turned < k_pi) found.diameter = side * trial.state.y / L;
  }
  const PlanarMotion& m = trial.state.motion;
  const double U = std::hypot(m.u, m.v);
  found.radius = U / std::abs(m.r) / L;
  found.drift_deg = side * std::atan2(-m.v, m.u) / k_deg;
  found.speed_ratio = U / k_speed;
  return found;
}

/// The first overshoots of a zigzag that starts to starboard [deg].
std::vector<double> zigzag(double rudder_deg, double switch_deg) {
  Trial trial;
  std::vector<double> overshoots;
  double side = 1, peak = 0;
  for (double t = 0; overshoots.size() < 3 && t < 3000; t += k_step) {
    trial.go(side * rudder_deg * k_deg);
    const double heading = trial.state.heading / k_deg;
    peak = std::max(peak, -side * heading);
    if (side * heading < switch_deg) continue;
    overshoots.push_back(peak - switch_deg);  // of the side before; the first is none
    side = -side;
    peak = 0;
  }
  overshoots.erase(overshoots.begin());
  return overshoots;
}

/// Independent integration of the same coefficients: 106.66 rpm. By hand: (1 - t) rho D^4 n^2 K_T = 0.5 rho L d U^2
/// R_0.
TEST(ManoeuvringShip, Kvlcc2HoldsItsSpeedAtTheKnownRate) {
  const ManoeuvringShip ship = hydro::kvlcc2(320);
  const double n = hydro::self_propulsion(ship, k_sea, k_speed);
  EXPECT_NEAR(60 * n, 106.66, 0.01);
  const double J = 0.65 * k_speed / (n * 9.86), K_T = 0.2931 - 0.2753 * J - 0.1359 * J * J;
  const double thrust = 0.78 * k_sea * n * n * std::pow(9.86, 4) * K_T;
  const double resistance = 0.5 * k_sea * 320 * 20.8 * k_speed * k_speed * 0.022;
  EXPECT_NEAR(thrust / resistance, 1, 1e-14);
}

/// The figures of an independent integration (step 0.02 s), to its printed digits; the issue asks for 2 percent.
TEST(ManoeuvringShip, Kvlcc2TurnsAsPublished) {
  const Turn starboard = turn({}, 35), port = turn({}, -35);
  EXPECT_NEAR(starboard.advance, 2.974, 0.02);
  EXPECT_NEAR(starboard.diameter, 3.001, 0.02);
  EXPECT_NEAR(starboard.radius, 1.121, 0.002);
  EXPECT_NEAR(starboard.drift_deg, 19.42, 0.02);
  EXPECT_NEAR(starboard.speed_ratio, 0.376, 0.001);
  EXPECT_NEAR(port.advance, 2.999, 0.02);
  EXPECT_NEAR(port.diameter, 3.009, 0.02);
  EXPECT_NEAR(port.radius, 1.097, 0.002);
  EXPECT_NEAR(port.drift_deg, 19.63, 0.02);
}

TEST(ManoeuvringShip, Kvlcc2OvershootsAsPublished) {
  const auto ten = zigzag(10, 10), twenty = zigzag(20, 20);
  EXPECT_NEAR(ten[0], 4.89, 0.1);
  EXPECT_NEAR(ten[1], 13.14, 0.1);
  EXPECT_NEAR(twenty[0], 10.46, 0.1);
  EXPECT_NEAR(twenty[1], 15.32, 0.1);
}

/// A ship at another scale makes the same circle, in lengths: Froude's law holds to rounding.
TEST(ManoeuvringShip, ScalesByFroude) {
  const double scale = 1.0 / 64;
  const ManoeuvringShip full = hydro::kvlcc2(320), model = hydro::kvlcc2(320 * scale);
  const double ratio = std::sqrt(scale);
  const PlanarMotion at_full{6, -1.5, 0.01}, at_model{6 * ratio, -1.5 * ratio, 0.01 / ratio};
  const PlanarLoads a = ship_loads(full, k_sea, at_full, 0.3, 1.5).sum();
  const PlanarLoads b = ship_loads(model, k_sea, at_model, 0.3, 1.5 / ratio).sum();
  const double force = scale * scale * scale;
  EXPECT_NEAR(b.X / (a.X * force), 1, 1e-12);
  EXPECT_NEAR(b.Y / (a.Y * force), 1, 1e-12);
  EXPECT_NEAR(b.N / (a.N * force * scale), 1, 1e-12);
}

/// Derivatives in SI units have dimensions of their own; the loads scale all the same.
TEST(ManoeuvringShip, DerivativesWithDimensionScaleByFroude) {
  hydro::DerivativesHull hull;
  hull.length = 80;
  hull.X_udot = -1e6;
  hull.Y_rdot = hull.N_vdot = 3e6;
  hull.Y_vdot = -4e6;
  hull.N_rdot = -5e8;
  for (const auto& [name, value] : std::vector<std::pair<std::string, double>>{
           {"X_u|u|", -2e3}, {"Y_v", -3e5}, {"Y_vrr", -4e7}, {"N_r", -5e7}, {"N_d", 6e6}, {"X_0", 1e5}}) {
    hull.terms.push_back(*hydro::derivative_term(name));
    hull.terms.back().value = value;
  }
  hydro::ThrustCurve curve{5e5, 8, 2, 4};
  const ManoeuvringShip full{hull, curve, std::nullopt, 2}, model = scaled(full, 1.0 / 16);
  const PlanarMotion at_full{4, 1, 0.02}, at_model{1, 0.25, 0.08};
  const PlanarLoads a = ship_loads(full, k_sea, at_full, 0.3, 1.5).sum();
  const PlanarLoads b = ship_loads(model, k_sea, at_model, 0.3, 6).sum();
  EXPECT_EQ(b.X * 4096, a.X);
  EXPECT_EQ(b.Y * 4096, a.Y);
  EXPECT_EQ(b.N * 65536, a.N);
  EXPECT_EQ(planar_added_mass(model, k_sea).sway * 4096, planar_added_mass(full, k_sea).sway);
  EXPECT_EQ(planar_added_mass(model, k_sea).yaw * 4096 * 256, planar_added_mass(full, k_sea).yaw);
}

ManoeuvringShip symmetric_ship() {
  ManoeuvringShip ship = hydro::kvlcc2(320);
  auto& propeller = std::get<hydro::OpenWaterPropeller>(ship.propulsion);
  propeller.C_2_minus = propeller.C_2_plus;
  ship.rudder->gamma_minus = ship.rudder->gamma_plus;
  return ship;
}

PlanarMotion any_motion(RandomStream& random) {
  return {random.uniform(-8, 8), random.uniform(-4, 4), random.uniform(-0.03, 0.03)};
}

/// With equal coefficients on both sides, mirrored motions have mirrored loads to the last bit.
TEST(ManoeuvringShip, MirroredMotionsHaveMirroredLoads) {
  const ManoeuvringShip ship = symmetric_ship();
  RandomStream random(3, "mirror");
  for (int k = 0; k < 100; ++k) {
    const PlanarMotion m = any_motion(random);
    const double rudder = random.uniform(-0.6, 0.6), rps = random.uniform(0, 2);
    const PlanarLoads a = ship_loads(ship, k_sea, m, rudder, rps).sum();
    const PlanarLoads b = ship_loads(ship, k_sea, {m.u, -m.v, -m.r}, -rudder, rps).sum();
    EXPECT_EQ(a.X, b.X);
    EXPECT_EQ(a.Y, -b.Y);
    EXPECT_EQ(a.N, -b.N);
  }
}

/// Mirrored circles of a symmetric ship are the same; those of KVLCC2 are not, as its flow-straightening shows.
TEST(ManoeuvringShip, OnlyASymmetricShipTurnsAlikeToBothSides) {
  const auto trial = [] {
    Trial t;
    t.ship.model = symmetric_ship();
    return t;
  };
  const Turn starboard = turn(trial(), 35), port = turn(trial(), -35);
  EXPECT_EQ(starboard.advance, port.advance);
  EXPECT_EQ(starboard.diameter, port.diameter);
  EXPECT_GT(turn({}, -35).advance, turn({}, 35).advance + 0.01);
}

/// Loads are continuous where the polynomials end, and finite at rest and astern. A bare hull is braked whatever it
/// does.
TEST(ManoeuvringShip, StaysBoundedBeyondItsRange) {
  const auto hull = std::get<hydro::MmgHull>(hydro::kvlcc2(320).hull);
  const double U = 4, b = hydro::k_mmg_drift;
  const auto at = [&](double drift, double r) {
    return mmg_hull_loads(hull, k_sea, {U * std::cos(drift), -U * std::sin(drift), r});
  };
  const PlanarLoads inside = at(b - 1e-9, 0.01), outside = at(b + 1e-9, 0.01);
  EXPECT_NEAR(inside.X / outside.X, 1, 1e-6);
  EXPECT_NEAR(inside.N / outside.N, 1, 1e-6);
  const PlanarLoads rest = mmg_hull_loads(hull, k_sea, {0, 0, 0}), spin = mmg_hull_loads(hull, k_sea, {0, 0, 0.02});
  EXPECT_EQ(rest.X, 0);
  EXPECT_EQ(spin.X, 0);
  EXPECT_LT(spin.N, 0);
  EXPECT_GT(at(k_pi, 0).X, 0);
  for (double drift = 0.6; drift < 2.6; drift += 0.1) {
    EXPECT_GT(at(drift, 0).Y, 0) << drift;
    EXPECT_LT(at(-drift, 0).Y, 0) << drift;
  }
}

/// The equations that a rigid body with Kirchhoff's added mass obeys, written as vectors in space with the 6 x 6 matrix
/// about the centre of mass, with the loads of the model and kirchhoff_terms_in_model(): they must give the
/// accelerations of planar_acceleration() at any motion.
TEST(ManoeuvringShip, ARigidBodyWithAddedMassObeysTheEquationsOfMmg) {
  RandomStream random(5, "equations");
  for (int k = 0; k < 50; ++k) {
    const PlanarShip ship = test::full_scale_kvlcc2(hydro::kvlcc2(320));
    const PlanarMotion m = any_motion(random);
    const double rudder = random.uniform(-0.6, 0.6), rps = random.uniform(0, 2);
    const hydro::PlanarAddedMass planar = planar_added_mass(ship.model, k_sea);
    PlanarLoads on = ship_loads(ship.model, k_sea, m, rudder, rps).sum();
    on += kirchhoff_terms_in_model(ship.model, planar, m);
    // In axes with y to port and z up; the centre of mass is x_G ahead of midship.
    const Vec3 w(0, 0, -m.r), midship(-ship.x_G, 0, 0), v = Vec3(m.u, -m.v, 0) - w.cross(midship);
    const Vec3 force(on.X, -on.Y, 0), torque = Vec3(0, 0, -on.N) + midship.cross(force);
    const Mat6 added = hydro::added_mass(planar, -ship.x_G);
    Mat6 whole = added;
    whole.diagonal() += (Vec6() << ship.mass, ship.mass, ship.mass, 1, 1, ship.inertia).finished();
    Vec6 twist, right;
    twist << v, w;
    const Vec6 momentum = added * twist;  // of the water
    const Vec3 linear = momentum.head<3>(), angular = momentum.tail<3>();
    right << force - w.cross(linear) - ship.mass * w.cross(v), torque - w.cross(angular) - v.cross(linear);
    // Rates of the components in the turning axes: heave, roll and pitch have no load and no added mass.
    const Vec6 rates = whole.inverse() * right;
    const Vec3 expected = planar_acceleration(ship, m, rudder, rps);
    const double v_rate = -rates[1] + ship.x_G * rates[5];  // of midship, to starboard
    EXPECT_NEAR(rates[0], expected[0], 1e-13);
    EXPECT_NEAR(v_rate, expected[1], 1e-13);
    EXPECT_NEAR(-rates[5], expected[2], 1e-15);
    EXPECT_NEAR(right[2], 0, 1e-6);
  }
}

/// Open water with a thrust curve: at the share s of the largest rate the speed is s of the largest speed. The terms by
/// hand: s^2 - s x/3 - 2/3 x^2 = 0 has the root x = s.
TEST(ManoeuvringShip, ThrustMeetsResistanceAtTheSpeedOfTheCurve) {
  ManoeuvringShip ship = hydro::kvlcc2(100);
  ship.rudder.reset();
  hydro::ThrustCurve curve;
  curve.pull = 1e6;
  curve.max_speed = 8;
  curve.max_rps = 2;
  ship.propulsion = curve;
  ship.max_rps = 2;
  EXPECT_NEAR(ship_loads(ship, k_sea, {8, 0, 0}, 0, 2).sum().X, 0, 1e-9);  // rounding of 1 - 1/3 - 2/3, times the pull
  EXPECT_NEAR(ship_loads(ship, k_sea, {0, 0, 0}, 0, 2).sum().X, 1e6, 1e-9);
  EXPECT_NEAR(hydro::self_propulsion(ship, k_sea, 4), 1, 1e-14);
  PlanarShip free{ship, k_sea, 2e7, 1e10, 0};
  PlanarState state{0, 0, 0, {1, 0, 0}};
  for (int k = 0; k < 20000; ++k) state = planar_step(free, state, 0, 1.5, 0.5);
  EXPECT_NEAR(state.motion.u, 6, 1e-12);
}

/// The pull of one propeller of 10 MW and 5 m is 0.78 (10000 x 5)^(2/3) = 1058.6 kN.
TEST(ManoeuvringShip, BollardPullFollowsFromPower) {
  EXPECT_NEAR(hydro::bollard_pull(10e6, 5, 1), 1058.6e3, 100);
  EXPECT_NEAR(hydro::bollard_pull(10e6, 5, 2) / hydro::bollard_pull(10e6, 5, 1), 0.98 / 0.78, 1e-12);
  EXPECT_THROW(hydro::bollard_pull(10e6, 5, 4), InputError);
}

TEST(ManoeuvringShip, TellsTheSpeedThatItsPropellerHolds) {
  const ManoeuvringShip ship = hydro::kvlcc2(320);
  // Thrust and resistance both go with the square of speed and rate, so 2 1/s hold 15.5 kn x 2/1.7777.
  try {
    hydro::self_propulsion(ship, k_sea, 20);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("8.971 m/s"), std::string::npos) << error.what();
  }
}

}  // namespace nilas::manoeuvring_ship_test
