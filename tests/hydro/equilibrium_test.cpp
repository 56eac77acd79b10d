#include "hydro/equilibrium.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "hydro/wetted.h"
#include "tests/hydro/solids.h"

namespace nilas::water_test {

namespace {

Water sea() {
  Water water;
  water.level = 1.5;
  return water;
}

/// A box floats at draught d = T rho_b / rho_w: freshwater ice 917 in 1025 at 0.894634 of its thickness.
TEST(FloatingHeight, Box) {
  const double T = 0.8, mass = 917 * 3 * 2 * T;
  const double z = floating_height(box_shape({3, 2, T}).surface, Mat3::Identity(), mass, sea());
  EXPECT_NEAR(z, 1.5 + 0.5 * T - T * 917 / 1025, 1e-12);
}

/// Cone-like corner, apex down: V = h^3 times its constant, so h = (m / (rho k))^(1/3).
TEST(FloatingHeight, PyramidApexDown) {
  const TriangleMesh mesh = tetrahedron({0, 0, 0}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1});  // base area 2 at height 1
  const double mass = 100;
  const double z = floating_height(mesh, Mat3::Identity(), mass, sea());
  EXPECT_NEAR(1.5 - z, std::cbrt(mass / (1025 * 2.0 / 3)), 1e-12);
}

TEST(FloatingHeight, BalancesEveryMassAndAttitude) {
  for (const Solid& solid : solids()) {
    const double volume = mesh_properties(solid.mesh, 1).mass;
    // A plate at 1e3 m from its origin has its heights to 1e-13 m only: 1e-11 of its thickness.
    const double balance = solid.name == "thin plate far from its origin" ? 1e-10 : 1e-12;
    RandomStream random(8, solid.name);
    for (int k = 0; k < 30; ++k) {
      const Mat3 R = k == 0 ? Mat3::Identity() : random_attitude(random).toRotationMatrix();
      const double mass = 1025 * volume * random.uniform(0.001, 0.999);
      const double z = floating_height(solid.mesh, R, mass, sea());
      EXPECT_NEAR(1025 * submerged_mesh(solid.mesh, R, {0, 0, z}, 1.5).volume, mass, balance * mass) << solid.name;
    }
  }
}

TEST(FloatingHeight, JustAfloatAndSinking) {
  const TriangleMesh box = box_shape({1, 1, 1}).surface;
  EXPECT_NEAR(floating_height(box, Mat3::Identity(), 1025, sea()), 1.0, 1e-12);
  EXPECT_THROW(floating_height(box, Mat3::Identity(), 1026, sea()), InputError);
  EXPECT_THROW(floating_height(box, Mat3::Identity(), 0, sea()), InputError);
  EXPECT_THROW(floating_height({}, Mat3::Identity(), 1, sea()), InputError);
}

}  // namespace

}  // namespace nilas::water_test
