#include "fracture/bend/weakest_sections.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/math.h"

namespace nilas::fracture {
namespace weakest_sections_test {

/// Four wedges above the origin, breaking at 2 m where all ice is alike.
const WedgeFan k_fan{{0, 0}, k_pi / 2, 4, k_pi / 4, 2, 2};
constexpr double k_loaded = 0.2, k_strength = 4e4;

double stress(double at) { return wedge_curvatures(TipLoad::pressure, k_loaded, {at}).front(); }

TEST(WeakestSections, CurvatureIsLargestAtOne) {
  EXPECT_NEAR(stress(1), 1, 1e-12);
  for (const double at : {0.99, 1.01}) {
    EXPECT_LT(stress(at), 1);
    EXPECT_GT(stress(at), 0.999);
  }
  EXPECT_NEAR(stress(1e-3), 0, 1e-2) << "none at the free tip";
  EXPECT_THROW(wedge_curvatures(TipLoad::pressure, 0, {1.0}), ContractError);
}

/// The bending moment b0 x w'' is that of the forces from the tip on: twice differentiated, q - x w.
TEST(WeakestSections, CurvaturesObeyTheWedgesEquation) {
  const double a = 0.2, x_max = solve_wedge(TipLoad::pressure, a).x_max, step = 0.02;
  const auto moment = [&](double x) { return x * wedge_curvatures(TipLoad::pressure, a, {x / x_max}).front(); };
  // beyond the load (x w'')'' = -x w, so (1/x (x w'')'')'' = -w''
  const auto deflection = [&](double x) {
    return (moment(x + step) - 2 * moment(x) + moment(x - step)) / (step * step) / x;
  };
  for (const double x : {0.6, 1.0, 1.6}) {
    const double curvature = (deflection(x + step) - 2 * deflection(x) + deflection(x - step)) / (step * step);
    EXPECT_NEAR(curvature, -moment(x) / x, 5e-3) << x;
  }
}

TEST(WeakestSections, OfIceThatIsAlike) {
  LocalIce ice;
  ice.flexural_strength = [](const Vec2&) { return k_strength; };
  const WeakestSections sections = weakest_sections(k_fan, k_loaded, k_strength, ice);
  EXPECT_NEAR(sections.strength, 1, 1e-12);
  ASSERT_EQ(sections.radii.size(), 9u);
  for (const double radius : sections.radii) EXPECT_NEAR(radius, 2, 1e-12);
  ice.flexural_strength = [](const Vec2&) { return 0.5 * k_strength; };
  EXPECT_NEAR(weakest_sections(k_fan, k_loaded, k_strength, ice).strength, 0.5, 1e-12);
}

/// A line across the fan at the distance d: each wedge whose middle meets it there bears strength / stress at most.
TEST(WeakestSections, BreakAlongAWeakLine) {
  for (const double d : {1.0, 1.5, 2.5}) {
    LocalIce ice;
    ice.weak_lines = {{{{-20, d}, {20, d}}, 0.4}};
    const WeakestSections sections = weakest_sections(k_fan, k_loaded, k_strength, ice);
    double expected = 0;
    for (int k = 0; k < 9; ++k) {
      const double away = std::abs(ray_angle(k_fan, k) - k_pi / 2), distance = d / std::cos(away);
      const bool near = away < 1.5 && distance < 6;
      const double bears = near ? std::min(1.0, 0.4 / stress(distance / 2)) : 1;
      EXPECT_NEAR(sections.radii[std::size_t(k)], bears < 1 ? distance : 2, 1e-9) << d << ", ray " << k;
      if (k % 2 == 1) expected += bears / 4;
    }
    EXPECT_NEAR(sections.strength, expected, 1e-12) << d;
    EXPECT_LT(sections.strength, 1);
  }
}

TEST(WeakestSections, Mirror) {
  LocalIce left, right;
  left.flexural_strength = [](const Vec2& x) { return k_strength * (1 + 0.3 * std::sin(3 * x.x() + x.y())); };
  right.flexural_strength = [](const Vec2& x) { return k_strength * (1 + 0.3 * std::sin(-3 * x.x() + x.y())); };
  const WeakestSections a = weakest_sections(k_fan, k_loaded, k_strength, left);
  const WeakestSections b = weakest_sections(k_fan, k_loaded, k_strength, right);
  EXPECT_NEAR(a.strength, b.strength, 1e-12);
  for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(a.radii[k], b.radii[8 - k], 1e-12);
}

}  // namespace weakest_sections_test
}  // namespace nilas::fracture
