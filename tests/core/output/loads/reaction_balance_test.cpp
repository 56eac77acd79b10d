#include "core/output/loads/reaction_balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "core/base/error.h"
#include "core/output/loads/run_statistics.h"
#include "core/output/run/summary_json.h"
#include "tests/core/output/sample_run.h"

namespace nilas::output {
namespace reaction_balance_test {

sim::RunInfo towed_with_rudder() {
  sim::RunInfo info = test::full_run();
  info.vessel_length = 5;
  info.vessel_mass.mass = 100;
  info.parts = {{"rudder", JointKind::hinge}};
  return info;
}

/// The carriage carries 100 N and 50 N m, the rudder 10 N.
sim::StepRecord record_at(double t, double force_apart, double torque_apart, double unbalanced = 0) {
  sim::StepRecord record = test::full_record();
  record.t = t;
  sim::VesselRecord& vessel = *record.vessel;
  vessel.carriage->about_com = {Vec3(0, 100, 0), Vec3(0, 0, -50)};
  vessel.carriage->disagreement = Wrench{Vec3(0, 0, -force_apart), Vec3(torque_apart, 0, 0)};
  sim::PartRecord rudder;
  rudder.joint.force = Vec3(10, 0, 0);
  rudder.unbalanced_force = unbalanced;
  vessel.parts = {rudder};
  return record;
}

TEST(ReactionBalance, KeepsTheLargestDifferencesAndLoads) {
  ReactionBalance balance(towed_with_rudder());
  EXPECT_TRUE(balance.joints().empty());
  balance.add(record_at(1, 1e-6, 2e-5, 1e-7));
  balance.add(record_at(2, 3e-6, 1e-5, 4e-7));
  balance.add(record_at(3, 2e-6, 1e-5, 2e-7));
  const auto joints = balance.joints();
  ASSERT_EQ(joints.size(), 2U);
  EXPECT_EQ(joints[0].name, "");
  EXPECT_EQ(joints[0].force, 3e-6);
  EXPECT_EQ(joints[0].force_time, 2);
  EXPECT_EQ(joints[0].torque, 2e-5);
  EXPECT_EQ(joints[0].torque_time, 1);
  EXPECT_EQ(joints[0].largest_force, 100);
  EXPECT_EQ(joints[0].largest_torque, 50);
  EXPECT_DOUBLE_EQ(balance.relative(joints[0]), 2e-5 / 5 / 100);
  EXPECT_EQ(joints[1].name, "rudder");
  EXPECT_DOUBLE_EQ(balance.relative(joints[1]), 4e-8);
  EXPECT_EQ(balance.doubt(), "");
}

TEST(ReactionBalance, SaysWhichJointIsBeyondTheLimit) {
  ReactionBalance balance(towed_with_rudder());
  balance.add(record_at(1, 0.2, 0, 0.001));
  EXPECT_NE(balance.doubt().find("joint of the carriage is uncertain by 0.002"), std::string::npos) << balance.doubt();
  balance.add(record_at(2, 0, 0, 0.5));
  EXPECT_NE(balance.doubt().find("joint of part 'rudder' is uncertain by 0.05"), std::string::npos) << balance.doubt();
  balance.add(record_at(3, std::numeric_limits<double>::quiet_NaN(), 0));
  EXPECT_TRUE(std::isnan(balance.joints()[0].force));
}

TEST(ReactionBalance, TellsItWithinTheConsole) {
  for (const double apart : {1.23456e-15, 0.123456, 1234.56}) {
    ReactionBalance balance(towed_with_rudder());
    balance.add(record_at(1, apart, apart, apart));
    const std::string text = reaction_lines(balance);
    for (const char* told : {"carriage's reaction", "loads in joints", "'rudder'"})
      EXPECT_NE(text.find(told), std::string::npos) << text;
    EXPECT_EQ(text.find("joint loads doubtful") != std::string::npos, apart > 0.1) << text;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  }
}

/// Where nothing loads the carriage, rounding is all there is.
TEST(ReactionBalance, LeavesRoundingAlone) {
  ReactionBalance balance(towed_with_rudder());
  sim::StepRecord record = record_at(1, 1e-9, 0);
  record.vessel->carriage->about_com = {Vec3(1e-9, 0, 0), Vec3::Zero()};
  balance.add(record);
  EXPECT_GT(balance.relative(balance.joints()[0]), 0.5);
  EXPECT_EQ(balance.doubt(), "");
}

/// The carriage's load is known from one of both sources only, as in a run of the reference integrator.
TEST(ReactionBalance, SaysNothingOfWhatIsNotKnown) {
  sim::RunInfo info = test::full_run();
  info.parts.clear();
  ReactionBalance balance(info);
  sim::StepRecord record = test::full_record();
  record.vessel->carriage->disagreement.reset();
  balance.add(record);
  record.vessel.reset();
  balance.add(record);
  EXPECT_TRUE(balance.joints().empty());
  EXPECT_EQ(reaction_lines(balance), "");
}

TEST(ReactionBalance, GoesOnAsSaved) {
  ReactionBalance whole(towed_with_rudder()), rest(towed_with_rudder());
  whole.add(record_at(1, 3e-6, 2e-5, 1e-7));
  State state;
  whole.save(StateWriter(state));
  rest.restore(StateReader(state));
  for (ReactionBalance* balance : {&whole, &rest}) balance->add(record_at(2, 2e-6, 4e-5, 2e-7));
  EXPECT_EQ(reaction_lines(rest), reaction_lines(whole));
  EXPECT_EQ(rest.joints()[0].force_time, 1);
  EXPECT_EQ(rest.joints()[0].torque_time, 2);
  sim::RunInfo other = towed_with_rudder();
  other.parts.clear();
  ReactionBalance fewer(other);
  EXPECT_THROW(fewer.restore(StateReader(state)), InputError);
}

TEST(ReactionBalance, IsInTheSummary) {
  const sim::RunInfo info = towed_with_rudder();
  RunStatistics statistics(info);
  statistics.start(0, sim::Ledger{.works = {0, 0}});
  const sim::StepRecord record = record_at(0.01, 1e-6, 2e-5, 1e-7);
  statistics.add(record, std::vector<double>(53, 0.0));
  const auto summary = summary_json(info, statistics, {});
  EXPECT_EQ(summary["carriage_balance"]["force_N"], 1e-6);
  EXPECT_EQ(summary["carriage_balance"]["torque_time_s"], 0.01);
  EXPECT_EQ(summary["carriage_balance"]["largest_force_N"], 100);
  EXPECT_EQ(summary["carriage_balance"]["limit"], ReactionBalance::k_limit);
  EXPECT_DOUBLE_EQ(summary["joint_balance"]["rudder"]["relative"], 1e-8);
}

}  // namespace reaction_balance_test
}  // namespace nilas::output
