/// Steps that are halved while a vessel moves: thin plates that fly at a thin
/// hull, on a carriage or free.
#include <gtest/gtest.h>

#include <string>

#include "core/base/error.h"
#include "core/geometry/mesh.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/support/collision/thin_plates.h"
#include "tests/support/scratch_folder.h"

namespace swept_vessel_test {

using namespace nilas;
using namespace nilas::sim;

/// Supports of the hull, which is 4 mm thick across x and 2 m wide and has a mass of 500 kg.
const std::vector<std::string> k_vessels{"<carriage speed='0.5'><force_balance kind='rigid'/></carriage>",
                                         "<carriage speed='0.5' ramp='0.02' free='heave pitch' joint='0 0 0.3'/>",
                                         "<carriage speed='0.5' ramp='0.02' free='heave'><force_balance "
                                         "kind='six-cells' stiffness='1e7' damping='1e4'/>"
                                         "</carriage>",
                                         "",
                                         "<carriage speed='0.5' free='yaw'/><part name='flap' joint='hinge' axis='0 "
                                         "1 0' at='0 0 1.1' position='0 0 1.6' "
                                         "size='0.1 1 1' mass='20' stiffness='100' damping='1' rate_deg='40'/>"};

std::string scene(const plates::Flight& f, const std::string& integrator, const std::string& vessel) {
  const Vec3 ypr = f.q.toRotationMatrix().eulerAngles(2, 1, 0) * 180 / k_pi;
  return "<scene version='1'><time step='0.01' end='1'/><gravity value='0 0 "
         "0'/><contact solver='newton' "
         "tolerance='1e-10' integrator='" +
         integrator +
         "'><friction between='* *' kinetic='0.1'/></contact>"
         "<vessel name='hull' hull='hull.stl' position='0 0 0'><mass "
         "value='500' inertia='400 200 200 0 0 0'/>" +
         vessel + "</vessel>" +
         fmt::format(
             "<body name='plate' shape='box' size='0.3 0.2 {}' mass='1' "
             "position='{} {} {}' rotation_deg='{} {} "
             "{}' velocity='{} {} {}' angular_velocity='{} {} {}'/></scene>",
             plates::k_thickness, f.p.x(), f.p.y(), f.p.z(), ypr.x(), ypr.y(), ypr.z(), f.v.x(), f.v.y(), f.v.z(),
             f.w.x(), f.w.y(), f.w.z());
}

struct Tally {
  int passed = 0, refused = 0, parts = 0;
  long warnings = 0;
};

void fly(const test::ScratchFolder& folder, const std::string& text, Tally& tally) {
  WarningCounts warnings{make_logger("off", "")};
  Simulation simulation(scene::read_scene(folder.write("scene.xml", text)), 1, warnings);
  const bodies::Bodies& bodies = simulation.bodies();
  const auto plate = static_cast<std::size_t>(bodies.size() - 1);
  try {
    for (int step = 0; step < 4; ++step) {
      const StepRecord record = simulation.step();
      tally.parts += record.parts;
      double scale = record.ledger.kinetic + record.ledger.impact;
      for (const double work : record.ledger.works) scale += std::abs(work);
      EXPECT_LE(std::abs(record.ledger.imbalance), 1e-10 * scale);
      EXPECT_LE(record.momentum_imbalance, 1e-10 * (record.momentum_scale + 100));
      EXPECT_LE(record.angular_momentum_imbalance, 1e-10 * (record.angular_momentum_scale + 100));
    }
  } catch (const SimulationError& error) {
    ++tally.refused;
    return;
  }
  const Vec3 p = bodies.R_GB[0].transpose() * (bodies.p_GB[plate] - bodies.p_GB[0]);
  tally.passed += p.x() > 0 && p.tail<2>().cwiseAbs().maxCoeff() < plates::k_half_target;
  for (const auto& [what, count] : warnings.counts())
    tally.warnings += what.starts_with("steps with impacts") ? count : 0;
}

TEST(SweptVessel, ThinPlatesDoNotPassAHullThatMoves) {
  const test::ScratchFolder folder;
  geometry::write_stl(geometry::box_shape(Vec3(plates::k_thickness, 2, 2)).surface, folder / "hull.stl");
  for (const std::string integrator : {"semi-implicit-euler", "moreau"})
    for (const std::string& vessel : k_vessels) {
      SCOPED_TRACE(integrator + " " + vessel);
      RandomStream random(28, "thin plates");
      Tally tally;
      for (int k = 0; k < 40; ++k) fly(folder, scene(plates::draw(random), integrator, vessel), tally);
      EXPECT_EQ(tally.passed, 0);
      EXPECT_EQ(tally.refused, 0);
      EXPECT_EQ(tally.warnings, 0);
      EXPECT_GT(tally.parts, 40 * 4);  // some of the steps are halved
    }
}

}  // namespace swept_vessel_test
