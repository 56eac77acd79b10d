#include "core/hdf5/hdf5_columns.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/size_limit.h"

namespace nilas::hdf5 {
namespace hdf5_columns_test {

using test::ScratchFolder;
using test::SizeLimit;

Hdf5Columns::Layout layout() {
  return {"rows",
          "of a test",
          "blocks",
          "first and last",
          {{"x_m", "m", "a number", std::vector<double>{}}, {"n", "1", "a count", std::vector<std::int64_t>{}}}};
}

/// Block k, from 0, has k rows: numbers that no two rows share.
void add_blocks(Hdf5Columns& columns, int first, int last) {
  for (int k = first; k < last; ++k) {
    for (int row = 0; row < k; ++row) {
      columns.add(k + 0.001 * row);
      columns.add(static_cast<std::int64_t>(1000 * k + row));
      columns.end_row();
    }
    columns.end_block();
  }
}

void expect_blocks(const std::filesystem::path& path, int count) {
  const Hdf5Reader file(path);
  const auto index = whole_blocks(file.wide_integers("blocks"));
  const auto rows = index.empty() ? 0 : static_cast<std::size_t>(index.back());
  const auto n = file.first_integers("rows/n", rows);
  const auto x = file.first_numbers("rows/x_m", rows);
  ASSERT_EQ(index.size(), 2 * static_cast<std::size_t>(count));
  std::int64_t row = 0;
  for (int k = 0; k < count; ++k) {
    const auto b = static_cast<std::size_t>(k);
    ASSERT_EQ(index[2 * b], row);
    ASSERT_EQ(index[2 * b + 1], row + k);
    for (int i = 0; i < k; ++i, ++row) {
      ASSERT_EQ(x.at(static_cast<std::size_t>(row)), k + 0.001 * i);
      ASSERT_EQ(n.at(static_cast<std::size_t>(row)), 1000 * k + i);
    }
  }
}

TEST(Hdf5Columns, WhatIsWrittenIsReadBackAtOnce) {
  const ScratchFolder folder;
  Hdf5Columns columns(folder / "a.h5", layout());
  expect_blocks(folder / "a.h5", 0);
  add_blocks(columns, 0, 1);
  columns.write();
  expect_blocks(folder / "a.h5", 1);
  for (const int end : {2, 3, 30, 31, 60}) {
    add_blocks(columns, static_cast<int>(columns.length().blocks), end);
    columns.write();
    columns.sync();
    expect_blocks(folder / "a.h5", end);
  }
}

TEST(Hdf5Columns, GoesOnFromWhatIsKept) {
  const ScratchFolder folder;
  Hdf5Columns::Length kept;
  {
    Hdf5Columns columns(folder / "a.h5", layout());
    add_blocks(columns, 0, 20);
    kept = columns.length();
    add_blocks(columns, 20, 33);
    columns.write();
  }
  Hdf5Columns columns(folder / "a.h5", layout(), kept);
  expect_blocks(folder / "a.h5", 20);
  add_blocks(columns, 20, 40);
  columns.write();
  expect_blocks(folder / "a.h5", 40);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.h5.part"));
}

TEST(Hdf5Columns, RefusesAFileThatHoldsLess) {
  const ScratchFolder folder;
  {
    Hdf5Columns columns(folder / "a.h5", layout());
    add_blocks(columns, 0, 10);
    columns.write();
  }
  EXPECT_THROW(Hdf5Columns(folder / "a.h5", layout(), Hdf5Columns::Length{11, 55}), InputError);
  EXPECT_THROW(Hdf5Columns(folder / "a.h5", layout(), Hdf5Columns::Length{9, 35}), InputError)
      << "not at a block's end";
  Hdf5Columns::Layout other = layout();
  other.columns[0].name = "y_m";
  EXPECT_THROW(Hdf5Columns(folder / "a.h5", other, Hdf5Columns::Length{9, 36}), InputError);
  expect_blocks(folder / "a.h5", 10);
  folder.write("b.h5", "no HDF5");
  EXPECT_THROW(Hdf5Columns(folder / "b.h5", layout(), Hdf5Columns::Length{1, 0}), InputError);
  EXPECT_THROW(Hdf5Columns(folder / "none.h5", layout(), Hdf5Columns::Length{1, 0}), FileError);
}

/// Wherever the disk becomes full, data written before stays, and the error names the file.
TEST(Hdf5Columns, AFullDiskLeavesTheEarlierBlocks) {
  for (const rlim_t limit : {6000, 8000, 12000, 20000}) {
    SCOPED_TRACE(limit);
    const ScratchFolder folder;
    int written = 0;
    {
      const SizeLimit full(limit);
      try {
        Hdf5Columns columns(folder / "a.h5", layout());
        for (int end = 10; end < 400; end += 10) {
          add_blocks(columns, end - 10, end);
          columns.write();
          written = end;
        }
        FAIL() << "the file grew beyond the limit";
      } catch (const FileError& e) {
        EXPECT_NE(std::string(e.what()).find("a.h5: cannot write: File too large"), std::string::npos) << e.what();
      }
    }
    if (written == 0) continue;
    // the fault may come after the last write was complete
    const auto blocks = static_cast<int>(whole_blocks(Hdf5Reader(folder / "a.h5").wide_integers("blocks")).size() / 2);
    EXPECT_GE(blocks, written);
    EXPECT_LE(blocks, written + 10);
    expect_blocks(folder / "a.h5", blocks);
  }
}

TEST(Hdf5Columns, AFolderThatIsNotThereIsAFileError) {
  EXPECT_THROW(Hdf5Columns("/nowhere/a.h5", layout()), FileError);
}

}  // namespace hdf5_columns_test
}  // namespace nilas::hdf5
