/// The pre-sawn scenes are mirror-symmetric and chaotic, so that rounding grows. The tests check that they are built as
/// their own images, and stay so where rounding is the same on the two sides. Otherwise the loss of symmetry of
/// presawn-a is compared with the growth of a perturbation of 1e-12 m. Port and starboard loads must agree on average.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "tests/support/mirror_images.h"
#include "tests/support/mirrored.h"
#include "tests/support/presawn.h"

namespace presawn_symmetry_test {

using namespace nilas;

constexpr double k_end = 6, k_perturbation = 1e-12;
constexpr int k_seeds = 8;

struct Course {
  std::vector<double> asymmetry;  ///< Largest |y_left + y_right|, |x_left - x_right| so far, at whole seconds [m].
  std::vector<std::vector<Vec3>> poses;  ///< Positions of centres at whole seconds [m].
  double port = 0, starboard = 0;        ///< Mean forces along X on the two sides of the hull [N].
};

/// Pairs of mirror images. Free floes come in the grid's order; the image of each is found from the initial positions.
std::vector<std::pair<std::size_t, std::size_t>> mirror_pairs(const bodies::Bodies& bodies) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < bodies.p_GB.size(); ++a)
    for (std::size_t b = 0; b < bodies.p_GB.size(); ++b) {
      if (bodies.motion[a] != bodies::Motion::free || bodies.motion[b] != bodies::Motion::free ||
          bodies.p_GB[a].y() <= 0)
        continue;
      if ((bodies.p_GB[a] - test::mirrored(bodies.p_GB[b])).norm() < 1e-9) pairs.emplace_back(a, b);
    }
  return pairs;
}

Course run(std::uint64_t seed) {
  const scene::Scene scene = test::presawn('a', seed, k_perturbation);
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(scene, 1, warnings);
  const auto pairs = mirror_pairs(simulation.bodies());
  EXPECT_FALSE(pairs.empty());
  Course course;
  const int per_second = static_cast<int>(std::lround(1 / scene.time.step)),
            steps = static_cast<int>(k_end) * per_second;
  double worst = 0;
  for (int k = 1; k <= steps; ++k) {
    const sim::StepRecord record = simulation.step();
    course.port += record.vessel->contact_port.x() / steps;
    course.starboard += record.vessel->contact_starboard.x() / steps;
    const auto& p = simulation.bodies().p_GB;
    for (const auto& [a, b] : pairs)
      worst = std::max({worst, std::abs(p[a].y() + p[b].y()), std::abs(p[a].x() - p[b].x())});
    if (k % per_second != 0) continue;
    course.asymmetry.push_back(worst);
    course.poses.push_back(p);
  }
  return course;
}

double distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, (a[i] - b[i]).norm());
  return worst;
}

TEST(PresawnSymmetry, PortAndStarboardLoadsAgreeOnAverage) {
  const Course exact = run(0);
  std::vector<Course> perturbed;
  for (int seed = 1; seed <= k_seeds; ++seed) perturbed.push_back(run(static_cast<std::uint64_t>(seed)));

  std::printf("  t [s]   asymmetry [m]   growth of 1e-12 m [m]\n");
  for (std::size_t s = 0; s < exact.asymmetry.size(); ++s)
    std::printf("  %5zu   %13.3e   %13.3e\n", s + 1, exact.asymmetry[s],
                distance(exact.poses[s], perturbed[0].poses[s]));

  double mean = 0, size = 0;
  for (const auto& c : perturbed) {
    mean += (c.port - c.starboard) / k_seeds;
    size += 0.5 * (std::abs(c.port) + std::abs(c.starboard)) / k_seeds;
  }
  double variance = 0;
  for (const auto& c : perturbed) variance += std::pow(c.port - c.starboard - mean, 2) / (k_seeds - 1);
  const double standard_error = std::sqrt(variance / k_seeds);
  std::printf("  port - starboard, mean over %d seeds: %.4g N of %.4g N, standard error %.2g N\n", k_seeds, mean, size,
              standard_error);
  ASSERT_GT(size, 0) << "the pieces never met the hull";
  EXPECT_LE(std::abs(mean), std::max(0.05 * size, 3 * standard_error));
}

/// A case that ends early to keep the test short. bench_presawn_symmetry runs to the ends of the scenes.
struct Exact {
  char letter;
  double end;  ///< End of the run [s].
};
class PresawnImages : public testing::TestWithParam<Exact> {};
INSTANTIATE_TEST_SUITE_P(Cases, PresawnImages, testing::Values(Exact{'a', 5}, Exact{'b', 6}, Exact{'c', 5.5}),
                         [](const auto& one) { return std::string(1, one.param.letter); });

TEST_P(PresawnImages, StayImagesToTheLastBitWithoutRoundingInTheOrderOfContacts) {
  scene::Scene scene = test::shipped_presawn(GetParam().letter);
  scene.contact.solver = SolverName::newton_order_free;
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(scene, 1, warnings);
  const test::MirrorImages images(simulation.bodies());
  ASSERT_TRUE(images.paired());
  EXPECT_TRUE(images.built_as_images(simulation.bodies()));
  int across = 0;
  for (const long steps = std::lround(GetParam().end / scene.time.step); simulation.steps() < steps;) {
    const sim::StepRecord record = simulation.step();
    EXPECT_FALSE(record.solver_short) << record.t;
    EXPECT_TRUE(record.positions_corrected) << record.t;
    ASSERT_EQ(images.measure(simulation).first_stage(), "") << record.t;
    EXPECT_EQ(record.vessel->contact.force.y(), 0) << record.t;
    for (const detect::ContactPoint& c : simulation.last_problem().points) across += images.image(c.a) == c.b ? 1 : 0;
  }
  EXPECT_GT(across, 50) << "no pieces met across the plane";
}

}  // namespace presawn_symmetry_test
