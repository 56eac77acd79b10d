/// A simulation counts steps and time beyond 2^31 steps as it does at the start.
#include <gtest/gtest.h>

#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/support/scratch_folder.h"

namespace many_steps_test {

using namespace nilas;
using namespace nilas::sim;

constexpr double k_start = 2, k_step = 0.01;
constexpr std::int64_t k_many = 3'000'000'000;  // more than 2^31

/// Boxes that slide and tip on a floor. Nothing depends on the time itself.
constexpr const char* k_scene =
    "<scene version='1'><time step='0.01' start='2' end='1e9'/>"
    "<contact law='coulomb' solver='auto' tolerance='1e-8'><friction between='* *' kinetic='0.3'/></contact>"
    "<body name='floor' shape='plane'/>"
    "<body shape='box' size='0.4 0.3 0.2' mass='2' position='0 0 0.1' velocity='1 0.2 0'/>"
    "<body shape='box' size='0.3 0.3 0.3' mass='1' position='0.05 0.02 0.45' rotation_deg='33 20 0'/></scene>";

TEST(ManySteps, AreCountedBeyondTwoToThe31) {
  const test::ScratchFolder folder;
  const scene::Scene scene = scene::read_scene(folder.write("scene.xml", k_scene));
  WarningCounts warnings(make_logger("off", ""));
  Simulation young(scene, 1, warnings), old(scene, 1, warnings);
  for (int n = 0; n < 5; ++n) young.step();
  State state;
  young.save(StateWriter(state));
  std::get<std::vector<std::int64_t>>(state.entries.at("steps")).at(0) = k_many;
  old.restore(StateReader(state));
  EXPECT_EQ(old.steps(), k_many);
  for (std::int64_t n = 1; n <= 20; ++n) {
    const StepRecord a = young.step(), b = old.step();
    EXPECT_EQ(b.step, k_many + n);
    EXPECT_EQ(b.t, k_start + static_cast<double>(k_many + n) * k_step);
    EXPECT_EQ(b.contacts, a.contacts);
    for (int k = 0; k < young.bodies().size(); ++k) EXPECT_EQ(old.bodies().p_GB[k], young.bodies().p_GB[k]) << n;
  }
}

}  // namespace many_steps_test
