/// Tests of the candidate pairs of the tree of boxes.
#include "contact/detect/broad/broad_phase.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/state.h"
#include "tests/contact/detect/bodies_of_tests.h"

namespace nilas::detect {
namespace broad_phase_test {

/// Floes beside and over each other, every seventh of them fixed.
bodies::Bodies bodies_in_a_square(int count, double side) {
  RandomStream random(11, "square");
  bodies::Bodies bodies;
  for (int b = 0; b < count; ++b)
    add_body(bodies, floe_shape(random_outline(random, 0.5), 0.1),
             Vec3(random.uniform(0, side), random.uniform(0, side), random.uniform(-0.1, 0.1)),
             random_tilt(random, 0.1), b % 7 == 3 ? bodies::Motion::fixed : bodies::Motion::free);
  return bodies;
}

std::vector<Part> parts_of(const bodies::Bodies& bodies) {
  std::vector<Part> parts;
  for (int b = 0; b < bodies.size(); ++b)
    for (Part& part : make_parts(bodies, b)) parts.push_back(std::move(part));
  return parts;
}

/// All overlapping pairs of boxes of the tree, by comparison of every two.
std::vector<PartPair> overlaps(const bodies::Bodies& bodies, const BroadPhase& broad, std::size_t count) {
  State state;
  broad.save(StateWriter(state));
  std::vector<Vec3> low, high;
  StateReader(state).get("low", low, count);
  StateReader(state).get("high", high, count);
  std::vector<PartPair> pairs;
  for (int a = 0; a < bodies.size(); ++a)
    for (int b = a + 1; b < bodies.size(); ++b)
      if ((low[a].array() <= high[b].array()).all() && (low[b].array() <= high[a].array()).all() &&
          (bodies.is_free(a) || bodies.is_free(b)))
        pairs.push_back({a, b, a, b});
  return pairs;
}

std::vector<PartPair> candidates(BroadPhase& broad, const bodies::Bodies& bodies, const std::vector<Part>& parts,
                                 int threads) {
  std::vector<PartPair> pairs;
  broad.list_pairs(bodies, parts, 0.01, threads, pairs);
  return pairs;
}

TEST(BroadPhase, GivesAllOverlapsOfItsBoxesForAnyNumberOfThreads) {
  for (const int count : {1, 2, 40, 700}) {
    bodies::Bodies bodies = bodies_in_a_square(count, 0.8 * std::sqrt(count));
    const std::vector<Part> parts = parts_of(bodies);
    BroadPhase one, two, five;
    std::size_t found = 0;
    for (int step = 0; step < 12; ++step) {
      for (int b = 0; b < count; ++b)
        if (bodies.is_free(b))
          bodies.set_pose(b, bodies.p_GB[b] + 0.02 * Vec3(std::cos(b), std::sin(b), 0.1 * std::sin(b)), bodies.q_GB[b]);
      const std::vector<PartPair> pairs = candidates(one, bodies, parts, 1);
      EXPECT_EQ(candidates(two, bodies, parts, 2), pairs);
      EXPECT_EQ(candidates(five, bodies, parts, 5), pairs);
      EXPECT_EQ(overlaps(bodies, one, parts.size()), pairs);
      found += pairs.size();
    }
    EXPECT_GE(found, static_cast<std::size_t>(count > 2 ? count : 0)) << count;
  }
}

/// Most boxes stay from step to step here. One body of each kind is fixed or freed on the way.
TEST(BroadPhase, KeepsThePairsOfBoxesThatStayAndGivesThoseOfOthers) {
  constexpr int k_count = 300, k_freed = 3, k_stopped = 5;
  bodies::Bodies bodies = bodies_in_a_square(k_count, 0.7 * std::sqrt(k_count));
  const std::vector<Part> parts = parts_of(bodies);
  BroadPhase broad;
  std::vector<PartPair> before;
  int changes = 0;
  for (int step = 0; step < 60; ++step) {
    if (step == 20) bodies.motion[k_freed] = bodies::Motion::free;
    if (step == 40) bodies.motion[k_stopped] = bodies::Motion::fixed;
    for (int b = step % 25; b < k_count; b += 25)
      if (bodies.is_free(b))
        bodies.set_pose(b, bodies.p_GB[b] + 0.1 * Vec3(std::cos(step), std::sin(b), 0), bodies.q_GB[b]);
    const std::vector<PartPair> pairs = candidates(broad, bodies, parts, 1 + step % 2);
    EXPECT_EQ(overlaps(bodies, broad, parts.size()), pairs) << step;
    changes += pairs != before ? 1 : 0;
    before = pairs;
  }
  EXPECT_GT(changes, 30);
}

TEST(BroadPhase, NoBodies) {
  for (const int threads : {1, 2}) {
    BroadPhase broad;
    EXPECT_TRUE(candidates(broad, bodies::Bodies(), {}, threads).empty());
  }
}

}  // namespace broad_phase_test
}  // namespace nilas::detect
