/// The detector as a whole: which bodies pair, order, threads, memory.
#include "contact/detect/detector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "contact/detect/point_reduction.h"
#include "core/base/error.h"
#include "tests/contact/detect/bodies_of_tests.h"

namespace nilas {
namespace {

struct FloeSpec {
  Shape shape;
  Vec3 p;
  Quat q;
};

/// A crowd of floes in a square, many of them touching.
std::vector<FloeSpec> crowd(int count, std::uint64_t seed) {
  RandomStream random(seed, "crowd");
  const double side = 0.9 * std::sqrt(count);
  std::vector<FloeSpec> floes;
  for (int k = 0; k < count; ++k)
    floes.push_back({floe_shape(random_outline(random, 0.5), 0.1),
                     Vec3(random.uniform(0, side), random.uniform(0, side), random.uniform(-0.02, 0.02)),
                     random_tilt(random, 0.02)});
  return floes;
}

Bodies bodies_of(const std::vector<FloeSpec>& floes, const std::vector<int>& order) {
  Bodies bodies;
  for (int k : order) {
    const int b = add_body(bodies, floes[k].shape, floes[k].p, floes[k].q);
    bodies.name[b] = std::to_string(k);
  }
  return bodies;
}

std::vector<int> in_order(std::size_t count) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// Moves every body a little, each in its own way.
void drift(Bodies& bodies, int step) {
  for (int b = 0; b < bodies.size(); ++b) {
    const double phase = 0.7 * b + 0.05 * step;
    const Quat turn(Eigen::AngleAxisd(2e-3 * std::sin(phase), Vec3(0.1, 0.2, 1).normalized()));
    bodies.set_pose(b, bodies.p_GB[b] + 3e-3 * Vec3(std::cos(phase), std::sin(1.3 * phase), 0.1 * std::sin(phase)),
                    turn * bodies.q_GB[b]);
  }
}

void expect_same_bits(const std::vector<ContactPoint>& one, const std::vector<ContactPoint>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].key, other[i].key);
    EXPECT_EQ(one[i].p, other[i].p);
    EXPECT_EQ(one[i].n, other[i].n);
    EXPECT_EQ(one[i].gap, other[i].gap);
  }
}

TEST(Detector, PointsComeInOrder) {
  const auto floes = crowd(60, 1);
  const auto points = ContactDetector().detect(bodies_of(floes, in_order(floes.size())), 0.01);
  ASSERT_GT(points.size(), 100u);
  const auto rank = [](const ContactPoint& c) { return std::tuple(c.a, c.b, c.part_a, c.part_b, c.key); };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) EXPECT_LT(rank(points[i]), rank(points[i + 1]));
  for (const ContactPoint& c : points) {
    EXPECT_LT(c.a, c.b);
    EXPECT_LT(c.gap, 0.01);
    EXPECT_NEAR(c.n.norm(), 1, 1e-14);
  }
}

TEST(Detector, NoPairIsOverlooked) {
  const auto floes = crowd(40, 6);
  Bodies bodies = bodies_of(floes, in_order(floes.size()));
  ContactDetector detector;
  for (int step = 0; step < 5; ++step) {
    for (int k = 0; k < 10; ++k) drift(bodies, 10 * step + k);
    std::map<std::pair<int, int>, int> found;
    for (const ContactPoint& c : detector.detect(bodies, 0.01)) ++found[{c.a, c.b}];
    for (int a = 0; a < bodies.size(); ++a)
      for (int b = a + 1; b < bodies.size(); ++b) {
        Bodies pair;
        for (int k : {a, b}) add_body(pair, floes[k].shape, bodies.p_GB[k], bodies.q_GB[k]);
        const int anew = static_cast<int>(ContactDetector().detect(pair, 0.01).size()), remembered = found[{a, b}];
        EXPECT_GE(remembered, anew) << a << " " << b;  // a deeper point may have joined the four that stayed
        EXPECT_EQ(remembered > 0, anew > 0) << a << " " << b;
      }
  }
}

TEST(Detector, TheOrderOfBodiesDoesNotMatter) {
  const auto floes = crowd(60, 2);
  auto order = in_order(floes.size());
  const Bodies one = bodies_of(floes, order);
  for (std::size_t i = 0; i < order.size(); ++i) std::swap(order[i], order[(7 * i + 3) % order.size()]);
  const Bodies other = bodies_of(floes, order);
  const auto points = ContactDetector().detect(one, 0.01), shuffled = ContactDetector().detect(other, 0.01);
  ASSERT_EQ(points.size(), shuffled.size());
  std::multimap<std::pair<std::string, std::string>, ContactPoint> by_names;
  for (const ContactPoint& c : shuffled) {
    by_names.insert({{other.name[c.a], other.name[c.b]}, c});
    ContactPoint turned = c;
    turned.n = -c.n;
    by_names.insert({{other.name[c.b], other.name[c.a]}, turned});
  }
  for (const ContactPoint& c : points) {
    const auto [first, last] = by_names.equal_range({one.name[c.a], one.name[c.b]});
    EXPECT_TRUE(std::any_of(first, last,
                            [&](const auto& entry) {
                              return (entry.second.p - c.p).norm() < 1e-12 && (entry.second.n - c.n).norm() < 1e-12 &&
                                     std::abs(entry.second.gap - c.gap) < 1e-13;
                            }))
        << one.name[c.a] << " " << one.name[c.b];
  }
}

TEST(Detector, ThreadsDoNotChangeABit) {
  const auto floes = crowd(150, 3);
  Bodies bodies = bodies_of(floes, in_order(floes.size()));
  ContactDetector one(1), two(2);
  for (int step = 0; step < 20; ++step) {
    drift(bodies, step);
    expect_same_bits(one.detect(bodies, 0.01), two.detect(bodies, 0.01));
  }
}

/// Depths of bodies of about a metre are right within this [m].
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

/// Memory decides which corners of a pair's common area are kept, where several sets are nearly as good, and nothing
/// else: the deepest is always among them.
TEST(Detector, MemoryChangesNothingButWhichCornersAreKept) {
  const auto floes = crowd(80, 4);
  Bodies bodies = bodies_of(floes, in_order(floes.size()));
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

/// Two plates of so many corners, one on the other, that rock by less than a part in a thousand of their room.
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

  Bodies bodies;
};

std::set<std::uint64_t> keys_of(const std::vector<ContactPoint>& points) {
  std::set<std::uint64_t> keys;
  for (const ContactPoint& c : points) keys.insert(c.key);
  return keys;
}

/// The four corners stay, whichever of the others is the deepest and joins them; without memory the best four change.
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

/// Squares turned against each other have eight common corners: once each that takes its turn in being the deepest has
/// joined, none comes or goes.
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
    const Vec3 tie(0.625, 0.625, 0);  // the overlap along x is that along y, to the bit
    Bodies bodies;
    for (const double size : {1.0, 0.5}) add_body(bodies, box_shape(Vec3(size, size, size)), Vec3::Zero());
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
  Bodies bodies;
  ContactDetector detector;
  add_body(bodies, box_shape({1, 1, 1}), {0, 0, 0});
  EXPECT_TRUE(detector.detect(bodies, 0.01).empty());
  add_body(bodies, box_shape({1, 1, 1}), {1, 0, 0});
  EXPECT_EQ(detector.detect(bodies, 0.01).size(), 4u);
  add_body(bodies, box_shape({1, 1, 1}), {0, 0, 1});
  EXPECT_EQ(detector.detect(bodies, 0.01).size(), 10u);  // 4 below the third body, 4 beside, 2 on the edge it shares
}

TEST(Detector, AnotherListOfBodiesStartsAfresh) {
  Bodies bodies, others;
  ContactDetector detector;
  add_body(bodies, box_shape({1, 1, 1}), {0, 0, 0});
  add_body(bodies, box_shape({1, 1, 1}), {1, 0, 0});
  detector.detect(bodies, 0.01);
  add_body(others, box_shape({1, 1, 1}), {0, 0, 0});
  EXPECT_TRUE(detector.detect(others, 0.01).empty());
}

/// As when ice breaks: what pairs of the others remember stays, so their points are those of a detector that lost none.
TEST(Detector, BodiesThatGoTakeNoMemoryOfOthers) {
  const auto floes = crowd(120, 9);
  Bodies all = bodies_of(floes, in_order(floes.size()));
  ContactDetector of_all, of_some;
  for (int step = 0; step < 20; ++step) {
    drift(all, step);
    of_all.detect(all, 0.02);
    of_some.detect(all, 0.02);
  }
  Bodies some = all;
  std::vector<char> gone(floes.size(), 0);
  for (const std::size_t b : {0u, 17u, 18u, 63u, 119u}) gone[b] = 1;
  some.remove(gone);
  const int added = add_body(some, floes[17].shape, some.p_GB[30] + Vec3(0.3, 0.2, 0));
  const std::int64_t new_id = some.id[static_cast<std::size_t>(added)];
  for (int step = 0; step < 3; ++step) {
    const auto stays = [&](const Bodies& bodies, const ContactPoint& c) {
      const auto is_old = [&](int b) {
        const std::int64_t id = bodies.id[static_cast<std::size_t>(b)];
        return id != new_id && gone[static_cast<std::size_t>(id - 1)] == 0;
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
      if (some.id[static_cast<std::size_t>(b)] != new_id) {
        const std::size_t k = all.index_of(some.id[static_cast<std::size_t>(b)]);
        some.p_GB[static_cast<std::size_t>(b)] = all.p_GB[k];
        some.q_GB[static_cast<std::size_t>(b)] = all.q_GB[k];
        some.R_GB[static_cast<std::size_t>(b)] = all.R_GB[k];
      }
  }
}

/// A cut leaves pieces that touch along it; near the end of a seam within the larger one their parts overlap by
/// rounding, which is no way through its whole length.
TEST(Detector, PiecesThatTouchBesideASeamAreNotDeep) {
  Bodies bodies;
  std::vector<Vec2> notched{{0, -3}, {13, -3}, {13, 3}, {0, 3}, {0, 0.3}, {0.2, 0.1}, {0.2, -0.1}, {0, -0.3}};
  const Vec2 centre = polygon_moments(notched).centroid;
  add_body(bodies, floe_shape(notched, 0.04), {centre.x(), centre.y(), 0}, Quat::Identity(), Motion::fixed);
  const std::vector<Vec2> plug{{0, -0.3}, {0.2, -0.1}, {0.2, 0.1}, {0, 0.3}};
  const Vec2 middle = polygon_moments(plug).centroid;
  ASSERT_GT(bodies.shape[0]->parts.size(), 2u);
  RandomStream random(3, "plug");
  for (int k = 0; k < 200; ++k) {
    Bodies pair = bodies;
    const double off = k < 50 ? 1e-15 : 1e-4;
    const auto any = [&] { return random.uniform(-off, off); };
    const Vec3 moved{any(), any(), any()}, turned{any(), any(), any()};
    add_body(pair, floe_shape(plug, 0.04), Vec3(middle.x(), middle.y(), 0) + moved,
             Quat(Eigen::AngleAxisd(turned.norm(), turned.normalized())));
    const auto points = ContactDetector().detect(pair, 0.01);
    EXPECT_GE(points.size(), 6u);
    for (const ContactPoint& c : points) EXPECT_GT(c.gap, -4 * off - 1e-14) << k;
  }
}

TEST(Detector, PartsOfOneConcaveFloeDoNotPair) {
  const std::vector<Vec2> corner{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  Bodies bodies;
  const Shape shape = floe_shape(corner, 0.2);
  ASSERT_GT(shape.parts.size(), 1u);
  add_body(bodies, shape, {0, 0, 0});
  EXPECT_TRUE(ContactDetector().detect(bodies, 0.05).empty());
  // A floe in the inner corner, touches both arms.
  const double corner_at = 1 - 5.0 / 6;
  add_body(bodies, box_shape({0.5, 0.5, 0.2}), {corner_at + 0.251, corner_at + 0.251, 0});
  const auto points = ContactDetector().detect(bodies, 0.05);
  int along_x = 0, along_y = 0;
  for (const ContactPoint& c : points) {
    along_x += c.n.x() > 0.99 ? 1 : 0;
    along_y += c.n.y() > 0.99 ? 1 : 0;
  }
  EXPECT_EQ(along_x, 4);
  EXPECT_EQ(along_y, 4);
}

TEST(Detector, BodiesThatCannotMoveDoNotPair) {
  Bodies bodies;
  add_body(bodies, box_shape({1, 1, 1}), {0, 0, 0}, Quat::Identity(), Motion::fixed);
  add_body(bodies, box_shape({1, 1, 1}), {1, 0, 0}, Quat::Identity(), Motion::fixed);
  add_body(bodies, plane_shape(), {0, 0, -0.5}, Quat::Identity(), Motion::fixed);
  EXPECT_TRUE(ContactDetector().detect(bodies, 0.01).empty());
  bodies.motion[1] = Motion::articulated;
  EXPECT_EQ(ContactDetector().detect(bodies, 0.01).size(), 8u);
}

TEST(Detector, CountsWhatItDid) {
  Bodies bodies;
  add_body(bodies, box_shape({1, 1, 1}), {0, 0, 0});
  add_body(bodies, box_shape({1, 1, 1}), {1.02, 0, 0});
  ContactDetector detector;
  EXPECT_TRUE(detector.detect(bodies, 0.01).empty());
  EXPECT_EQ(detector.counts().candidate_pairs, 1);
  EXPECT_EQ(detector.counts().cached_separations, 0);
  EXPECT_TRUE(detector.detect(bodies, 0.01).empty());
  EXPECT_EQ(detector.counts().cached_separations, 1);
}

/// A detector that goes on from a saved state lists the same pairs and finds the same points; a new one does not list
/// the same pairs, since its boxes were made at other poses.
TEST(Detector, GoesOnAsItWasSaved) {
  const auto floes = crowd(120, 5);
  Bodies bodies = bodies_of(floes, in_order(floes.size()));
  add_body(bodies, plane_shape(), Vec3(0, 0, -0.3), Quat::Identity(), Motion::fixed);
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
  const Bodies ten = bodies_of(floes, in_order(10)), nine = bodies_of(floes, in_order(9));
  ContactDetector detector, other;
  detector.detect(ten, 0.01);
  State state;
  detector.save(StateWriter(state));
  EXPECT_THROW(other.restore(nine, StateReader(state)), InputError);
  State wrong_axis = state;
  auto& axes = std::get<std::vector<std::int64_t>>(wrong_axis.entries.at("pairs/contact_axis"));
  axes.at(0) = 0;  // of a face that no floe has
  axes.at(1) = 1000;
  EXPECT_THROW(other.restore(ten, StateReader(wrong_axis)), InputError);
}

TEST(ContactDetector, APoseThatIsNoNumberIsRefused) {
  for (const int corners : {4, 40}) {
    Bodies bodies;
    for (int k = 0; k < 2; ++k) add_body(bodies, floe_shape(regular_outline(corners, 1), 0.1), {0.5 * k, 0, 0});
    bodies.p_GB[1].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(ContactDetector().detect(bodies, 0.1), ContractError);
  }
}

}  // namespace
}  // namespace nilas
