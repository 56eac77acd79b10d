/// A step that is halved leaves no trace of the search that it was given up after: ice that only that search saw
/// crushed still stands.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/core/sim/crushing_rig.h"
#include "tests/support/collision/thin_plates.h"

namespace crushing_halved_test {

using namespace nilas;
using namespace nilas::fracture;
using namespace nilas::test;

constexpr double k_step = 0.01, k_mass = 0.02, k_speed = 2;

/// A free wedge, so light that the sheet which it enters stops it at once, and far from it a thin plate that flies at
/// another.
std::string scene(const plates::Flight& f) {
  const Vec3 ypr = f.q.toRotationMatrix().eulerAngles(2, 1, 0) * 180 / k_pi;
  return fmt::format(
             "<body name='wedge' shape='mesh' mesh='wedge.stl' mass='{}' position='-1e-5 0 0' velocity='{} 0 0'/>"
             "<ice thickness='{}'><floe fixed='true' breakable='true' outline='0 -3 4 -3 4 3 0 3'/></ice>",
             k_mass, k_speed, k_thickness) +
         crushing(k_seed) +
         fmt::format(
             "<body shape='box' size='{} 2 2' position='0 20 0' fixed='true'/>"
             "<body shape='box' size='0.3 0.2 {}' mass='1' position='{:.17g} {:.17g} {:.17g}' "
             "rotation_deg='{:.17g} {:.17g} {:.17g}' velocity='{:.17g} {:.17g} {:.17g}' "
             "angular_velocity='{:.17g} {:.17g} {:.17g}'/>",
             plates::k_thickness, plates::k_thickness, f.p.x(), f.p.y() + 20, f.p.z(), ypr.x(), ypr.y(), ypr.z(),
             f.v.x(), f.v.y(), f.v.z(), f.w.x(), f.w.y(), f.w.z());
}

std::size_t wedge(const Rig& rig) {
  const auto& names = rig.bodies().name;
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), "wedge") - names.begin());
}

/// A whole step that is halved once, against two steps of half its length, of which none is.
TEST(CrushingHalved, AStepInTwoPartsIsTwoSteps) {
  // little moves before the impulses, so that steps are searched before they are halved
  const std::string moreau = "integrator='moreau' theta='0.9' detection='continuous'";
  RandomStream random(7, "halved");
  int compared = 0;
  for (int k = 0; k < 200 && compared < 4; ++k) {
    const std::string content = scene(plates::draw(random));
    Rig whole(content, k_step, 1, moreau);
    if (whole.step().parts != 2) continue;
    Rig halves(content, k_step / 2, 1, moreau);
    if (halves.step().parts != 1 || halves.step().parts != 1) continue;
    const std::size_t b = wedge(halves);
    const Vec3 &end = halves.bodies().p_GB[b], &speed = halves.bodies().v_GB[b];
    EXPECT_LT(speed.x(), 0.5 * k_speed) << "ice stops the wedge";
    EXPECT_NEAR((whole.bodies().p_GB[b] - end).norm(), 0, 1e-12);
    EXPECT_NEAR((whole.bodies().v_GB[b] - speed).norm(), 0, 1e-9);
    ++compared;
  }
  EXPECT_EQ(compared, 4);
}

}  // namespace crushing_halved_test
