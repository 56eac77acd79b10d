#include "fracture/cut/crack_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"
#include "fracture/cut/crack_lines.h"
#include "fracture/cut/cut_outline.h"

namespace nilas::fracture {
namespace crack_path_test {

/// A floe of 10 m by 8 m, entered in the middle of its lower side.
const std::vector<Vec2> k_floe{{-5, 0}, {5, 0}, {5, 8}, {-5, 8}};
constexpr double k_up = k_pi / 2, k_segment = 0.25, k_toughness = 3e3;

Vec2 turned(const Vec2& x, double angle) {
  return {std::cos(angle) * x.x() - std::sin(angle) * x.y(), std::sin(angle) * x.x() + std::cos(angle) * x.y()};
}

CrackPath path_through(const LocalIce& ice) { return crack_path(k_floe, {0, 0}, k_up, k_segment, k_toughness, ice); }

/// A line through (0, 3) of half length 1.5 at the angle omega to the crack's direction.
LocalIce leaning_line(double omega, double strength) {
  const Vec2 along = turned(Vec2::UnitY(), -omega);
  LocalIce ice;
  ice.weak_lines = {{{Vec2(0, 3) - 1.5 * along, Vec2(0, 3) + 1.5 * along}, strength}};
  return ice;
}

double largest_offset(const CrackPath& path) {
  double most = 0;
  for (const Vec2& p : path.points) most = std::max(most, std::abs(p.x()));
  return most;
}

TEST(CrackPath, KinksReleaseWhatTheirStressIntensitiesSay) {
  EXPECT_EQ(kink_release_rate(0), 1);
  EXPECT_NEAR(kink_release_rate(k_pi / 2), 0.25, 1e-15);
  for (double omega = 0; omega < 1.6; omega += 0.1) {
    const double k_I = 0.25 * (3 * std::cos(omega / 2) + std::cos(1.5 * omega));
    const double k_II = 0.25 * (std::sin(omega / 2) + std::sin(1.5 * omega));
    EXPECT_NEAR(kink_release_rate(omega), k_I * k_I + k_II * k_II, 1e-14) << omega;
  }
}

TEST(CrackPath, IsStraightThroughIceThatIsAlike) {
  const CrackPath path = path_through({});
  EXPECT_LT(largest_offset(path), 1e-12);
  EXPECT_NEAR(path.length(), 8, 1e-5);
  EXPECT_GT(path.points.back().y(), 8) << "just beyond the edge";
  for (const double K : path.toughness) EXPECT_EQ(K, k_toughness);
}

/// It turns where the line's toughness, squared, is below the kink's release rate: below cos^2(omega / 2) of the ice's.
TEST(CrackPath, TurnsOntoALineThatIsWeakEnough) {
  for (const double degrees : {20.0, 45.0, 70.0, 85.0}) {
    const double omega = degrees * k_deg, needed = std::pow(std::cos(omega / 2), 2);
    EXPECT_LT(largest_offset(path_through(leaning_line(omega, 1.001 * needed))), 1e-9) << degrees;
    const CrackPath path = path_through(leaning_line(omega, 0.999 * needed));
    const double end = 1.5 * std::sin(omega);
    EXPECT_NEAR(largest_offset(path), end, 1e-9) << degrees << ": to the line's end, then straight on again";
    EXPECT_NEAR(path.points.back().x(), end, 1e-9);
    EXPECT_NEAR(path.length(), 8 + 1.5 * (1 - std::cos(omega)), 1e-4);
  }
}

TEST(CrackPath, GoesStraightWhereTwoWaysAreMirrorImages) {
  LocalIce ice;
  ice.weak_lines = {{{{-2, 5}, {0, 3}, {2, 5}}, 0.3}};
  EXPECT_LT(largest_offset(path_through(ice)), 1e-9);
  ice = {};
  ice.fracture_toughness = [](const Vec2& x) { return k_toughness * (2 - x.x() * x.x()); };
  EXPECT_LT(largest_offset(path_through(ice)), 1e-9) << "weaker on both sides";
}

TEST(CrackPath, LeansToTheWeakerSideAndMirrors) {
  LocalIce weaker_left, weaker_right;
  weaker_left.fracture_toughness = [](const Vec2& x) { return k_toughness * std::exp(x.x() / 0.8); };
  weaker_right.fracture_toughness = [](const Vec2& x) { return k_toughness * std::exp(-x.x() / 0.8); };
  const CrackPath left = path_through(weaker_left), right = path_through(weaker_right);
  ASSERT_EQ(left.points.size(), right.points.size());
  EXPECT_LT(left.points.back().x(), -0.5);
  for (std::size_t i = 0; i < left.points.size(); ++i)
    EXPECT_LT((Vec2(-left.points[i].x(), left.points[i].y()) - right.points[i]).norm(), 1e-12);
  // 2 ln K falls by segment * sin(omega) / 0.8 and 4 ln cos(omega / 2) by omega^2 / 2: 17 degrees, 15 of those tried
  const Vec2 first = left.points[1] - left.points[0];
  EXPECT_NEAR(std::atan2(-first.x(), first.y()), 15 * k_deg, 1e-9);
}

TEST(CrackPath, TurnsWithTheFloe) {
  const LocalIce ice = leaning_line(50 * k_deg, 0.5);
  const CrackPath path = path_through(ice);
  for (const double angle : {0.3, 1.9, 4.4}) {
    std::vector<Vec2> floe;
    for (const Vec2& p : k_floe) floe.push_back(turned(p, angle));
    LocalIce there;
    there.weak_lines = {
        {{turned(ice.weak_lines[0].points[0], angle), turned(ice.weak_lines[0].points[1], angle)}, 0.5}};
    const CrackPath other = crack_path(floe, turned({0, 0}, angle), k_up + angle, k_segment, k_toughness, there);
    ASSERT_EQ(other.points.size(), path.points.size());
    for (std::size_t i = 0; i < path.points.size(); ++i)
      EXPECT_LT((other.points[i] - turned(path.points[i], angle)).norm(), 1e-9);
  }
}

/// Seams between hexagons of side 1, whose corners turn by 60 degrees: followed from edge to edge below cos^2(30 deg).
TEST(CrackPath, FollowsTheSeamsOfFrozenFloes) {
  for (const double strength : {0.74, 0.76}) {
    LocalIce ice;
    const double across = std::sqrt(3.0);
    for (int row = -1; row < 8; ++row)
      for (int column = -5; column < 5; ++column) {
        const Vec2 centre(across * (column + (row % 2 == 0 ? 0.5 : 0.0)), 1.5 * row + 0.5);
        const auto corner = [&](int k) { return Vec2(centre + turned(Vec2::UnitY(), k * k_pi / 3)); };
        for (int k = 0; k < 3; ++k) ice.weak_lines.push_back({{corner(k), corner(k + 1)}, strength});
      }
    const CrackPath path = crack_path(k_floe, {0, 0}, k_up + 0.02, k_segment, k_toughness, ice);
    std::size_t weak = 0;
    for (const double K : path.toughness) weak += K < k_toughness ? 1 : 0;
    const std::size_t whole = path.toughness.size() - weak;
    if (strength < 0.75) {
      EXPECT_LE(whole, 6u) << "none but the way to the first seam";
    } else {
      EXPECT_GT(whole, path.toughness.size() / 3);
    }
    const CutResult cut = cut_outline(k_floe, {path.points});
    ASSERT_EQ(cut.status, CutStatus::cut) << cut.message;
    EXPECT_EQ(cut.pieces.size(), 2u);
  }
}

/// Star-shaped floes, convex or not, with lines anywhere and a toughness that varies: every path comes out of the ice,
/// and cuts it.
TEST(CrackPath, ComesOutOfAnyFloe) {
  RandomStream random(5, "crack paths");
  int cut = 0;
  constexpr int k_floes = 1000;
  for (int n = 0; n < k_floes; ++n) {
    std::vector<Vec2> floe;
    const int corners = 3 + static_cast<int>(random.uniform(0, 12));
    for (int k = 0; k < corners; ++k)
      floe.emplace_back(turned({random.uniform(0.4, 2), 0}, 2 * k_pi * (k + random.uniform(0, 0.8)) / corners));
    if (!geometry::is_simple(floe) || geometry::is_clockwise(floe)) continue;
    LocalIce ice;
    const Vec2 wave(random.uniform(-6, 6), random.uniform(-6, 6));
    ice.fracture_toughness = [wave](const Vec2& x) { return k_toughness * (1 + 0.8 * std::sin(wave.dot(x))); };
    for (int k = 0; k < 6; ++k) {
      bodies::WeakLine line{{}, random.uniform(0.05, 1)};
      for (int i = 0; i < 3; ++i) line.points.emplace_back(random.uniform(-2, 2), random.uniform(-2, 2));
      if (k == 0) line.points.front() = floe.front();
      ice.weak_lines.push_back(line);
    }
    const double angle = random.uniform(0, 2 * k_pi);
    const auto ahead = chords(floe, 0.999 * floe.front(), angle);
    if (ahead.empty()) continue;
    const CrackPath path = crack_path(floe, ahead.front().start, angle, random.uniform(0.02, 1), k_toughness, ice);
    ASSERT_EQ(path.toughness.size() + 1, path.points.size());
    EXPECT_FALSE(geometry::contains(floe, path.points.back())) << n;
    EXPECT_LT(path.points.size(), 5000u);
    const CutResult result = cut_outline(floe, {path.points});
    EXPECT_TRUE(result.status == CutStatus::cut || result.status == CutStatus::uncut) << n << ": " << result.message;
    cut += result.status == CutStatus::cut ? 1 : 0;
  }
  EXPECT_GT(cut, 0.8 * k_floes);
}

TEST(CrackPath, RefusesImpossibleInput) {
  EXPECT_THROW(crack_path(k_floe, {0, 0}, k_up, 0, k_toughness, {}), ContractError);
  EXPECT_THROW(crack_path(k_floe, {0, 0}, k_up, k_segment, 0, {}), ContractError);
}

}  // namespace crack_path_test
}  // namespace nilas::fracture
