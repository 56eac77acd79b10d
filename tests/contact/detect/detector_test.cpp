/// Tests of the detector as a whole: pairs of bodies, order, threads, counts.
#include "contact/detect/detector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "core/base/error.h"
#include "tests/contact/detect/crowd.h"

namespace nilas::detect {
namespace detector_test {

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
  bodies::Bodies bodies = bodies_of(floes, in_order(floes.size()));
  ContactDetector detector;
  for (int step = 0; step < 5; ++step) {
    for (int k = 0; k < 10; ++k) drift(bodies, 10 * step + k);
    std::map<std::pair<int, int>, int> found;
    for (const ContactPoint& c : detector.detect(bodies, 0.01)) ++found[{c.a, c.b}];
    for (int a = 0; a < bodies.size(); ++a)
      for (int b = a + 1; b < bodies.size(); ++b) {
        bodies::Bodies pair;
        for (int k : {a, b}) add_body(pair, floes[k].shape, bodies.p_GB[k], bodies.q_GB[k]);
        const int anew = static_cast<int>(ContactDetector().detect(pair, 0.01).size()), remembered = found[{a, b}];
        EXPECT_GE(remembered, anew) << a << " " << b;  // A deeper point may have joined the four kept ones.
        EXPECT_EQ(remembered > 0, anew > 0) << a << " " << b;
      }
  }
}

TEST(Detector, TheOrderOfBodiesDoesNotMatter) {
  const auto floes = crowd(60, 2);
  auto order = in_order(floes.size());
  const bodies::Bodies one = bodies_of(floes, order);
  for (std::size_t i = 0; i < order.size(); ++i) std::swap(order[i], order[(7 * i + 3) % order.size()]);
  const bodies::Bodies other = bodies_of(floes, order);
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
  bodies::Bodies bodies = bodies_of(floes, in_order(floes.size()));
  ContactDetector one(1), two(2);
  for (int step = 0; step < 20; ++step) {
    drift(bodies, step);
    expect_same_bits(one.detect(bodies, 0.01), two.detect(bodies, 0.01));
  }
}

/// A cut leaves pieces that touch along it. Near the end of a seam in the larger one, their convex pieces overlap by
/// rounding. The depth must not be the length of the seam.
TEST(Detector, PiecesThatTouchBesideASeamAreNotDeep) {
  bodies::Bodies bodies;
  std::vector<Vec2> notched{{0, -3}, {13, -3}, {13, 3}, {0, 3}, {0, 0.3}, {0.2, 0.1}, {0.2, -0.1}, {0, -0.3}};
  const Vec2 centre = geometry::polygon_moments(notched).centroid;
  add_body(bodies, floe_shape(notched, 0.04), {centre.x(), centre.y(), 0}, Quat::Identity(), bodies::Motion::fixed);
  const std::vector<Vec2> plug{{0, -0.3}, {0.2, -0.1}, {0.2, 0.1}, {0, 0.3}};
  const Vec2 middle = geometry::polygon_moments(plug).centroid;
  ASSERT_GT(bodies.shape[0]->parts.size(), 2u);
  RandomStream random(3, "plug");
  for (int k = 0; k < 200; ++k) {
    bodies::Bodies pair = bodies;
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
  bodies::Bodies bodies;
  const geometry::Shape shape = floe_shape(corner, 0.2);
  ASSERT_GT(shape.parts.size(), 1u);
  add_body(bodies, shape, {0, 0, 0});
  EXPECT_TRUE(ContactDetector().detect(bodies, 0.05).empty());
  // The floe in the inner corner touches both arms.
  const double corner_at = 1 - 5.0 / 6;
  add_body(bodies, geometry::box_shape({0.5, 0.5, 0.2}), {corner_at + 0.251, corner_at + 0.251, 0});
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
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({1, 1, 1}), {0, 0, 0}, Quat::Identity(), bodies::Motion::fixed);
  add_body(bodies, geometry::box_shape({1, 1, 1}), {1, 0, 0}, Quat::Identity(), bodies::Motion::fixed);
  add_body(bodies, geometry::plane_shape(), {0, 0, -0.5}, Quat::Identity(), bodies::Motion::fixed);
  EXPECT_TRUE(ContactDetector().detect(bodies, 0.01).empty());
  bodies.motion[1] = bodies::Motion::articulated;
  EXPECT_EQ(ContactDetector().detect(bodies, 0.01).size(), 8u);
}

/// Pairs that a filter names are listed but not searched. All others have the same contacts as without it.
TEST(Detector, PairsAreLeftToTheCaller) {
  const auto floes = crowd(80, 7);
  bodies::Bodies bodies = bodies_of(floes, in_order(floes.size()));
  const PairFilter left = [](int a, int b) { return (a + b) % 3 == 0; };
  ContactDetector some(2), all(2);
  for (int step = 0; step < 10; ++step) {
    drift(bodies, step);
    auto expected = all.detect(bodies, 0.01);
    std::set<std::pair<int, int>> touching;
    for (const ContactPoint& c : expected)
      if (left(c.a, c.b)) touching.insert({c.a, c.b});
    std::erase_if(expected, [&](const ContactPoint& c) { return left(c.a, c.b); });
    expect_same_bits(some.detect(bodies, 0.01, left), expected);
    const auto& listed = some.pairs_left();
    EXPECT_TRUE(std::is_sorted(listed.begin(), listed.end()));
    EXPECT_TRUE(std::includes(listed.begin(), listed.end(), touching.begin(), touching.end()));
    EXPECT_TRUE(
        std::all_of(listed.begin(), listed.end(), [&](const auto& pair) { return left(pair.first, pair.second); }));
    EXPECT_TRUE(all.pairs_left().empty());
  }
  State state;
  some.save(StateWriter(state));
  ContactDetector again(2);
  again.restore(bodies, StateReader(state));
  drift(bodies, 10);
  expect_same_bits(again.detect(bodies, 0.01, left), some.detect(bodies, 0.01, left));
}

TEST(Detector, CountsWhatItDid) {
  bodies::Bodies bodies;
  add_body(bodies, geometry::box_shape({1, 1, 1}), {0, 0, 0});
  add_body(bodies, geometry::box_shape({1, 1, 1}), {1.02, 0, 0});
  ContactDetector detector;
  EXPECT_TRUE(detector.detect(bodies, 0.01).empty());
  EXPECT_EQ(detector.counts().candidate_pairs, 1);
  EXPECT_EQ(detector.counts().cached_separations, 0);
  EXPECT_TRUE(detector.detect(bodies, 0.01).empty());
  EXPECT_EQ(detector.counts().cached_separations, 1);
}

TEST(ContactDetector, APoseThatIsNoNumberIsRefused) {
  for (const int corners : {4, 40}) {
    bodies::Bodies bodies;
    for (int k = 0; k < 2; ++k) add_body(bodies, floe_shape(regular_outline(corners, 1), 0.1), {0.5 * k, 0, 0});
    bodies.p_GB[1].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(ContactDetector().detect(bodies, 0.1), ContractError);
  }
}

}  // namespace detector_test
}  // namespace nilas::detect
