/// Tests of the detector's memory from call to call, when bodies come and go, and over a checkpoint.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "contact/detect/detector.h"
#include "contact/detect/surface/point_reduction.h"
#include "core/base/error.h"
#include "tests/contact/detect/crowd.h"

namespace nilas::detect {
namespace detector_memory_test {

/// Largest error of a correct depth for bodies of about a metre [m].
constexpr double k_right_depth = 1e-9;

std::map<std::pair<int, int>, std::vector<ContactPoint>> by_pair(const std::vector<ContactPoint>& points) {
  std::map<std::pair<int, int>, std::vector<ContactPoint>> pairs;
  for (const ContactPoint& c : points) pairs[{c.a, c.b}].push_back(c);
  return pairs;
}

double deepest_gap(const std::vector<ContactPoint>& points) {
  return std::min_element(points.begin(), points.end(), [](const auto& p, const auto& q) { return p.gap < q.gap; })
      ->gap;
}

/// Memory only decides which corners of a pair's common area are kept, where several sets are nearly as good. The
/// deepest corner is always kept.
TEST(Detector, MemoryChangesNothingButWhichCornersAreKept) {
  const auto floes = crowd(80, 4);
  bodies::Bodies bodies = bodies_of(floes, in_order(floes.size()));
  ContactDetector remembering;
  long separations = 0, kept = 0;
  int pairs_seen = 0, other_corners = 0;
  for (int step = 0; step < 40; ++step) {
    drift(bodies, step);
    const double margin = step % 7 == 3 ? 0.02 : 0.005;
    const auto with = by_pair(remembering.detect(bodies, margin)),
               without = by_pair(ContactDetector().detect(bodies, margin));
    separations += remembering.counts().cached_separations;
    kept += remembering.counts().kept_axes;
    ASSERT_EQ(with.size(), without.size());
    for (const auto& [pair, points] : with) {
      const auto& fresh = without.at(pair);
      ++pairs_seen;
      ASSERT_GE(points.size(), fresh.size());
      ASSERT_LE(points.size(), k_most_points);
      for (const ContactPoint& p : points) EXPECT_EQ(p.n, fresh.front().n);
      EXPECT_NEAR(deepest_gap(points), deepest_gap(fresh), k_right_depth);
      const auto key_differs = [](const auto& p, const auto& q) { return p.key != q.key; };
      if (!std::equal(points.begin(), points.end(), fresh.begin(), fresh.end(), std::not_fn(key_differs)))
        ++other_corners;
      else
        expect_same_bits(points, fresh);
    }
  }
  EXPECT_GT(separations, 1000);
  EXPECT_GT(kept, 100);
  EXPECT_GT(other_corners, 0);
  EXPECT_LT(other_corners, pairs_seen / 10);  // 5 % in this crowd of deep overlaps, by the 2 % band of k_kept_area
}

/// Two plates of so many corners, one on the other, that rock by less than a thousandth of their size.
struct RockingPlates {
  explicit RockingPlates(int corners) {
    add_body(bodies, floe_shape(regular_outline(corners, 1), 0.2), {0, 0, 0});
    add_body(bodies, floe_shape(regular_outline(corners, 1, 0.3), 0.2), {0.03, 0.01, 0.2});
  }
  void rock(int k) {
    const Vec3 axis(std::cos(2.4 * k), std::sin(2.4 * k), 0);
    bodies.set_pose(1, {0.03, 0.01, 0.2}, Quat(Eigen::AngleAxisd(5e-7, axis)));
  }
  std::vector<ContactPoint> seen_by(ContactDetector& detector) const { return detector.detect(bodies, 1e-3); }
  std::vector<ContactPoint> seen_anew() const { return ContactDetector().detect(bodies, 1e-3); }

  bodies::Bodies bodies;
};

std::set<std::uint64_t> keys_of(const std::vector<ContactPoint>& points) {
  std::set<std::uint64_t> keys;
  for (const ContactPoint& c : points) keys.insert(c.key);
  return keys;
}

/// The four corners stay, whichever of the others is the deepest and joins them. Without memory the best four change.
TEST(Detector, APairThatRocksKeepsItsCornersAndItsDepth) {
  RockingPlates plates(8);
  ContactDetector detector;
  plates.rock(0);
  const auto four = keys_of(plates.seen_by(detector));
  EXPECT_EQ(four.size(), k_spread_points);
  int changes_without = 0;
  for (int k = 1; k < 200; ++k) {
    plates.rock(k);
    const auto points = plates.seen_by(detector), fresh = plates.seen_anew();
    const auto keys = keys_of(points);
    EXPECT_TRUE(std::includes(keys.begin(), keys.end(), four.begin(), four.end()));
    EXPECT_LE(keys.size(), k_most_points);
    EXPECT_NEAR(deepest_gap(points), deepest_gap(fresh), k_right_depth);
    changes_without += keys_of(fresh) == four ? 0 : 1;
  }
  EXPECT_GT(changes_without, 20);
}

/// Squares turned against each other have eight common corners. Once each corner has been the deepest and has joined,
/// the set no longer changes.
TEST(Detector, APairThatRocksOnEightCornersComesToKeepThem) {
  RockingPlates plates(4);
  ContactDetector detector;
  std::set<std::uint64_t> keys;
  int changes = 0;
  for (int k = 0; k < 200; ++k) {
    plates.rock(k);
    const auto now = keys_of(plates.seen_by(detector));
    changes += k > 20 && now != keys ? 1 : 0;
    keys = now;
  }
  EXPECT_GT(keys.size(), k_spread_points);
  EXPECT_EQ(changes, 0);
}

TEST(Detector, APairKeepsItsAxisThroughATie) {
  const auto normal_at_the_tie = [](const Vec3& before) {
    const Vec3 tie(0.625, 0.625, 0);  // The overlap along x equals that along y to the bit.
    bodies::Bodies bodies;
    for (const double size : {1.0, 0.5}) add_body(bodies, geometry::box_shape(Vec3(size, size, size)), Vec3::Zero());
    ContactDetector detector;
    bodies.set_pose(1, tie + before, Quat::Identity());
    detector.detect(bodies, 1e-3);
    bodies.set_pose(1, tie, Quat::Identity());
    const auto points = detector.detect(bodies, 1e-3);
    EXPECT_FALSE(points.empty());
    return points.empty() ? Vec3(Vec3::Zero()) : points.front().n;
  };
  EXPECT_EQ(normal_at_the_tie({0.03125, 0, 0}), Vec3(Vec3::UnitX()));
  EXPECT_EQ(normal_at_the_tie({0, 0.03125, 0}), Vec3(Vec3::UnitY()));
}

TEST(Detector, NewBodiesArePickedUp) {
  bodies::Bodies bodies;
  ContactDetector detector;
  add_body(bodies, geometry::box_shape({1, 1, 1}), {0, 0, 0});
  EXPECT_TRUE(detector.detect(bodies, 0.01).empty());
  add_body(bodies, geometry::box_shape({1, 1, 1}), {1, 0, 0});
  EXPECT_EQ(detector.detect(bodies, 0.01).size(), 4u);
  add_body(bodies, geometry::box_shape({1, 1, 1}), {0, 0, 1});
  // 4 points below the third body, 4 beside it, 2 on the shared edge.
  EXPECT_EQ(detector.detect(bodies, 0.01).size(), 10u);
}

TEST(Detector, AnotherListOfBodiesStartsAfresh) {
  bodies::Bodies bodies, others;
  ContactDetector detector;
  add_body(bodies, geometry::box_shape({1, 1, 1}), {0, 0, 0});
  add_body(bodies, geometry::box_shape({1, 1, 1}), {1, 0, 0});
  detector.detect(bodies, 0.01);
  add_body(others, geometry::box_shape({1, 1, 1}), {0, 0, 0});
  EXPECT_TRUE(detector.detect(others, 0.01).empty());
}

/// When ice breaks, the memory of the other pairs stays. Their points are those of a detector that lost no body.
TEST(Detector, BodiesThatGoTakeNoMemoryOfOthers) {
  const auto floes = crowd(120, 9);
  bodies::Bodies all = bodies_of(floes, in_order(floes.size()));
  ContactDetector of_all, of_some;
  for (int step = 0; step < 20; ++step) {
    drift(all, step);
    of_all.detect(all, 0.02);
    of_some.detect(all, 0.02);
  }
  bodies::Bodies some = all;
  std::vector<char> gone(floes.size(), 0);
  for (const std::size_t b : {0u, 17u, 18u, 63u, 119u}) gone[b] = 1;
  some.remove(gone);
  const int added = add_body(some, floes[17].shape, some.p_GB[30] + Vec3(0.3, 0.2, 0));
  const std::int64_t new_id = some.id[added];
  for (int step = 0; step < 3; ++step) {
    const auto stays = [&](const bodies::Bodies& bodies, const ContactPoint& c) {
      const auto is_old = [&](int b) {
        const std::int64_t id = bodies.id[b];
        return id != new_id && gone[id - 1] == 0;
      };
      return is_old(c.a) && is_old(c.b);
    };
    auto expected = of_all.detect(all, 0.02), found = of_some.detect(some, 0.02);
    std::erase_if(expected, [&](const ContactPoint& c) { return !stays(all, c); });
    std::erase_if(found, [&](const ContactPoint& c) { return !stays(some, c); });
    ASSERT_GT(expected.size(), 200u);
    expect_same_bits(expected, found);
    drift(all, step);
    for (int b = 0; b < some.size(); ++b)
      if (some.id[b] != new_id) {
        const std::size_t k = all.index_of(some.id[b]);
        some.p_GB[b] = all.p_GB[k];
        some.q_GB[b] = all.q_GB[k];
        some.R_GB[b] = all.R_GB[k];
      }
  }
}

/// A detector restored from a saved state lists the same pairs and finds the same points. A new detector lists other
/// pairs, since its boxes were made at other poses.
TEST(Detector, GoesOnAsItWasSaved) {
  const auto floes = crowd(120, 5);
  bodies::Bodies bodies = bodies_of(floes, in_order(floes.size()));
  add_body(bodies, geometry::plane_shape(), Vec3(0, 0, -0.3), Quat::Identity(), bodies::Motion::fixed);
  constexpr double k_margin = 0.01;
  ContactDetector whole;
  State state;
  for (int step = 0; step < 15; ++step) {
    drift(bodies, step);
    whole.detect(bodies, k_margin);
  }
  whole.save(StateWriter(state));
  ContactDetector rest, fresh;
  rest.restore(bodies, StateReader(state));
  State again;
  rest.save(StateWriter(again));
  EXPECT_EQ(again.entries, state.entries);
  int differences = 0;
  for (int step = 15; step < 40; ++step) {
    drift(bodies, step);
    const auto points = whole.detect(bodies, k_margin);
    expect_same_bits(rest.detect(bodies, k_margin), points);
    EXPECT_EQ(rest.counts().candidate_pairs, whole.counts().candidate_pairs) << step;
    EXPECT_EQ(rest.counts().kept_axes, whole.counts().kept_axes) << step;
    EXPECT_EQ(rest.counts().cached_separations, whole.counts().cached_separations) << step;
    fresh.detect(bodies, k_margin);
    differences += fresh.counts().candidate_pairs != whole.counts().candidate_pairs;
  }
  EXPECT_GT(differences, 0);
}

TEST(Detector, RefusesAStateOfOtherParts) {
  const auto floes = crowd(10, 5);
  const bodies::Bodies ten = bodies_of(floes, in_order(10)), nine = bodies_of(floes, in_order(9));
  ContactDetector detector, other;
  detector.detect(ten, 0.01);
  State state;
  detector.save(StateWriter(state));
  EXPECT_THROW(other.restore(nine, StateReader(state)), InputError);
  State wrong_axis = state;
  auto& axes = std::get<std::vector<std::int64_t>>(wrong_axis.entries.at("pairs/contact_axis"));
  axes.at(0) = 0;  // No floe has a face with this number.
  axes.at(1) = 1000;
  EXPECT_THROW(other.restore(ten, StateReader(wrong_axis)), InputError);
}

}  // namespace detector_memory_test
}  // namespace nilas::detect
