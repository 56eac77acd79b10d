#include "fracture/bend/edge_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace nilas::fracture {
namespace edge_contact_test {

const std::vector<Vec2> k_square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

/// Points that stand for an even pressure on a rectangle about `centre` in the plane, 2 wide by 1 deep shares of it.
std::vector<PointLoad> even_load(const Vec3& centre, double width, double depth, const Vec3& force) {
  std::vector<PointLoad> loads;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      loads.push_back(
          {centre + Vec3(x * width / std::sqrt(12), y * depth / std::sqrt(12), 0), 0.25 * force, 0.3, true});
  return loads;
}

TEST(EdgeContact, KnowsTheSizeOfAnEvenLoadByItsMoments) {
  const auto contacts = edge_contacts(k_square, even_load({1.5, 0.05, 0.01}, 0.4, 0.1, {0, 3, -8}), {0.5, 0.5});
  ASSERT_EQ(contacts.size(), 1u);
  const EdgeContact& c = contacts[0];
  EXPECT_NEAR(c.width, 0.4, 1e-15);
  EXPECT_NEAR(c.depth, 0.1, 1e-15);
  EXPECT_NEAR((c.edge_point - Vec2(1.5, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((c.inward - Vec2(0, 1)).norm(), 0, 1e-15);
  EXPECT_NEAR((c.force - Vec3(0, 3, -8)).norm(), 0, 1e-15);
  EXPECT_TRUE(c.pushes_in);
  EXPECT_EQ(c.opening, 0) << "all push along the crack";
  EXPECT_NEAR(c.speed, 0.3, 1e-15);
}

TEST(EdgeContact, RigidPointsReachFromTheFirstToTheLast) {
  const Vec3 push(0, 1, -1);
  const auto contacts =
      edge_contacts(k_square, {{{1, 0, 0}, push}, {{1.3, 0.1, 0}, push}, {{1.6, 0, 0}, push}}, {1, 1});
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].width, 0.6, 1e-15);
  EXPECT_NEAR(contacts[0].depth, 0.1, 1e-15);
}

/// The two sides of a wedge, each pressing square to itself: half the sum of what goes across is F_Y, and F_X = 2 F_Y
/// tan psi without friction.
TEST(EdgeContact, OpeningIsWhatAWedgePressesAcross) {
  constexpr double psi = 0.4, N = 7;
  const Vec3 left(-N * std::cos(psi), N * std::sin(psi), 0), right(N * std::cos(psi), N * std::sin(psi), 0);
  const auto contacts = edge_contacts(k_square, {{{1.9, 0, 0}, left}, {{2.1, 0, 0}, right}}, {1, 1});
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].opening, N * std::cos(psi), 1e-14);
  EXPECT_NEAR(contacts[0].force.y(), 2 * contacts[0].opening * std::tan(psi), 1e-14);
  EXPECT_NEAR((contacts[0].inward - Vec2(0, 1)).norm(), 0, 1e-15);
}

TEST(EdgeContact, LoadsFarFromTheStrongestStandApart) {
  const Vec3 weak(0, 1, 0), strong(0, 2, 0);
  const auto contacts = edge_contacts(
      k_square, {{{0.5, 0, 0}, weak}, {{1, 0, 0}, weak}, {{1.4, 0, 0}, strong}, {{2, 0, 0}, Vec3::Zero()}},
      {0.45, 0.45});
  ASSERT_EQ(contacts.size(), 2u) << "the one at 0.5 m is within reach of the one at 1 m only";
  EXPECT_EQ(contacts[0].force, Vec3(0, 3, 0));
  EXPECT_EQ(contacts[1].force, Vec3(0, 1, 0));
  EXPECT_EQ(contacts[1].edge_point, Vec2(0.5, 0));
}

/// Both sides of a bow in a notch of 1 m. As one load they would press on the notch's base, where nothing touches.
TEST(EdgeContact, LoadsOnBothBanksOfANotchStandApart) {
  const std::vector<Vec2> notch{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 2}, {4, 2}, {4, 4}, {0, 4}};
  const std::vector<PointLoad> banks{{{2, 0.95, 0}, {-1, -3, -4}}, {{2, 2.05, 0}, {-1, 3, -4}}};
  const auto apart = edge_contacts(notch, banks, {2, 0.9});
  ASSERT_EQ(apart.size(), 2u);
  EXPECT_EQ(apart[0].force, Vec3(-1, -3, -4));
  EXPECT_EQ(apart[1].force, Vec3(-1, 3, -4));
  EXPECT_NEAR(apart[0].edge_point.y(), 1, 1e-12);
  EXPECT_NEAR(apart[1].edge_point.y(), 2, 1e-12);
  EXPECT_EQ(edge_contacts(notch, banks, {2, 1.1}).size(), 1u) << "less water between than the widest gap";
}

/// Ice is crushed some way in, and another edge may be nearer than the one that the load came through.
TEST(EdgeContact, TheEdgeIsThatOfTheLoadsWayIn) {
  const std::vector<Vec2> spit{{0, 0}, {0.3, 0}, {0.3, 2}, {4, 2}, {4, 4}, {0, 4}};
  const auto contacts = edge_contacts(spit, {{{0.2, 0.5, 0}, {0, 3, -4}}}, {1, 1});
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR((contacts[0].edge_point - Vec2(0.2, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((contacts[0].inward - Vec2(0, 1)).norm(), 0, 1e-15);
}

TEST(EdgeContact, AVerticalLoadHasNoCrackDirection) {
  const auto contacts = edge_contacts(k_square, {{{2, 0, 0}, {0, 0, -5}}}, {1, 1});
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_FALSE(contacts[0].pushes_in);
  EXPECT_EQ(contacts[0].edge_point, Vec2(2, 0));
  EXPECT_NEAR((contacts[0].inward - Vec2(0, 1)).norm(), 0, 1e-15);
  EXPECT_EQ(contacts[0].opening, 0);
  EXPECT_TRUE(edge_contacts(k_square, {}, {1, 1}).empty());
  EXPECT_THROW(edge_contacts({{0, 0}, {1, 0}}, {}, {1, 1}), ContractError);
}

}  // namespace edge_contact_test
}  // namespace nilas::fracture
