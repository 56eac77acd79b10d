/// A step that is begun, taken back and begun again with another length: the same bits as without it.
#include <gtest/gtest.h>

#include "tests/core/vessel/tree/jointed_example.h"

namespace nilas::vessel {
namespace vessel_abandon_test {

/// Free, on every kind of carriage while it turns on its ramp, and with parts.
std::vector<VesselModel> models() {
  std::vector<VesselModel> models{example::vessel(),
                                  example::carried(BalanceKind::rigid),
                                  example::carried(BalanceKind::rigid, {false, false, true, true, true, true}),
                                  example::carried(BalanceKind::prismatic),
                                  example::carried(BalanceKind::six_cells, {false, false, true, false, true, false}),
                                  example::chain(),
                                  example::chain()};
  models[0].v = {0.4, -0.2, 0.1};
  models[0].w = {0.2, -0.3, 0.25};
  models.back().carriage = example::carried(BalanceKind::rigid, {false, false, true, false, true, false}).carriage;
  for (VesselModel& model : models) {
    if (!model.carriage) continue;
    const Vec3 start = model.pose_V.p + model.pose_V.q * model.carriage->joint_V;
    model.carriage->motion = CarriageMotion::straight(start, 0.3, 1.2, 0.5, 0.2, 0);
  }
  return models;
}

TEST(VesselAbandon, AStepTakenBackLeavesNoTrace) {
  const double h = 0.01;
  for (VesselModel model : models())
    for (const std::optional<double> theta : {std::optional<double>(), {0.5}, {1.0}}) {
      model.theta = theta;
      VesselSystem plain(model, 0), tried(model, 0);
      RandomStream random(31, "abandon");
      for (int k = 0; k < 30; ++k) {
        std::vector<Wrench> loads, impulses;
        for (std::size_t b = 0; b <= model.parts.size(); ++b) {
          loads.push_back(example::random_wrench(random, 50));
          impulses.push_back(example::random_wrench(random, 1));
        }
        const std::vector<Wrench> on_parts(loads.begin() + 1, loads.end());
        tried.move_before_impulses(2 * h);
        tried.begin(loads.front(), 2 * h, on_parts);
        tried.abandon_step();
        tried.move_before_impulses(h);
        tried.abandon_step();
        example::step(plain, loads, h, impulses);
        example::step(tried, loads, h, impulses);
        ASSERT_EQ(plain.coordinates(), tried.coordinates()) << k;
        ASSERT_EQ(plain.state().v, tried.state().v) << k;
        ASSERT_EQ(plain.state().pose.p, tried.state().pose.p) << k;
        ASSERT_EQ(plain.carriage_loads().about_joint.torque, tried.carriage_loads().about_joint.torque) << k;
        ASSERT_EQ(plain.time(), tried.time());
      }
    }
}

}  // namespace vessel_abandon_test
}  // namespace nilas::vessel
