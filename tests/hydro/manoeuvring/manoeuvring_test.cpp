/// The module of manoeuvring: its loads in space, its machines, what it saves.
#include "hydro/manoeuvring/manoeuvring.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "hydro/modules.h"
#include "tests/hydro/manoeuvring/steered_ship.h"

namespace nilas::manoeuvring_test {

using test::PlanarState;

constexpr double k_sea = 1025, k_x_G = 11.2;  // [kg/m^3], [m]

hydro::ManoeuvringSettings settings_of(const hydro::ManoeuvringShip& ship) {
  hydro::ManoeuvringSettings settings;
  settings.ship = ship;
  settings.density = k_sea;
  settings.midship = -k_x_G;
  settings.rudder_rate = 2 * k_deg;
  settings.max_rudder = 35 * k_deg;
  settings.propeller_rate = 0.1;
  settings.rps = 1.5;
  return settings;
}

/// The wrench about the centre of mass against the loads of the plane: the force along and across the heading, and the
/// moment about midship turned to port, taken to the centre of mass x_G ahead of it.
TEST(Manoeuvring, LoadsAreThoseOfThePlane) {
  const auto ship = hydro::kvlcc2(320);
  RandomStream random(7, "loads");
  for (int k = 0; k < 20; ++k) {
    const Vec3 current(random.uniform(-1, 1), random.uniform(-1, 1), 0);
    auto settings = settings_of(ship);
    settings.current = current;
    const auto module = make_manoeuvring(settings, std::make_shared<Channels>());
    PlanarState s{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-3, 3), {}};
    s.motion = {random.uniform(-3, 8), random.uniform(-3, 3), random.uniform(-0.02, 0.02)};
    bodies::Bodies bodies = test::one_vessel(3e8);
    place_vessel(bodies, s, k_x_G, Vec3::Zero(), current);
    bodies::Wrenches out(1);
    module->add_forces(bodies, 0, out);
    hydro::PlanarLoads on = ship_loads(ship, k_sea, s.motion, 0, 1.5).sum();
    on += kirchhoff_terms_in_model(ship, planar_added_mass(ship, k_sea), s.motion);
    const double c = std::cos(s.heading), d = std::sin(s.heading), size = std::abs(on.X) + std::abs(on.Y);
    EXPECT_NEAR(out[0].force.x(), on.X * c - on.Y * d, 1e-10 * size);
    EXPECT_NEAR(out[0].force.y(), -on.X * d - on.Y * c, 1e-10 * size);
    EXPECT_EQ(out[0].force.z(), 0);
    EXPECT_NEAR(out[0].torque.z(), -(on.N - k_x_G * on.Y), 1e-10 * (std::abs(on.N) + k_x_G * size));
    EXPECT_EQ(out[0].torque.head<2>().norm(), 0);
  }
}

/// Added mass about the centre of mass: sway of the midship point at lever -x_G.
TEST(Manoeuvring, GivesItsAddedMassToTheVessel) {
  const auto ship = hydro::kvlcc2(320);
  const auto planar = planar_added_mass(ship, k_sea);
  const Mat6 matrix = make_manoeuvring(settings_of(ship), std::make_shared<Channels>())->vessel_added_mass().value();
  EXPECT_TRUE(matrix == matrix.transpose());
  EXPECT_EQ(matrix(0, 0), planar.surge);
  EXPECT_EQ(matrix(1, 5), -k_x_G * planar.sway);
  EXPECT_NEAR(matrix(5, 5) / (planar.yaw + k_x_G * k_x_G * planar.sway), 1, 1e-14);
  EXPECT_EQ(matrix.row(2).norm() + matrix.row(3).norm() + matrix.row(4).norm(), 0);
}

/// Rudder and propeller go to their commands at their rates and stop at their limits: after 3 s at 2 deg/s 6 degrees,
/// after 3 s at 0.1 1/s^2 from 1.5 to 1.8 1/s.
TEST(Manoeuvring, MachinesFollowAtTheirRates) {
  const auto commands = std::make_shared<Channels>();
  const auto module = make_manoeuvring(settings_of(hydro::kvlcc2(320)), commands);
  const bodies::Bodies bodies = test::one_vessel(3e8);
  commands->set(commands->find("rudder"), 1);
  commands->set(commands->find("propeller"), 5);
  const auto values = [&] {
    std::vector<double> all;
    module->append_values(all);
    return all;
  };
  for (int k = 0; k < 3; ++k) module->end_substep(bodies, k, 1);
  EXPECT_NEAR(values()[0], 6, 1e-12);
  EXPECT_NEAR(values()[1], 1.8, 1e-12);
  EXPECT_EQ((*commands)[commands->find("propeller.thrust_actual")], values()[2]);
  for (int k = 0; k < 30; ++k) module->end_substep(bodies, k, 1);
  EXPECT_NEAR(values()[0], 35, 1e-12);
  EXPECT_NEAR(values()[1], 2, 1e-12);
  EXPECT_EQ(module->columns().size(), values().size());
}

/// A thrust curve at 4 m/s of 8 m/s and full revolutions: the net thrust is pull (1 - 1/6 - 1/6), and the jet has what
/// the resistance of 2/3 (1/2)^2 took off, pull (1 - 1/6). Without revolutions there is no jet.
TEST(Manoeuvring, TheJetOfAThrustCurveHasTheThrustWithoutTheResistance) {
  auto ship = hydro::kvlcc2(320);
  ship.propulsion = hydro::ThrustCurve{.pull = 6e5, .max_speed = 8, .max_rps = 2};
  auto settings = settings_of(ship);
  settings.rps = 2;
  settings.propeller_rate = 10;
  const auto commands = std::make_shared<Channels>();
  const auto module = make_manoeuvring(settings, commands);
  bodies::Bodies bodies = test::one_vessel(3e8);
  test::place_vessel(bodies, {0, 0, 0, {4, 0, 0}}, k_x_G);
  module->end_substep(bodies, 1, 1);
  std::vector<double> values;
  module->append_values(values);
  EXPECT_NEAR(values[2], 4e5, 1e-9);
  EXPECT_NEAR((*commands)[commands->find("propeller.thrust_actual")], 5e5, 1e-9);
  commands->set(commands->find("propeller"), 0);
  module->end_substep(bodies, 2, 1);
  EXPECT_EQ((*commands)[commands->find("propeller.thrust_actual")], 0);
}

TEST(Manoeuvring, AddForcesChangesNothingAndStateIsKept) {
  const auto commands = std::make_shared<Channels>();
  const auto module = make_manoeuvring(settings_of(hydro::kvlcc2(320)), commands);
  bodies::Bodies bodies = test::one_vessel(3e8);
  test::place_vessel(bodies, {0, 0, 0.3, {5, 1, 0.01}}, k_x_G);
  commands->set(commands->find("rudder"), 0.3);
  module->end_substep(bodies, 0, 0.7);
  bodies::Wrenches a(1), b(1), c(1);
  module->add_forces(bodies, 0, a);
  module->add_forces(bodies, 0, b);
  EXPECT_EQ(a[0].force, b[0].force);
  State state;
  module->save(bodies, StateWriter(state));
  const auto again = make_manoeuvring(settings_of(hydro::kvlcc2(320)), std::make_shared<Channels>());
  again->restore(StateReader(state));
  again->add_forces(bodies, 0, c);
  EXPECT_EQ(a[0].force, c[0].force);
  EXPECT_EQ(a[0].torque, c[0].torque);
}

/// Drag leaves surge, sway and yaw of the vessel to this module. It still damps heave, roll and pitch, as it does for a
/// vessel that has no speed ahead; floes keep their drag.
TEST(Manoeuvring, DragLeavesThePlaneOut) {
  bodies::Bodies bodies = test::one_vessel(1e4);
  bodies::BodySpec floe;
  floe.name = "floe";
  floe.kind = bodies::BodyKind::floe;
  floe.shape = std::make_shared<const geometry::Shape>(geometry::box_shape(Vec3(4, 4, 1)));
  floe.mass = 1e4;
  floe.pose.p = Vec3(30, 0, 0);
  bodies.add(floe);
  for (auto& v : bodies.v_GB) v = Vec3(1, 0, 0);
  bodies.w_GB[0] = Vec3(0, 0, 0.1);
  bodies::Wrenches with(2), without(2), heaving(2), bobbing(2);
  const auto whole = hydro::make_drag({}, {}, 1), part = hydro::make_drag({}, {}, 1, false, true);
  whole->add_forces(bodies, 0, with);
  part->add_forces(bodies, 0, without);
  EXPECT_LT(with[0].force.x(), 0);
  EXPECT_EQ(without[0].force.norm(), 0);
  EXPECT_EQ(without[0].torque.norm(), 0);
  EXPECT_EQ(with[1].force, without[1].force);
  bodies.v_GB[0].z() = -0.3;
  bodies.w_GB[0].y() = 0.1;
  part->add_forces(bodies, 0, heaving);
  bodies.v_GB[0] = Vec3(0, 0, -0.3);
  bodies.w_GB[0] = Vec3(0, 0.1, 0);
  whole->add_forces(bodies, 0, bobbing);
  EXPECT_GT(heaving[0].force.z(), 0);
  EXPECT_EQ(heaving[0].force.z(), bobbing[0].force.z());
  EXPECT_EQ(heaving[0].torque.y(), bobbing[0].torque.y());
  EXPECT_EQ(heaving[0].force.x(), 0);
}

}  // namespace nilas::manoeuvring_test
