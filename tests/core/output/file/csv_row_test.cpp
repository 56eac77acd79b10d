#include "core/output/file/csv_row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace nilas::output {
namespace csv_row_test {

TEST(CsvRow, FixedPointHasTwelveDecimalsAndNoSignOnZero) {
  CsvRow row;
  row.fixed(0.01).fixed(-1.5).fixed(-1e-13).fixed(-0.0).fixed(-6e-13);
  EXPECT_EQ(row.line(), "0.010000000000,-1.500000000000,0.000000000000,0.000000000000,-0.000000000001\n");
}

TEST(CsvRow, FixedPointHoldsTheLargestNumber) {
  CsvRow row;
  row.fixed(std::numeric_limits<double>::max());
  EXPECT_EQ(row.line().size(), 309u + 1 + 12 + 1);
}

TEST(CsvRow, ShortAndFullNumbersReadBackToTheSameBits) {
  for (const double x : {0.1, 1.0 / 3, 1e-300, -6.02214076e23, std::numeric_limits<double>::denorm_min()}) {
    CsvRow shortest, full;
    shortest.shortest(x);
    full.full(x);
    EXPECT_EQ(std::strtod(std::string(shortest.line()).c_str(), nullptr), x);
    EXPECT_EQ(std::strtod(std::string(full.line()).c_str(), nullptr), x);
  }
  CsvRow row;
  row.shortest(0.1).full(0.1).integer(-7).hexadecimal(0xabc);
  EXPECT_EQ(row.line(), "0.1,0.10000000000000001,-7,0000000000000abc\n");
}

TEST(CsvRow, WordsWithSeparatorsAreQuoted) {
  CsvRow row;
  row.text("floe 1").text("a,b").text("say \"ice\"");
  EXPECT_EQ(row.line(), "floe 1,\"a,b\",\"say \"\"ice\"\"\"\n");
}

TEST(CsvRow, StartsAnewAfterClear) {
  CsvRow row;
  row.integer(1).line();
  row.clear();
  row.integer(2);
  EXPECT_EQ(row.line(), "2\n");
}

}  // namespace csv_row_test
}  // namespace nilas::output
