/// The pre-sawn scenes on two hull meshes: pieces do not penetrate hull or sheets, and the load does not depend on the
/// mesh. `./dev bench presawn` does the same up to the scenes' ends, with perturbed runs.
#include "tests/support/presawn.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace presawn_test {

using namespace nilas;

struct Outcome {
  double penetration = 0;             ///< Largest penetration by the contact search [m].
  double in_hull = 0, in_sheets = 0;  ///< Largest depths by the oracle [m].
  double load = 0;                    ///< Mean force along X from the first contact on [N].
};

Outcome outcome(char letter, int triangles, double until, double look_every) {
  const scene::Scene scene = test::presawn(letter, 0, 0, triangles);
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(scene, 1, warnings);
  const test::PresawnOverlap overlap(simulation);
  const auto look = static_cast<long>(std::lround(look_every / scene.time.step));
  Outcome out;
  long loaded = 0;
  while (simulation.time() < until - 0.5 * scene.time.step) {
    const sim::StepRecord record = simulation.step();
    out.penetration = std::max(out.penetration, record.penetration_max);
    if (loaded > 0 || !record.vessel->contact.force.isZero(0)) ++loaded, out.load += record.vessel->contact.force.x();
    if (record.step % look != 0) continue;
    const auto depth = overlap.measure();
    out.in_hull = std::max(out.in_hull, depth.hull);
    out.in_sheets = std::max(out.in_sheets, depth.sheets);
  }
  out.load /= static_cast<double>(std::max(loaded, 1L));
  return out;
}

struct Case {
  char letter;
  int triangles, other_triangles;
  double until;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.letter; }

class Presawn : public ::testing::TestWithParam<Case> {};

TEST_P(Presawn, NothingPenetratesAndTheMeshDoesNotMatter) {
  const auto& [letter, triangles, other, until] = GetParam();
  constexpr double k_thickness = 0.04, k_look_every = 0.05;
  const Outcome own = outcome(letter, triangles, until, k_look_every);
  const Outcome twin = outcome(letter, other, until, until);
  std::printf(
      "  %c to %g s: penetration %.2f %%, in the hull %.2f %%, in the sheets %.2f %% of the thickness; mean load "
      "%.3f N on %d triangles, %.3f N on %d\n",
      letter, until, 100 * own.penetration / k_thickness, 100 * own.in_hull / k_thickness,
      100 * own.in_sheets / k_thickness, own.load, triangles, twin.load, other);
  EXPECT_LT(own.penetration, 0.01 * k_thickness);
  EXPECT_LT(own.in_hull, 0.01 * k_thickness);
  EXPECT_LT(own.in_sheets, 0.01 * k_thickness);
  EXPECT_LT(own.load, -1) << "the pieces never met the hull";
  EXPECT_NEAR(own.load, twin.load, 0.05 * std::abs(own.load));
}

INSTANTIATE_TEST_SUITE_P(Cases, Presawn,
                         ::testing::Values(Case{'a', 6000, 18000, 4.5}, Case{'b', 6000, 18000, 3.5},
                                           Case{'c', 18000, 6000, 4.0}),
                         [](const auto& instance) { return std::string(1, instance.param.letter); });

/// The oracle itself is compared with all axes of plain brute force over random poses.
TEST(PresawnOverlap, AgreesWithAllAxes) {
  const geometry::Shape shape = geometry::box_shape({2, 0.7, 0.9});
  const test::ConvexOracle hull(shape.surface, Mat3::Identity(), Vec3::Zero());
  const oracle::Solid same = oracle::posed(shape.parts[0], Mat3::Identity(), Vec3::Zero());
  RandomStream random(3, "poses");
  const auto number = [&] { return random.uniform(-1, 1); };
  int overlapping = 0;
  for (int k = 0; k < 300; ++k) {
    const Quat q = Quat(number(), number(), number(), number()).normalized();
    const Vec3 at(1.2 * number(), 0.6 * number(), 0.7 * number());
    const oracle::Solid piece = oracle::posed(geometry::make_box({0.5, 0.4, 0.1}), q.toRotationMatrix(), at);
    const double exact = oracle::all_axes(same, piece).front().s;
    if (exact >= 0) continue;
    ++overlapping;
    EXPECT_NEAR(hull.separation(piece), exact, 1e-12);
  }
  EXPECT_GT(overlapping, 100);
}

}  // namespace presawn_test
