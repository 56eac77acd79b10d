#pragma once
/// A whole scene that a test steps.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/geometry/mesh.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/support/scratch_folder.h"

namespace nilas::test {

struct SceneRig {
  /// `inside`: the content of <scene>. The folder holds a hull box.stl of 2 m x 1 m x 0.5 m about its frame's origin.
  explicit SceneRig(const std::string& inside, int threads = 1)
      : scene(read_scene(write(inside))), simulation(scene, threads, warnings) {}

  /// One step whose momenta balance, joints included, to `share` of their scales and `rounding` [N s, N m s].
  StepRecord balanced_step(double share, double rounding) {
    StepRecord record = simulation.step();
    EXPECT_LE(record.momentum_imbalance, share * record.momentum_scale + rounding);
    EXPECT_LE(record.angular_momentum_imbalance, share * record.angular_momentum_scale + rounding);
    return record;
  }
  const Bodies& bodies() const { return simulation.bodies(); }

  ScratchFolder folder;
  Scene scene;
  WarningCounts warnings{make_logger("off", "")};
  Simulation simulation;

 private:
  std::filesystem::path write(const std::string& inside) const {
    write_stl(box_shape(Vec3(2, 1, 0.5)).surface, folder / "box.stl");
    return folder.write("scene.xml", "<scene version='1'>" + inside + "</scene>");
  }
};

/// The energy account of the run so far closes to `share` of its energies and 1 J.
inline void expect_energy_kept(const StepRecord& record, double share) {
  const Ledger& energy = record.ledger;
  EXPECT_LE(std::abs(energy.imbalance), share * (1 + energy.kinetic + std::abs(energy.potential)));
}

/// A scene of a vessel with joints or rods. Its steps must balance their momenta and close their energy ledger.
struct JointedSceneRig : SceneRig {
  using SceneRig::SceneRig;
  StepRecord step() {
    const StepRecord record = balanced_step(1e-11, 1e-13);
    expect_energy_kept(record, 1e-9);
    return record;
  }
  StepRecord run(int steps) {
    StepRecord record;
    for (int k = 0; k < steps; ++k) record = step();
    return record;
  }
};

}  // namespace nilas::test
