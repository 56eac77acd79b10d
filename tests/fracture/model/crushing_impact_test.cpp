/// Impacts of bodies that ice brings to rest, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/core/sim/crushing_rig.h"

namespace crushing_impact_test {

using namespace nilas;
using namespace nilas::fracture;
using namespace nilas::test;

/// A free body of mass 5000 kg at 1 m/s into a fixed sheet.
struct Impact {
  double depth = 0, force = 0, left = 0;  ///< largest; and the speed after it, positive on
  int steps = 0;                          ///< Steps until 20 steps after it came to rest.
};

Impact impact(const std::string& mesh, const std::string& model, double h, const std::string& integrator,
              double strength = k_strength, double speed = 1) {
  const double mass = 5000, gap = 1e-3;
  const std::string content = "<body shape='mesh' mesh='" + mesh + "' mass='" + text(mass) + "' position='" +
                              text(-gap) + " 0 0' velocity='" + text(speed) + " 0 0'/><ice thickness='" +
                              text(mesh == "pyramid.stl" ? 4.0 : k_thickness) +
                              "'><floe fixed='true' breakable='true' outline='0 -3 4 -3 4 3 0 3'/></ice>";
  Rig rig(content + crushing(model, strength), h, 1, "integrator='" + integrator + "'");
  const std::size_t body = rig.hull();
  Impact found;
  constexpr int k_after = 20;  // steps at rest
  for (int rest = 0; rest < k_after;) {
    const double before = rig.bodies().v_GB[body].x();
    rig.step();
    found.left = rig.bodies().v_GB[body].x();
    found.depth = std::max(found.depth, rig.front(body));
    found.force = std::max(found.force, mass * (before - found.left) / h);
    rest += std::abs(found.left) < 1e-8 ? 1 : 0;
    ++found.steps;
  }
  return found;
}

struct ImpactCase {
  std::string mesh, model;
  double depth, force;  ///< closed form
};

/// 1/2 M v^2 = int F d(delta) with F = k delta^q.
ImpactCase closed_form(const std::string& mesh, const std::string& model, double k, double q) {
  const double depth = std::pow((q + 1) * 5000 / (2 * k), 1 / (q + 1));
  return {mesh, model, depth, k * std::pow(depth, q)};
}

std::vector<ImpactCase> impact_cases() {
  const double c = 1e5, ex = -0.1, slant = std::sqrt(5.0);
  const std::string pressure_area = "model='pressure-area' coefficient='1e5' exponent='-0.1'";
  return {closed_form("wedge.stl", k_seed, k_strength * k_thickness, 1),
          closed_form("wedge.stl", k_compliant, k_strength * k_thickness, 1),
          closed_form("pyramid.stl", k_compliant, k_strength, 2),
          closed_form("wedge.stl", pressure_area, c * std::pow(slant * k_thickness, ex) * k_thickness, 1 + ex),
          closed_form("pyramid.stl", pressure_area, c * std::pow(slant, ex), 2 + 2 * ex)};
}

/// Popov's collision: depth and force converge with the first order in the step, from 1e-4 to 0.05 s.
TEST(Crushing, ImpactConvergesToPopovsClosedForm) {
  for (const ImpactCase& one : impact_cases()) {
    const double duration = 1.5 * one.depth;  // at 1 m/s
    for (const double h : {0.05, 0.01, 0.001, 1e-4}) {
      const Impact found = impact(one.mesh, one.model, h, "semi-implicit-euler");
      const double share = h / duration;
      const double depth_error = found.depth / one.depth - 1, force_error = found.force / one.force - 1;
      EXPECT_LE(std::abs(depth_error), 1.5 * share + 1e-7) << one.mesh << one.model << " step " << h;
      EXPECT_LE(std::abs(force_error), 2.5 * share + 1e-7) << one.mesh << one.model << " step " << h;
      EXPECT_NEAR(found.left, 0, 1e-12 * found.steps) << "crushing is plastic; 1e-12 is the solver's tolerance";
    }
  }
}

/// Ice so strong that the impact lasts a hundredth of the step: it ends at rest at once, without rebound.
TEST(Crushing, IsStableAtAnyStep) {
  for (const std::string& model : {k_seed, k_compliant}) {
    const Impact found = impact("wedge.stl", model, 0.05, "semi-implicit-euler", 1e9);
    EXPECT_LE(found.steps, 23) << model;
    EXPECT_NEAR(found.left, 0, 1e-12 * found.steps) << model;
    EXPECT_LE(found.depth, 0.05) << "no further than the way of one step";
    const double exact = std::sqrt(5000 / (1e9 * k_thickness));
    EXPECT_LE(found.depth, model == k_compliant ? exact : 1) << "implicit: no deeper than in continuous time";
  }
}

/// Continuous detection follows pairs as fast as these; the ice is crushed all the same.
TEST(Crushing, IsThatOfFastBodiesToo) {
  const double strength = 1e7, speed = 20, exact = speed * std::sqrt(5000 / (strength * k_thickness));
  for (const std::string& model : {k_seed, k_compliant}) {
    const Impact found = impact("wedge.stl", model, 0.01, "semi-implicit-euler", strength, speed);
    EXPECT_NEAR(found.depth, exact, 0.25 * exact) << model << ": a step is a seventh of the impact";
  }
}

/// A pile: the width of the contact is the chord of its facets.
TEST(Crushing, OfACylinder) {
  Rig rig(
      "<body name='pile' shape='cylinder' radius='0.5' height='2' mass='5000' position='-0.501 0 0' "
      "velocity='1 0 0'/><ice thickness='0.25'><floe fixed='true' breakable='true' outline='0 -3 4 -3 4 3 0 "
      "3'/></ice>" +
          crushing(k_seed),
      1e-3);
  double depth = 0, worst = 0;
  for (int k = 0; k < 500; ++k) {
    depth = std::max(0.0, rig.bodies().p_GB[rig.hull()].x() + 0.5);
    const double before = rig.bodies().v_GB[rig.hull()].x();
    rig.step();
    const double now = rig.bodies().v_GB[rig.hull()].x(), force = 5000 * (before - now) / 1e-3;
    const double expected = k_strength * k_thickness * 2 * std::sqrt(depth * (1 - depth));
    if (now > 0.01 && depth > 0.05) worst = std::max(worst, std::abs(force / expected - 1));
  }
  EXPECT_GT(depth, 0.15);
  EXPECT_LT(worst, 5e-3) << "64 facets";
}

TEST(Crushing, ImpactWithTheMidpointRule) {
  for (const ImpactCase& one : impact_cases()) {
    const Impact found = impact(one.mesh, one.model, 1e-3, "moreau");
    EXPECT_NEAR(found.depth, one.depth, 5e-3 * one.depth) << one.mesh << one.model;
    EXPECT_NEAR(found.force, one.force, 5e-3 * one.force);
    EXPECT_NEAR(found.left, 0, 1e-12 * found.steps);
  }
}

}  // namespace crushing_impact_test
