/// Units are read as products of kg, m and s, and give the factors of Froude's and Cauchy's laws.
#include "core/scene/spec/unit.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace unit_test {

using namespace nilas::scene;

/// N = kg m s^-2, Pa = N m^-2, J = N m, W = J/s; the rest is arithmetic of exponents.
TEST(Unit, IsReadAsAProductOfPowers) {
  const std::vector<std::pair<std::string, Dimension>> known{
      {"", {0, 0, 0}},           {"m", {0, 1, 0}},          {"m/s", {0, 1, -1}},       {"m/s^2", {0, 1, -2}},
      {"kg/m^3", {1, -3, 0}},    {"kg m^2", {1, 2, 0}},     {"N", {1, 1, -2}},         {"N m", {1, 2, -2}},
      {"N s/m", {1, 0, -1}},     {"N m s/rad", {1, 2, -1}}, {"N/m", {1, 0, -2}},       {"Pa", {1, -1, -2}},
      {"s/m", {0, -1, 1}},       {"1/s", {0, 0, -1}},       {"deg/s", {0, 0, -1}},     {"Pa sqrt(m)", {1, -0.5, -2}},
      {"m^-1", {0, -1, 0}},      {"W", {1, 2, -3}},         {"N s^2/m^2", {1, -1, 0}}, {"%", {0, 0, 0}},
      {"kg m^2/s^2", {1, 2, -2}}};
  for (const auto& [text, dimension] : known) EXPECT_EQ(parse_unit(text), dimension) << text;
}

/// With the exponent -0.7, a pressure coefficient has Pa m^1.4 = kg m^0.4 s^-2.
TEST(Unit, TakesExponentsThatItNames) {
  const auto named = [](const std::string& name) { return name == "exponent" ? std::optional(-0.7) : std::nullopt; };
  const auto found = parse_unit("Pa m^(-2 exponent)", named);
  ASSERT_TRUE(found.has_value());
  EXPECT_DOUBLE_EQ(found->length, 0.4);
  EXPECT_FALSE(parse_unit("Pa m^(-2 exponents)", named).has_value());
  EXPECT_FALSE(parse_unit("Pa m^(-2 exponent)").has_value());
}

TEST(Unit, RefusesWhatItDoesNotKnow) {
  for (const char* text : {"furlong", "m s ", " m", "m//s", "m^", "m^x", "sqrt(m", "m/", "N m/rad; of a slider N/m"})
    EXPECT_FALSE(parse_unit(text).has_value()) << text;
}

/// The table of the ITTC for lambda = 16: every factor is a power of two, so equality is exact.
TEST(ScaleFactor, IsThatOfFroudeAndCauchy) {
  const std::vector<std::pair<std::string, double>> factors{
      {"m", 0x1p4},       {"s", 0x1p2},  {"m/s", 0x1p2},        {"m/s^2", 1},    {"kg", 0x1p12},  {"N", 0x1p12},
      {"N m", 0x1p16},    {"Pa", 0x1p4}, {"Pa sqrt(m)", 0x1p6}, {"W", 0x1p14},   {"N/m", 0x1p8},  {"deg/s", 0x1p-2},
      {"kg m^2", 0x1p20}, {"kg/m^3", 1}, {"N s/m", 0x1p10},     {"1/s", 0x1p-2}, {"s/m", 0x1p-2}, {"deg", 1}};
  for (const auto& [unit, factor] : factors) {
    EXPECT_EQ(scale_factor(parse_unit(unit).value(), 16), factor) << unit;
    EXPECT_EQ(scale_factor(parse_unit(unit).value(), 1.0 / 16), 1 / factor) << unit;
    EXPECT_EQ(scale_factor(parse_unit(unit).value(), 1), 1) << unit;
  }
}

/// 10^1.5 and 10^2.4: pow() is right to rounding.
TEST(ScaleFactor, HoldsForAnyScale) {
  EXPECT_NEAR(scale_factor({1, -0.5, -2}, 10), 31.6227766016838, 1e-11);
  EXPECT_NEAR(scale_factor({1, 0.4, -2}, 10), 251.188643150958, 1e-10);
}

}  // namespace unit_test
