#include "core/vessel/mooring/mooring_module.h"

#include <gtest/gtest.h>
#include <spdlog/sinks/null_sink.h>

#include "core/base/error.h"
#include "core/geometry/shape.h"
#include "tests/core/vessel/mooring/mooring_example.h"

namespace nilas::vessel {

namespace mooring_module_test {

bodies::Bodies hull_at(const Pose& pose) {
  bodies::BodySpec spec;
  spec.kind = bodies::BodyKind::vessel;
  spec.motion = bodies::Motion::articulated;
  spec.shape = std::make_shared<const geometry::Shape>(geometry::box_shape({80, 80, 20}));
  spec.mass = 2.8e7;
  spec.inertia_B = 1e10 * Mat3::Identity();
  spec.pose = pose;
  bodies::Bodies bodies;
  bodies.add(spec);
  return bodies;
}

class MooringModule : public testing::Test {
 protected:
  WarningCounts warnings_{std::make_shared<spdlog::logger>("", std::make_shared<spdlog::sinks::null_sink_st>())};
  MooringModel model_ = example::mooring(6, true);
  bodies::Bodies bodies_ = hull_at(example::pose_of_hull());

  Vec3 force(bodies::ForceModule& module, double t = 0) {
    bodies::Wrenches out(1);
    module.add_forces(bodies_, t, out);
    return out[0].force;
  }
  static std::vector<double> values(const bodies::ForceModule& module) {
    std::vector<double> all;
    module.append_values(all);
    return all;
  }
};

TEST_F(MooringModule, HasAColumnPerLine) {
  const auto module = make_mooring(model_, 0, bodies_, warnings_);
  const std::vector<std::string> names = module->columns();
  ASSERT_EQ(names.size(), 8u);
  EXPECT_EQ(names[0], "line_m1_tension_N");
  EXPECT_EQ(names[6], "mooring_broken_1");
  EXPECT_EQ(names[7], "turret_angle_rad");
  EXPECT_EQ(values(*module).size(), names.size());
  EXPECT_EQ(module->load_on_vessel(), bodies::VesselLoad::own);
  EXPECT_FALSE(module->conservative());
}

/// Loads do not depend on how often they were asked for: a search starts anew each time.
TEST_F(MooringModule, HasNoMemoryOfItsSearches) {
  const auto module = make_mooring(model_, 0, bodies_, warnings_);
  const Vec3 first = force(*module);
  bodies_.set_pose(0, {30, 10, 0}, Quat::Identity());
  force(*module);
  const Pose back = example::pose_of_hull();
  bodies_.set_pose(0, back.p, back.q);
  EXPECT_EQ(force(*module), first);
}

TEST_F(MooringModule, BreaksALineByItsLoad) {
  const double tension = values(*make_mooring(model_, 0, bodies_, warnings_))[1];
  model_.lines[1].break_load = 1.01 * tension;
  const auto module = make_mooring(model_, 0, bodies_, warnings_);
  module->end_substep(bodies_, 1, 1);
  EXPECT_EQ(values(*module)[6], 0);
  // Off by 20 m against the pull, the line is tighter.
  const Vec3 aside = bodies_.p_GB[0] - 20 * (model_.lines[1].anchor - bodies_.p_GB[0]).normalized();
  bodies_.set_pose(0, aside, bodies_.q_GB[0]);
  const Vec3 held = force(*module);
  module->end_substep(bodies_, 2, 1);
  EXPECT_EQ(values(*module)[6], 1);
  EXPECT_EQ(values(*module)[1], 0);
  EXPECT_NE(force(*module), held);
  EXPECT_EQ(warnings_.counts().size(), 1u);
  EXPECT_EQ(warnings_.counts().begin()->first, "mooring line 'm2' broke");
}

TEST_F(MooringModule, BreaksALineAtItsTime) {
  model_.lines[3].break_time = 5;
  const auto module = make_mooring(model_, 0, bodies_, warnings_);
  module->end_substep(bodies_, 4.99, 0.01);
  EXPECT_EQ(values(*module)[6], 0);
  module->end_substep(bodies_, 5, 0.01);
  EXPECT_EQ(values(*module)[6], 1);
  EXPECT_EQ(values(*module)[3], 0);
}

TEST_F(MooringModule, ContinuesFromItsState) {
  model_.lines[3].break_time = 5;
  model_.turret->friction = 1e5;
  const auto first = make_mooring(model_, 0, bodies_, warnings_);
  bodies_.set_pose(0, bodies_.p_GB[0], Quat(Eigen::AngleAxisd(0.6, Vec3::UnitZ())));
  first->end_substep(bodies_, 6, 0.01);
  State state;
  first->save(bodies_, StateWriter(state));
  const auto second = make_mooring(model_, 0, bodies_, warnings_);
  second->restore(StateReader(state));
  EXPECT_EQ(force(*second), force(*first));
  second->end_substep(bodies_, 7, 0.01);
  first->end_substep(bodies_, 7, 0.01);
  EXPECT_EQ(values(*second), values(*first));
}

TEST_F(MooringModule, TellsWhenAFairleadSinksIntoTheBed) {
  const auto module = make_mooring(model_, 0, bodies_, warnings_);
  bodies_.set_pose(0, {0, 0, -98}, Quat::Identity());
  try {
    force(*module, 12.5);
    FAIL() << "no refusal";
  } catch (const SimulationError& error) {
    EXPECT_EQ(std::string(error.what()), "at 12.5 s mooring line 'm2': its fairlead is 6 m below the sea bed");
  }
}

}  // namespace mooring_module_test

}  // namespace nilas::vessel
