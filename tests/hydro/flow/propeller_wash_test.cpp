#include "hydro/flow/propeller_wash.h"

#include <gtest/gtest.h>

#include "core/geometry/shape.h"

namespace nilas::hydro {

namespace propeller_wash_test {

bodies::Bodies hull_at(const Vec3& p, double yaw) {
  bodies::BodySpec spec;
  spec.name = "ship";
  spec.kind = bodies::BodyKind::vessel;
  spec.motion = bodies::Motion::articulated;
  spec.shape = std::make_shared<const geometry::Shape>(geometry::box_shape({40, 10, 5}));
  spec.mass = 1e6;
  spec.pose = {Quat(Eigen::AngleAxisd(yaw, Vec3::UnitZ())), p};
  bodies::Bodies bodies;
  bodies.add(spec);
  return bodies;
}

struct Rig {
  std::shared_ptr<PropellerJet> jet = std::make_shared<PropellerJet>(3.0, 1025.0);
  std::shared_ptr<Channels> channels = std::make_shared<Channels>();
  int thrust = channels->add(thrust_channel_name("stern"), "N", 1e5);
  int angle = channels->add(angle_channel_name("stern"), "rad", 0);

  std::unique_ptr<bodies::Module> module(const bodies::Bodies& bodies, bool turns) const {
    const auto push = [](double a, bool) { return direction_of(a); };
    return make_propeller_wash({{jet, {-20, 0, -2}, {-1, 0, 0}, 0, thrust, turns ? angle : -1, push}}, 0, channels,
                               bodies);
  }
};

/// The jet leaves astern of the vessel, wherever it lies and points.
TEST(PropellerWash, JetFollowsPoseAndThrust) {
  const Rig rig;
  const auto module = rig.module(hull_at(Vec3::Zero(), 0), false);
  const double V0 = rig.jet->efflux_velocity();
  EXPECT_LT((rig.jet->velocity({-21, 0, -2}, 0) - Vec3(-V0, 0, 0)).norm(), 1e-12);
  rig.channels->set(rig.thrust, 4e5);
  module->end_substep(hull_at({5, 6, 0}, k_pi / 2), 1, 0.1);
  EXPECT_NEAR(rig.jet->efflux_velocity(), 2 * V0, 1e-12);
  EXPECT_LT((rig.jet->velocity({5, 6 - 21, -2}, 0) - Vec3(0, -2 * V0, 0)).norm(), 1e-12);
}

/// A thruster that pushes the vessel to port (90 degrees from x towards y) sends its jet to starboard.
TEST(PropellerWash, JetLeavesAgainstTheThrustOfATurnedThruster) {
  const Rig rig;
  rig.channels->set(rig.angle, k_pi / 2);
  const auto module = rig.module(hull_at(Vec3::Zero(), 0), true);
  EXPECT_LT((rig.jet->velocity({-20, -1, -2}, 0) - Vec3(0, -rig.jet->efflux_velocity(), 0)).norm(), 1e-12);
}

/// A rudder takes 10 % of the thrust as drag and gives 50 % of it to port: the jet carries the momentum of both, thrust
/// times (-0.9, -0.5). Astern the rudder does nothing, and the jet leaves ahead.
TEST(PropellerWash, ARudderTurnsTheJetByItsForce) {
  const Rig rig;
  const Vec2 both(0.9, 0.5);
  const auto push = [&](double angle, bool ahead) { return angle > 0 && ahead ? both : Vec2(1, 0); };
  const bodies::Bodies hull = hull_at(Vec3::Zero(), 0);
  const auto module =
      make_propeller_wash({{rig.jet, {-20, 0, -2}, {-1, 0, 0}, 0, rig.thrust, rig.angle, push}}, 0, rig.channels, hull);
  const double V0 = rig.jet->efflux_velocity();
  rig.channels->set(rig.angle, 0.6);
  module->end_substep(hull, 1, 0.1);
  const Vec3 u = rig.jet->velocity({-20 - 0.9, -0.5, -2}, 0);
  EXPECT_LT((u - V0 / std::sqrt(both.norm()) * Vec3(-0.9, -0.5, 0)).norm(), 1e-12)
      << "V0 goes with the root of the force";
  rig.channels->set(rig.thrust, -1e5);
  module->end_substep(hull, 2, 0.1);
  EXPECT_LT((rig.jet->velocity({-19, 0, -2}, 0) - Vec3(V0, 0, 0)).norm(), 1e-12);
}

/// Between two steps the jet is that of the last substep. A resumed run has the same bits.
TEST(PropellerWash, ContinuesWithTheJetThatItHad) {
  const Rig first, second;
  const auto module = first.module(hull_at({1, 2, 3}, 0.7), false);
  module->end_substep(hull_at({4, 5, 6}, 0.9), 1, 0.1);
  State state;
  module->save(hull_at({4, 5, 6}, 0.9), StateWriter(state));
  const auto resumed = second.module(hull_at({1, 2, 3}, 0.7), false);
  resumed->restore(StateReader(state));
  for (const Vec3& p : {Vec3(-9, -10, 4), Vec3(-12, -11, 3)})
    EXPECT_EQ(first.jet->velocity(p, 0), second.jet->velocity(p, 0));
}

TEST(PropellerWash, ConstantThrustNeedsNoChannel) {
  const auto jet = std::make_shared<PropellerJet>(3.0, 1025.0);
  const bodies::Bodies bodies = hull_at(Vec3::Zero(), 0);
  make_propeller_wash({{jet, {-20, 0, -2}, {-1, 0, 0}, 2e5, -1, -1, {}}}, 0, std::make_shared<Channels>(), bodies);
  EXPECT_GT(jet->efflux_velocity(), 5);
}

}  // namespace propeller_wash_test

}  // namespace nilas::hydro
