/// Compares the three narrow phases: FCL as a first query changes no bit, and FCL's own contacts are an alternative
/// with a memory of its own.
#include <gtest/gtest.h>

#include "contact/detect/detector.h"
#include "tests/contact/detect/crowd.h"
#include "tests/support/collision/pair_judge.h"
#include "tests/support/random_vectors.h"

namespace nilas::detect {
namespace narrow_phases_test {

constexpr double k_margin = 0.01;

bodies::Bodies crowd_on_a_plane() {
  const auto floes = crowd(120, 5);
  bodies::Bodies bodies = bodies_of(floes, in_order(floes.size()));
  add_body(bodies, geometry::sphere_shape(0.4), Vec3(2, 2, 0.4));
  add_body(bodies, geometry::cylinder_shape(0.3, 0.5), Vec3(5, 5, 0.2));
  add_body(bodies, geometry::plane_shape(), Vec3(0, 0, -0.06), Quat::Identity(), bodies::Motion::fixed);
  return bodies;
}

TEST(NarrowPhases, FclInFrontChangesNoBit) {
  bodies::Bodies bodies = crowd_on_a_plane();
  ContactDetector in_front, alone(1, NarrowPhase::nilas_alone);
  DetectorCounts sum;
  for (int step = 0; step < 40; ++step) {
    drift(bodies, step);
    expect_same_bits(in_front.detect(bodies, k_margin), alone.detect(bodies, k_margin));
    EXPECT_EQ(alone.counts().by_fcl + alone.counts().corrected, 0);  // FCL is asked last, for a few round pairs.
    sum += in_front.counts();
  }
  EXPECT_GT(sum.by_fcl, 0);
  EXPECT_GT(sum.by_fcl, sum.corrected);  // The crowd has deep overlaps. Of ice in contact FCL settles nearly all pairs.
  EXPECT_EQ(sum.candidate_pairs,
            sum.cached_separations + sum.kept_axes + sum.by_fcl + sum.corrected + sum.searched + sum.closed_forms);
}

TEST(NarrowPhases, FclGoesOnAsItWasSavedOnAnyNumberOfThreads) {
  bodies::Bodies bodies = crowd_on_a_plane();
  ContactDetector whole(1, NarrowPhase::fcl), threaded(2, NarrowPhase::fcl);
  for (int step = 0; step < 10; ++step) {
    drift(bodies, step);
    expect_same_bits(whole.detect(bodies, k_margin), threaded.detect(bodies, k_margin));
  }
  State state;
  whole.save(StateWriter(state));
  ContactDetector rest(1, NarrowPhase::fcl);
  rest.restore(bodies, StateReader(state));
  for (int step = 10; step < 25; ++step) {
    drift(bodies, step);
    const auto points = whole.detect(bodies, k_margin);
    EXPECT_FALSE(points.empty());
    expect_same_bits(rest.detect(bodies, k_margin), points);
    expect_same_bits(threaded.detect(bodies, k_margin), points);
    EXPECT_EQ(whole.counts().kept_axes, 0);
  }
}

/// A box lies on another: the one point of FCL is completed to the four corners of the common area.
TEST(NarrowPhases, FclsPointIsCompletedToAManifold) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({1, 1, 0.2}), {0, 0, 0});
  add_body(bodies, geometry::box_shape({0.6, 0.4, 0.2}), {0.1, 0.05, 0.1995});
  const auto points = ContactDetector(1, NarrowPhase::fcl).detect(bodies, k_margin);
  ASSERT_GE(points.size(), 4u);
  Vec3 low = Vec3::Constant(9), high = Vec3::Constant(-9);
  for (const ContactPoint& c : points) {
    EXPECT_LT((c.n - Vec3::UnitZ()).norm(), 1e-9);
    EXPECT_NEAR(c.gap, -0.0005, 1e-9);
    low = low.cwiseMin(c.p);
    high = high.cwiseMax(c.p);
  }
  EXPECT_LT((low - Vec3(-0.2, -0.15, 0.09975)).norm(), 1e-6);
  EXPECT_LT((high - Vec3(0.4, 0.25, 0.09975)).norm(), 1e-6);
}

/// Gaps above a half space are those of the closed form, both for gaps below the margin and for overlaps.
TEST(NarrowPhases, FclAndThePlaneAgreeWithTheClosedForm) {
  RandomStream random(4, "plane");
  for (int k = 0; k < 200; ++k) {
    bodies::Bodies bodies;
    add_body(bodies, geometry::plane_shape(), Vec3::Zero(), Quat::Identity(), bodies::Motion::fixed);
    const geometry::Shape shape = k % 3 == 0   ? geometry::sphere_shape(0.5)
                                  : k % 3 == 1 ? geometry::box_shape({0.6, 0.4, 0.3})
                                               : geometry::cylinder_shape(0.3, 0.6);
    add_body(bodies, shape, {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(0.2, 0.55)},
             test::random_attitude(random));
    const auto exact = ContactDetector().detect(bodies, k_margin);
    const auto found = ContactDetector(1, NarrowPhase::fcl).detect(bodies, k_margin);
    ASSERT_EQ(exact.empty(), found.empty()) << k;
    if (exact.empty()) continue;
    EXPECT_NEAR(pairs::deepest_point(found)->gap, pairs::deepest_point(exact)->gap, 1e-9) << k;
    EXPECT_LT((pairs::deepest_point(found)->p - pairs::deepest_point(exact)->p).norm(), 1e-4) << k;
    EXPECT_LT((found.front().n - exact.front().n).norm(), 1e-12) << k;
  }
}

/// A plate is shifted by half a metre or less on an equal one, at a hundred positions. Where the plates lie deep in
/// each other, FCL separates them along the longer direction, sideways.
TEST(NarrowPhases, FclErrsInPlatesDeepInEachOther) {
  constexpr double k_thickness = 0.01;
  int wrong = 0;
  for (int x = 0; x < 10; ++x)
    for (int z = 0; z < 10; ++z) {
      const double aside = 0.05 * x, depth = k_thickness * (1 - 0.1 * (z + 0.5));
      bodies::Bodies bodies;
      add_body(bodies, geometry::box_shape({1, 1, k_thickness}), Vec3::Zero());
      add_body(bodies, geometry::box_shape({1, 1, k_thickness}), {aside, 0, k_thickness - depth});
      const auto exact = ContactDetector().detect(bodies, k_margin);
      const auto found = ContactDetector(1, NarrowPhase::fcl).detect(bodies, k_margin);
      EXPECT_NEAR(pairs::deepest_point(exact)->gap, -depth, 1e-12) << aside << " " << depth;
      if (pairs::deepest_point(found)->n.z() > std::cos(8 * k_deg)) continue;
      ++wrong;
      EXPECT_GT(depth, 0.5 * k_thickness) << aside;
      EXPECT_LT(pairs::deepest_point(found)->gap, -0.99 * (1 - aside)) << depth;  // FCL returns the sideways overlap.
    }
  EXPECT_GE(wrong, 20);
}

/// FCL misses none of these pairs. On compact bodies nearly all of its depths are right, on overlapping plates they are
/// not.
TEST(NarrowPhases, FclsContactsAreJudgedByTheOracle) {
  for (const pairs::PairClass& c : pairs::all_classes()) {
    const std::string name = c.name;
    if (name != "blocks_any_attitude" && name != "deep_plates") continue;
    const pairs::Tally tally = pairs::tally_batch(c, 0, NarrowPhase::fcl)[0];
    EXPECT_EQ(tally.missed + tally.surplus, 0) << name;
    if (name == "deep_plates")
      EXPECT_GT(tally.wrong_normals, tally.contacts / 20);
    else
      EXPECT_LT(tally.wrong_depths, tally.contacts / 100);
  }
}

}  // namespace narrow_phases_test
}  // namespace nilas::detect
