/// Tables of studies.
#include "apps/compare/workshop/csv_table.h"

#include <gtest/gtest.h>

#include <limits>

namespace csv_table_test {

using namespace nilas;
using namespace nilas::compare;

TEST(CsvTable, WritesHeaderAndCellsOfEachColumnTogether) {
  struct Row {
    std::string name;
    double value;
  };
  const std::vector<CsvColumn<Row>> columns{{"name", [](const Row& r, CsvCell cell) { cell = r.name; }},
                                            {"value_N", [](const Row& r, CsvCell cell) { cell = r.value; }},
                                            {"large", [](const Row& r, CsvCell cell) { cell = r.value > 1; }}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(csv_text(columns, std::vector<Row>{{"a, b", 2.5}, {"c", nan}}),
            "name,value_N,large\n\"a, b\",2.5,1\nc,,0\n");
}

TEST(CsvTable, ListsAndSentencesHoldNoCommas) {
  EXPECT_EQ(list_text({0, 2}), "0;2");
  EXPECT_EQ(without_commas("a, b"), "a; b");
}

}  // namespace csv_table_test
