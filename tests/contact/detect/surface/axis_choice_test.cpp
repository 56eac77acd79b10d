/// The same axis wins among axes that separate a pair equally well, whatever their order.
#include "contact/detect/surface/axis_choice.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/contact/detect/bodies_of_tests.h"

namespace nilas::detect {
namespace axis_choice_test {

struct TwoBoxes {
  bodies::Bodies bodies;
  std::vector<Part> parts;
  std::vector<Axis> room;

  TwoBoxes() {
    add_body(bodies, geometry::box_shape({1, 1, 1}), {0, 0, 0});
    add_body(bodies, geometry::box_shape({1, 1, 1}), {0.2, 0.1, 1});
    for (int b : {0, 1})
      for (Part& part : make_parts(bodies, b)) parts.push_back(std::move(part));
  }
  PairView pair() const { return view_pair(parts[0], parts[1], pose_of_b_in_a(bodies, 0, 1), 1); }
  Axis winner(const std::vector<Axis>& axes) {
    const PairView view = pair();
    AxisContest contest(view, room);
    for (const Axis& axis : axes) contest.enter(axis);
    return contest.winner();
  }
};

Axis edge_axis(const Vec3& n, double s, int edge) { return {n.normalized(), s, AxisKind::edges, edge, edge}; }

/// Each axis is within the tolerance of the next, and lies nearer to the line of centres the less it separates. With
/// comparisons of two at a time, the winner would depend on the order.
TEST(AxisContest, HasTheSameWinnerInEveryOrder) {
  TwoBoxes boxes;
  const double tie = boxes.pair().tolerance;
  std::vector<Axis> axes{edge_axis({0.2, 0.1, 1}, 0, 1), edge_axis({0.25, 0.1, 1}, 0.8 * tie, 2),
                         edge_axis({0.3, 0.1, 1}, 1.6 * tie, 3)};
  const auto by_feature = [](const Axis& a, const Axis& b) { return a.feature_a < b.feature_a; };
  do {
    EXPECT_EQ(boxes.winner(axes).feature_a, 2);
  } while (std::next_permutation(axes.begin(), axes.end(), by_feature));
}

TEST(AxisContest, TakesTheLargestSeparationBeyondTheTolerance) {
  TwoBoxes boxes;
  const double tie = boxes.pair().tolerance;
  EXPECT_EQ(boxes.winner({edge_axis({0.2, 0.1, 1}, 0, 1), edge_axis({1, 0, 0}, 2 * tie, 2)}).feature_a, 2);
  EXPECT_EQ(boxes.winner({}).s, -std::numeric_limits<double>::infinity());
}

TEST(AxisContest, PrefersAFaceToEdgesAlongTheSameAxis) {
  TwoBoxes boxes;
  const Axis face{Vec3::UnitZ(), 0, AxisKind::face_b, -1, 4}, edges = edge_axis({0, 0, 1}, 0, 1);
  EXPECT_EQ(boxes.winner({face, edges}).kind, AxisKind::face_b);
  EXPECT_EQ(boxes.winner({edges, face}).kind, AxisKind::face_b);
}

/// The axes are equal by the line of centres, |n_x| and |n_y|: the one towards x wins.
TEST(AxisContest, AMirroredPairMakesTheMirroredChoice) {
  TwoBoxes boxes;
  boxes.bodies.p_GB[1] = {0, 0, 1};
  const Axis one = edge_axis({0.3, 0.2, 1}, 0, 1), other = edge_axis({-0.3, 0.2, 1}, 0, 2);
  EXPECT_EQ(boxes.winner({one, other}).feature_a, 1);
  EXPECT_EQ(boxes.winner({other, one}).feature_a, 1);
}

/// The line of centres lies along x: the axis towards z wins.
TEST(AxisContest, TellsUpFromDown) {
  TwoBoxes boxes;
  boxes.bodies.p_GB[1] = {1, 0, 0};
  const Axis up = edge_axis({1, 0.2, 0.3}, 0, 1), down = edge_axis({1, 0.2, -0.3}, 0, 2);
  EXPECT_EQ(boxes.winner({up, down}).feature_a, 1);
  EXPECT_EQ(boxes.winner({down, up}).feature_a, 1);
}

}  // namespace axis_choice_test
}  // namespace nilas::detect
