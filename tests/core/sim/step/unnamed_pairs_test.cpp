/// Bodies whose materials no <friction> names together: they touch without friction, and the user is told once.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/support/scratch_folder.h"

namespace unnamed_pairs_test {

using namespace nilas;
using namespace nilas::sim;

using Counts = std::map<std::string, long>;

/// The warnings of pairs without friction, by their kind.
Counts of_pairs(const WarningCounts& warnings) {
  Counts found;
  for (const auto& [kind, count] : warnings.counts())
    if (kind.starts_with("frictionless")) found[kind] = count;
  return found;
}

/// A box of rubber slides along x at 1 m/s on a plane of steel. The only pair that is named is another one.
class UnnamedPairs : public testing::Test {
 protected:
  test::ScratchFolder folder_;
  scene::Scene scene_ = scene::read_scene(folder_.write(
      "scene.xml",
      "<scene version='1'><time step='0.01' end='1'/>"
      "<contact><friction between='rubber rubber' static='0.3' "
      "kinetic='0.3'/></contact>"
      "<body name='ground' shape='plane' fixed='true' material='steel'/>"
      "<body name='box' shape='box' size='1 1 1' position='0 0 0.5' velocity='1 0 0' material='rubber'/></scene>"));
  WarningCounts warnings_{make_logger("off", "")};
};

/// Without friction nothing brakes the box; the tolerance is rounding. Of the three steps only the first one warns.
TEST_F(UnnamedPairs, AreFrictionlessAndWarnedOfOnce) {
  Simulation run(scene_, 1, warnings_);
  for (int k = 0; k < 3; ++k) EXPECT_GT(run.step().contacts, 0);
  EXPECT_NEAR(run.bodies().v_GB[1].x(), 1, 1e-12);
  EXPECT_EQ(of_pairs(warnings_), (Counts{{"frictionless rubber steel", 1}}));
}

/// The resumed run has counts of its own, so that any warning in it would be seen.
TEST_F(UnnamedPairs, AreNotWarnedOfAgainInAResumedRun) {
  Simulation run(scene_, 1, warnings_);
  for (int k = 0; k < 3; ++k) run.step();
  State state;
  run.save(StateWriter(state));
  WarningCounts of_the_rest{make_logger("off", "")};
  Simulation rest(scene_, 1, of_the_rest);
  rest.restore(StateReader(state));
  for (int k = 0; k < 3; ++k) EXPECT_GT(rest.step().contacts, 0);
  EXPECT_EQ(of_pairs(of_the_rest), Counts{});
}

}  // namespace unnamed_pairs_test
