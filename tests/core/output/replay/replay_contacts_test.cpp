#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/output/replay/contacts.h"
#include "core/output/replay/replay_file.h"
#include "tests/core/output/replay/replay_reader.h"
#include "tests/core/output/sample_run.h"
#include "tests/support/file_text.h"

namespace nilas::output::replay {
namespace replay_contacts_test {

/// Bodies of sample_bodies() (0 a free floe, 1 a fixed floe, 2 the vessel, 3 a wall) and two free floes more.
bodies::Bodies six_bodies() {
  bodies::Bodies bodies = test::sample_bodies();
  for (const double x : {7, 9})
    test::add_body(bodies, "floe", bodies::BodyKind::floe, bodies::Motion::free, test::triangle_floe(), 10,
                   Vec3(x, 0, 0));
  return bodies;
}

void touch(contact::SolvedProblem& solved, const bodies::Bodies& bodies, int a, int b, const Vec3& impulse) {
  const auto body = [&](int k) -> contact::TouchingBody { return {bodies.id[static_cast<std::size_t>(k)], 0.1}; };
  detect::ContactPoint point;
  point.a = a;
  point.b = b;
  point.p = Vec3(static_cast<double>(solved.points.size()), 0, 0);
  point.n = Vec3(0, 0.6, 0.8);
  solved.points.push_back(point);
  solved.touching.push_back({body(a), body(b)});
  solved.impulses.push_back(impulse);
  solved.problem.mu.push_back(0.5);
  solved.problem.force_limit.push_back(std::numeric_limits<double>::infinity());
  solved.problem.compliance.push_back(0);
  solved.problem.tangential_compliance.push_back(0);
  const auto rows = 3 * static_cast<Eigen::Index>(solved.points.size());
  solved.solution.r.conservativeResize(rows);
  solved.solution.u = VecX::Zero(rows);
  solved.solution.r.tail<3>() = Vec3(impulse.norm(), 0, 0);
}

/// Within the errors that docs/reference/replay-file.md states.
void expect_pair(const test::ReplayContact& shown, const Vec3& force, const Vec3& p, double unit) {
  EXPECT_LT(std::abs(shown.force.norm() / force.norm() - 1), 0.06);
  EXPECT_LT((shown.force.normalized() - force.normalized()).norm(), 0.08);
  EXPECT_LT((shown.n - Vec3(0, 0.6, 0.8)).norm(), 0.05);
  EXPECT_LT((shown.p - p).norm(), 224 * unit);
}

class ReplayContactsTest : public testing::Test {
 protected:
  ReplayContactsTest() {
    choice_.loaded.vessel = 2;
    choice_.in_table = true;
  }
  FrameContacts gathered(double h = 0.5) const { return frame_contacts({solved_}, bodies_, choice_, h); }

  bodies::Bodies bodies_ = six_bodies();
  contact::SolvedProblem solved_;
  ContactChoice choice_;
};

TEST_F(ReplayContactsTest, ContactsOfTheVesselStandEachForItselfAndThoseOfFloesAreSummed) {
  touch(solved_, bodies_, 0, 2, Vec3(1, 2, 3));
  touch(solved_, bodies_, 0, 2, Vec3(4, 5, 6));
  touch(solved_, bodies_, 4, 5, Vec3(0, 3, 0));
  touch(solved_, bodies_, 4, 5, Vec3(0, 1, 0));
  const FrameContacts list = gathered();
  ASSERT_EQ(list.contacts.size(), 3u);
  EXPECT_TRUE(list.contacts[0].stored && list.contacts[0].exact);
  EXPECT_EQ(list.contacts[0].first, 2);
  EXPECT_EQ(list.contacts[1].force, Vec3(8, 10, 12)) << "impulse over the step";
  const FrameContact& pair = list.contacts[2];
  EXPECT_FALSE(pair.stored || pair.exact);
  EXPECT_EQ(pair.force, Vec3(0, 8, 0));
  EXPECT_DOUBLE_EQ(pair.p_G.x(), 2.25) << "the mean point, weighted with the forces";
  EXPECT_NEAR((pair.n - Vec3(0, 0.6, 0.8)).norm(), 0, 1e-15);
}

TEST_F(ReplayContactsTest, AllContactsStandForThemselvesWhereTheTableHasAll) {
  choice_.of_all_bodies = true;
  touch(solved_, bodies_, 4, 5, Vec3(0, 3, 0));
  touch(solved_, bodies_, 4, 5, Vec3(0, 0, 0));
  const FrameContacts list = gathered();
  ASSERT_EQ(list.contacts.size(), 2u);
  for (const auto& contact : list.contacts) EXPECT_TRUE(contact.stored);
}

TEST_F(ReplayContactsTest, BodiesThatMoveHangTogetherInIslands) {
  touch(solved_, bodies_, 0, 1, Vec3(0, 1, 0));  // a fixed floe joins nothing
  touch(solved_, bodies_, 1, 4, Vec3(0, 1, 0));
  touch(solved_, bodies_, 4, 5, Vec3(0, 1, 0));
  solved_.solution.iterations = 12;
  const FrameContacts list = gathered();
  EXPECT_EQ(list.island_of, (std::vector<int>{1, 0, 0, 0, 2, 2}));
  ASSERT_EQ(list.islands.size(), 2u);
  EXPECT_EQ(list.islands[0].contacts, 1);
  EXPECT_EQ(list.islands[1].contacts, 2);
  EXPECT_EQ(list.islands[1].iterations, 12);
}

TEST_F(ReplayContactsTest, AContactOfABrokenFloeStaysWithTheVessel) {
  touch(solved_, bodies_, 0, 2, Vec3(1, 2, 3));
  touch(solved_, bodies_, 0, 4, Vec3(1, 2, 3));
  bodies_.remove({1, 0, 0, 0, 0, 0});
  choice_.loaded.vessel = 1;
  solved_.points[0].b = 1;
  const FrameContacts list = gathered();
  ASSERT_EQ(list.contacts.size(), 2u);
  EXPECT_EQ(list.contacts[0].first, 1);
  EXPECT_EQ(list.contacts[0].second, 1) << "the other body is gone";
}

TEST_F(ReplayContactsTest, PointsWithoutImpulsesAreLeftOut) {
  touch(solved_, bodies_, 0, 2, Vec3(1, 2, 3));
  solved_.solution = {};
  EXPECT_TRUE(gathered().contacts.empty());
  solved_.impulses.clear();
  EXPECT_TRUE(gathered().contacts.empty());
}

TEST_F(ReplayContactsTest, ForcesAndPointsAreReadBack) {
  touch(solved_, bodies_, 0, 2, Vec3(1, 2, 3));
  touch(solved_, bodies_, 4, 5, Vec3(-7, 3, 1e3));
  const test::ScratchFolder scratch;
  scene::Scene scene;
  sim::RunInfo info = test::full_run();
  info.has_vessel = false;
  ReplayFile file(scratch / "replay.bin", scene, info, {}, true);
  file.frame({.t = 1, .h = 0.5, .step = 3, .bodies = bodies_, .substeps = {solved_}, .damage = {}, .lines = {}});
  const test::Replay replay(test::read_text(scratch / "replay.bin"));
  ASSERT_EQ(replay.frames.size(), 1u);
  const auto& frame = replay.frames[0];
  ASSERT_EQ(frame.contacts.size(), 2u);
  EXPECT_TRUE(frame.contacts[0].exact && frame.contacts[0].stored);
  EXPECT_EQ(frame.contacts[0].force, Vec3(2, 4, 6));
  EXPECT_FALSE(frame.contacts[1].exact || frame.contacts[1].stored);
  expect_pair(frame.contacts[1], Vec3(-14, 6, 2e3), solved_.points[1].p, frame.bodies[4].unit);
}

/// Sums over pairs are written as differences: pairs that stay, end, begin again and whose bodies go are read back.
TEST_F(ReplayContactsTest, PairsAreReadBackWhileBodiesGo) {
  for (const double x : {11, 13, 15})
    test::add_body(bodies_, "floe", bodies::BodyKind::floe, bodies::Motion::free, test::triangle_floe(), 10,
                   Vec3(x, 0, 0));
  choice_.loaded.vessel = -1;
  const test::ScratchFolder scratch;
  scene::Scene scene;
  sim::RunInfo info = test::full_run();
  info.has_vessel = false;
  ReplayFile file(scratch / "replay.bin", scene, info, {}, true);
  using Touching = std::vector<std::pair<int, int>>;
  const std::vector<Touching> steps{
      {{4, 5}, {5, 6}, {6, 7}, {7, 8}}, {{4, 5}, {6, 7}, {4, 8}}, {{3, 4}, {5, 6}, {3, 7}}};
  std::vector<std::vector<Vec3>> forces;
  const Vec3 offset(2e-3, -3e-3, 1e-3);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    solved_ = {};
    forces.emplace_back();
    if (k == 2) bodies_.remove({1, 0, 0, 0, 0, 0, 0, 0, 0});
    for (int b = 3; b < bodies_.size(); ++b)
      bodies_.set_pose(b, bodies_.p_GB[static_cast<std::size_t>(b)] + Vec3(0, 0.1, 0),
                       Quat(Eigen::AngleAxisd(0.7 * static_cast<double>(k) + b, Vec3(1, 2, 3).normalized())));
    for (const auto& [a, b] : steps[k]) {
      forces.back().emplace_back(std::pow(10, a - 3), -b, 0.5);
      touch(solved_, bodies_, a, b, 0.5 * forces.back().back());
      solved_.points.back().p = bodies_.p_GB[static_cast<std::size_t>(b)] + offset;
    }
    file.frame({.t = static_cast<double>(k),
                .h = 0.5,
                .step = 3,
                .bodies = bodies_,
                .substeps = {solved_},
                .damage = {},
                .lines = {}});
  }
  const test::Replay replay(test::read_text(scratch / "replay.bin"));
  ASSERT_EQ(replay.frames.size(), steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const auto& frame = replay.frames[k];
    ASSERT_EQ(frame.contacts.size(), steps[k].size());
    for (const auto& shown : frame.contacts) {
      // Forces are those on the second of the two.
      const Touching::value_type pair{static_cast<int>(shown.second), static_cast<int>(shown.first)};
      const auto i = static_cast<std::size_t>(std::find(steps[k].begin(), steps[k].end(), pair) - steps[k].begin());
      ASSERT_LT(i, steps[k].size()) << pair.first << " and " << pair.second << " do not touch in frame " << k;
      expect_pair(shown, forces[k][i], frame.bodies[shown.first].p + offset, frame.bodies[shown.first].unit);
    }
  }
}

}  // namespace replay_contacts_test
}  // namespace nilas::output::replay
