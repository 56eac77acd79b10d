#pragma once
/// A whole scene that a test steps.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include "core/geometry/mesh.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/support/scratch_folder.h"

namespace nilas::test {

/// A number as the attribute of an element, to the last bit.
inline std::string text(double x) {
  std::ostringstream out;
  out.precision(17);
  out << x;
  return out.str();
}

/// The <time> of a scene with steps of `step` [s]; it ends after all that tests run.
inline std::string steps_of(double step) { return "<time step='" + std::to_string(step) + "' end='1000'/>"; }

/// Coulomb's law, solved by newton to 1e-12 m/s.
inline std::string newton_contact(const std::string& integrator, double friction, double restitution = 0,
                                  const std::string& stabilisation = "projection") {
  const std::string mu = std::to_string(friction);
  return "<contact law='coulomb' solver='newton' tolerance='1e-12' stabilisation='" + stabilisation + "' integrator='" +
         integrator + "'><friction between='* *' static='" + mu + "' kinetic='" + mu + "' restitution='" +
         std::to_string(restitution) + "'/></contact>";
}

/// A vessel whose hull is the box of SceneRig, with its other attributes, its mass [kg] and further elements.
inline std::string box_vessel(const std::string& attributes, const std::string& inside, double mass = 1000) {
  return "<vessel name='hull' hull='box.stl' " + attributes + "><mass value='" + std::to_string(mass) + "'/>" + inside +
         "</vessel>";
}

inline const std::string k_no_weight = "<gravity value='0 0 0'/>";

struct SceneRig {
  using Files = std::map<std::string, std::string>;  ///< Texts by the names of their files.

  /// `inside` is the content of <scene>. The scene's folder holds the files, and a hull box.stl of 2 m x 1 m x 0.5 m
  /// about its frame's origin.
  explicit SceneRig(const std::string& inside, int threads = 1, const Files& files = {})
      : scene(scene::read_scene(write(inside, files))), simulation(scene, threads, warnings) {}

  /// One step whose momenta balance, joints included, to `share` of their scales and `rounding` [N s, N m s].
  sim::StepRecord balanced_step(double share, double rounding) {
    sim::StepRecord record = simulation.step();
    EXPECT_LE(record.momentum_imbalance, share * record.momentum_scale + rounding);
    EXPECT_LE(record.angular_momentum_imbalance, share * record.angular_momentum_scale + rounding);
    return record;
  }
  const bodies::Bodies& bodies() const { return simulation.bodies(); }

  ScratchFolder folder;
  scene::Scene scene;
  WarningCounts warnings{make_logger("off", "")};
  sim::Simulation simulation;

 private:
  std::filesystem::path write(const std::string& inside, const Files& files) const {
    geometry::write_stl(geometry::box_shape(Vec3(2, 1, 0.5)).surface, folder / "box.stl");
    for (const auto& [name, content] : files) folder.write(name, content);
    return folder.write("scene.xml", "<scene version='1'>" + inside + "</scene>");
  }
};

/// The energy account of the run so far closes to `share` of its energies and 1 J.
inline void expect_energy_kept(const sim::StepRecord& record, double share) {
  const sim::Ledger& energy = record.ledger;
  EXPECT_LE(std::abs(energy.imbalance), share * (1 + energy.kinetic + std::abs(energy.potential)));
}

/// A scene of a vessel with joints or rods. Its steps must balance their momenta and close their energy ledger.
struct JointedSceneRig : SceneRig {
  using SceneRig::SceneRig;
  sim::StepRecord step() {
    const sim::StepRecord record = balanced_step(1e-11, 1e-13);
    expect_energy_kept(record, 1e-9);
    return record;
  }
  sim::StepRecord run(int steps) {
    sim::StepRecord record;
    for (int k = 0; k < steps; ++k) record = step();
    return record;
  }
};

}  // namespace nilas::test
