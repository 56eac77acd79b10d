/// The cases with known answers: their table, their verdicts, and that a wrong answer is seen.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "apps/verify/setting.h"
#include "apps/verify/verdicts.h"
#include "core/base/error.h"

namespace catalogue_test {

using namespace nilas;
using namespace nilas::verify;

TEST(Catalogue, NamesSixtyCasesWithFormulaSourceAndAnInputThatIsVaried) {
  std::set<int> numbers;
  for (const auto& one : catalogue()) {
    EXPECT_TRUE(numbers.insert(one.number).second) << one.id();
    EXPECT_FALSE(one.title.empty() || one.formula.empty() || one.source.empty()) << one.id();
    bool varies = false;
    for (const auto& input : one.inputs) varies = varies || (input.name == one.varied && input.value != 0);
    EXPECT_TRUE(varies) << one.id();
    EXPECT_TRUE(std::filesystem::exists(verify_scenes() / one.scene)) << one.id();
    EXPECT_FALSE(models_of(one, {}).empty()) << one.id();
  }
  EXPECT_GE(numbers.size(), 60u);
  for (char family = 'A'; family <= 'I'; ++family) EXPECT_FALSE(family_title(family).empty());
}

const Case& numbered(int number) {
  for (const auto& one : catalogue())
    if (one.number == number) return one;
  throw ContractError("no such case");
}

/// The case's own scene and measurement, with a formula that is off by a millionth.
TEST(Verdict, AWrongFormulaFails) {
  Case wrong = numbered(3);
  static std::vector<Quantity> (*right)(const Setting&) = wrong.check;
  for (const auto& row : judge(wrong, {"coulomb", "auto"}, false)) EXPECT_TRUE(row.holds) << row.quantity;
  wrong.check = [](const Setting& s) {
    auto found = right(s);
    found.front().expected *= 1 + 1e-6;
    return found;
  };
  const auto rows = judge(wrong, {"coulomb", "auto"}, false);
  EXPECT_FALSE(rows.front().holds);
  EXPECT_NEAR(rows.front().error, 1e-6, 1e-8);
}

TEST(Verdict, AVariedInputChangesWhatIsExpected) {
  const auto given = judge(numbered(3), {"coulomb", "auto"}, false),
             varied = judge(numbered(3), {"coulomb", "auto"}, true);
  EXPECT_LT(varied.front().expected, 0.95 * given.front().expected);
  EXPECT_TRUE(varied.front().holds);
  EXPECT_EQ(varied.front().input, "mu x 1.1");
}

/// Errors that fall with the first power are no second order.
TEST(Verdict, TheOrderIsMeasured) {
  Case slow = numbered(27);
  slow.check = [](const Setting& s) { return std::vector<Quantity>{{"first order", 1 + 0.3 * s.h(), 1}}; };
  const auto rows = judge(slow, {"coulomb", "auto", "semi-implicit-euler", 0.08}, false);
  EXPECT_NEAR(rows.front().order, 1, 1e-9);
  EXPECT_FALSE(rows.front().holds);
  slow.check = [](const Setting& s) { return std::vector<Quantity>{{"second order", 1 + 0.3 * s.h() * s.h(), 1}}; };
  const auto second = judge(slow, {"coulomb", "auto", "semi-implicit-euler", 0.08}, false);
  EXPECT_NEAR(second.front().order, 2, 1e-6);
  EXPECT_TRUE(second.front().holds);
  EXPECT_DOUBLE_EQ(second.front().model.step, 0.005);
}

TEST(Verdict, WhatIsNotANumberFails) {
  Case broken = numbered(3);
  broken.check = [](const Setting&) {
    return std::vector<Quantity>{{"nothing", std::nan(""), 1}, {"no", 1, std::nan("")}};
  };
  for (const auto& row : judge(broken, {"coulomb", "auto"}, false)) EXPECT_FALSE(row.holds);
}

TEST(Selection, ThreadsGiveTheSameRows) {
  Selection some;
  some.cases = {"A3", "D41"};
  const auto one = nilas::verify::verify(some, 1, {}), two = nilas::verify::verify(some, 2, {});
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].measured, two[k].measured);
    EXPECT_EQ(one[k].quantity, two[k].quantity);
  }
}

TEST(Selection, WhatIsUnknownIsNamed) {
  EXPECT_THROW(nilas::verify::verify({{"Z9"}, {}, {}}, 1, {}), InputError);
  EXPECT_THROW(nilas::verify::verify({{}, {"newtn"}, {}}, 1, {}), InputError);
  EXPECT_THROW(nilas::verify::verify({{"D35"}, {"newton"}, {}}, 1, {}), InputError);
}

}  // namespace catalogue_test
