#include "hydro/wind/wind_area.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace nilas::hydro {

namespace wind_area_test {

WindArea ship(BlendermannShip kind) {
  WindArea area;
  area.ship = kind;
  area.frontal = 350;
  area.lateral = 900;
  area.length = 83;
  area.centroid = -4;
  area.height = 7;
  return area;
}

/// X, Y, K and N of the formulas of blendermann94.m of MSS (MIT licence), which were evaluated apart from this program
/// with V = 15 m/s and its density of 1.224 kg/m^3, for the ship above. Twelve digits were kept.
TEST(WindArea, BlendermannIsThatOfMss) {
  struct Case {
    BlendermannShip ship;
    double angle_deg, X, Y, K, N;
  };
  const Case cases[]{
      {BlendermannShip::offshore_supply, 0, -26507.25, 0, 0, 0},
      {BlendermannShip::offshore_supply, 30, -27238.8140193, 66173.1566298, 555854.51569, 770595.105091},
      {BlendermannShip::offshore_supply, 90, 0, 111537, 936910.8, -446148},
      {BlendermannShip::offshore_supply, 135, 33245.3132629, 96173.9419392, 807861.112289, -1513186.238},
      {BlendermannShip::offshore_supply, 180, 38556, 0, 0, 0},
      {BlendermannShip::tanker_in_ballast, 0, -36146.25, 0, 0, 0},
      {BlendermannShip::tanker_in_ballast, 30, -34305.2830154, 47534.7945205, 732035.835616, 553548.928971},
      {BlendermannShip::tanker_in_ballast, 90, 0, 86751, 1335965.4, -347004},
      {BlendermannShip::tanker_in_ballast, 135, 21766.5943265, 71236.1268868, 1097036.35406, -1120818.43252},
      {BlendermannShip::tanker_in_ballast, 180, 26507.25, 0, 0, 0}};
  const double q = 0.5 * 1.224 * 15 * 15;
  for (const Case& each : cases) {
    const WindArea area = ship(each.ship);
    const WindCoefficients c = wind_coefficients(area, each.angle_deg * k_deg);
    const double Y = q * c.CY * area.lateral;
    EXPECT_NEAR(q * c.CX * area.frontal, each.X, 1e-6) << each.angle_deg;
    EXPECT_NEAR(Y, each.Y, 1e-6) << each.angle_deg;
    EXPECT_NEAR(c.heel * area.height * Y, each.K, 1e-5) << each.angle_deg;
    EXPECT_NEAR(q * c.CN * area.lateral * area.length, each.N, 1e-4) << each.angle_deg;
  }
}

/// The toolbox's formula of the moment holds from 0 to 180 degrees. Wind on the other side gives the mirror image.
TEST(WindArea, OtherSideIsTheMirrorImageToTheBit) {
  for (const BlendermannShip kind : all_choices<BlendermannShip>())
    for (double angle = 0.01; angle < k_pi; angle += 0.1) {
      const WindCoefficients port = wind_coefficients(ship(kind), angle), other = wind_coefficients(ship(kind), -angle);
      EXPECT_EQ(port.CX, other.CX);
      EXPECT_EQ(port.CY, -other.CY);
      EXPECT_EQ(port.CN, -other.CN);
    }
}

TEST(WindArea, EveryShipResistsWindFromAheadAndYieldsAbeam) {
  for (const BlendermannShip kind : all_choices<BlendermannShip>()) {
    EXPECT_EQ(wind_coefficients(ship(kind), 0).CX, -blendermann_row(kind).ahead);
    EXPECT_NEAR(wind_coefficients(ship(kind), k_pi).CX, blendermann_row(kind).astern, 1e-15);
    EXPECT_NEAR(wind_coefficients(ship(kind), k_pi / 2).CY, blendermann_row(kind).across, 1e-15);
  }
}

TEST(WindArea, FileIsLinearBetweenItsAngles) {
  const test::ScratchFolder folder;
  WindArea area = ship(BlendermannShip::research);
  area.model = WindAreaModel::coefficients;
  area.table = std::make_shared<const WindCoefficientTable>(
      folder.write("c.csv", "angle_deg,cx,cy,cn\n0,-0.7,0,0\n90,0.1,0.9,-0.02\n180,0.6,0,0\n").string());
  const WindCoefficients c = wind_coefficients(area, -30 * k_deg), end = wind_coefficients(area, k_pi);
  EXPECT_NEAR(c.CX, -0.7 + 0.8 / 3, 1e-15);
  EXPECT_NEAR(c.CY, -0.3, 1e-15);
  EXPECT_NEAR(c.CN, 0.02 / 3, 1e-15);
  EXPECT_EQ(c.heel, 1);
  EXPECT_EQ(end.CX, 0.6);
}

TEST(WindArea, WrongFilesAreRefusedWithTheirPlace) {
  const test::ScratchFolder folder;
  const auto read = [&](const std::string& text) {
    return [file = folder.write("c.csv", text).string()] { const WindCoefficientTable table(file); };
  };
  test::expect_refusal(read("angle_deg,cx,cy\n0,1,1\n"), {"c.csv:1:1", "column 'cn' is missing"});
  test::expect_refusal(read("angle_deg,cx,cy,cn\n10,1,1,1\n180,1,1,1\n"), {"c.csv:2", "begin at 0"});
  test::expect_refusal(read("angle_deg,cx,cy,cn\n0,1,1,1\n0,1,1,1\n"), {"c.csv:3", "grow"});
  test::expect_refusal(read("angle_deg,cx,cy,cn\n0,1,1,1\n170,1,1,1\n"), {"c.csv:3", "end at 180"});
}

}  // namespace wind_area_test

}  // namespace nilas::hydro
