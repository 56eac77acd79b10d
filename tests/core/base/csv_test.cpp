#include "core/base/csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "tests/support/refusal.h"
#include "tests/support/scratch_folder.h"

namespace nilas {
namespace csv_test {

class CsvTest : public testing::Test {
 protected:
  std::string write(const std::string& text) {
    file_ = folder_.write("table.csv", text).string();
    return file_;
  }
  /// The message of the InputError that reading `text` with columns a, b must give.
  std::string fault(const std::string& text) {
    const std::string message = test::refusal([&] { read_csv(write(text), {"alpha", "beta"}); });
    EXPECT_EQ(message.rfind(file_, 0), 0U) << message << ": " << text;
    return message.substr(std::min(file_.size(), message.size()));
  }

  const test::ScratchFolder folder_;
  std::string file_;
};

TEST_F(CsvTest, ReadsNumbersInTheOrderAskedFor) {
  const auto table =
      read_csv(write("\xEF\xBB\xBF# towing tank\r\n beta , alpha\r\n\r\n1e-3, -2.5\r\n+7,8\n"), {"alpha", "beta"});
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0], (std::vector<double>{-2.5, 1e-3}));
  EXPECT_EQ(table.rows[1], (std::vector<double>{8, 7}));
  EXPECT_EQ(table.lines, (std::vector<int>{4, 5}));
}

TEST_F(CsvTest, LastLineNeedsNoEnd) {
  EXPECT_EQ(read_csv(write("alpha,beta\n1,2"), {"alpha", "beta"}).rows.size(), 1U);
}

TEST_F(CsvTest, NamesThePlaceOfAFault) {
  EXPECT_EQ(fault("alpha,beta\n1,x2\n"), ":2:3: 'x2' is no finite number");
  EXPECT_EQ(fault("alpha,beta\n1,2\n\n3, 4 5\n"), ":4:4: '4 5' is no finite number");
  EXPECT_EQ(fault("alpha,beta\n1,nan\n"), ":2:3: 'nan' is no finite number");
  EXPECT_EQ(fault("alpha,beta\n1,1e999\n"), ":2:3: '1e999' is no finite number");
  EXPECT_EQ(fault("alpha,beta\n1,\n"), ":2:3: '' is no finite number");
}

TEST_F(CsvTest, CountsFields) {
  EXPECT_NE(fault("alpha,beta\n1,2,3\n").find(":2:5: found 3 fields, expected 2"), std::string::npos);
  EXPECT_NE(fault("alpha,beta\n1\n").find(":2:1: found 1 fields, expected 2"), std::string::npos);
}

TEST_F(CsvTest, ChecksTheHeader) {
  EXPECT_NE(fault("alpha,bata\n1,2\n").find(":1:7: unknown column 'bata'"), std::string::npos);
  EXPECT_NE(fault("alpha,bata\n1,2\n").find("did you mean 'beta'?"), std::string::npos);
  EXPECT_NE(fault("alpha,alpha\n1,2\n").find(":1:7: column 'alpha' stands twice"), std::string::npos);
  EXPECT_NE(fault("alpha\n1\n").find(":1:1: column 'beta' is missing"), std::string::npos);
  EXPECT_NE(fault("1,2\n").find(":1:1: unknown column '1'"), std::string::npos);
}

TEST_F(CsvTest, RefusesTablesWithoutRows) {
  EXPECT_NE(fault("").find("empty; expected the header alpha,beta"), std::string::npos);
  EXPECT_NE(fault("alpha,beta\n").find("no rows"), std::string::npos);
}

TEST_F(CsvTest, UnreadableFilesAreFileErrors) {
  EXPECT_THROW(read_csv((folder_ / "no_such_file.csv").string(), {"alpha"}), FileError);
  EXPECT_THROW(read_csv(folder_.path().string(), {"alpha"}), FileError);
}

TEST_F(CsvTest, QuotedFieldsHoldCommasAndQuotes) {
  CsvLine line;
  line.split("a,\"b, \"\"c\"\"\",,d");
  ASSERT_EQ(line.size(), 4U);
  EXPECT_EQ(line[1], "b, \"c\"");
  EXPECT_EQ(line[2], "");
  EXPECT_EQ(line[3], "d");
  EXPECT_EQ(line.column(3), 15U);
}

TEST_F(CsvTest, ALineLongerThanAnyTableHasIsRefused) {
  const std::string file = write("t,x\n1,2\n" + std::string(100000, ',') + "\n");
  test::expect_refusal([&] { read_csv(file, {"t", "x"}); }, {":3:1:", "more than 65536 bytes"});
}

TEST_F(CsvTest, ColumnsOfARunEndWithItsLastCompleteRow) {
  const auto file = write("t,\"name, with comma\",x\n1,\"p,q\",2\n3,r,word\n5,s,6");
  const auto columns = csv_columns(file, {"x", "t"});
  ASSERT_EQ(columns[0].size(), 2U);
  EXPECT_EQ(columns[0][0], 2);
  EXPECT_TRUE(std::isnan(columns[0][1])) << "no number";
  EXPECT_EQ(columns[1], (std::vector<double>{1, 3}));
  EXPECT_THROW(csv_columns(file, {"y"}), InputError);
  EXPECT_THROW(csv_columns((folder_ / "no_such_file.csv").string(), {"x"}), FileError);
}

TEST_F(CsvTest, RecordsAreCompleteRowsAsText) {
  const auto records = csv_records(write("a,b\n1,\"x,y\"\n2"));
  EXPECT_EQ(records.header, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(records.rows.size(), 1U);
  EXPECT_EQ(records.rows[0], (std::vector<std::string>{"1", "x,y"}));
  EXPECT_EQ(records.bytes, 12);
}

}  // namespace csv_test
}  // namespace nilas
