#include "core/output/loads/step_series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "tests/core/output/sample_run.h"
#include "tests/support/file_text.h"
#include "tests/support/refusal.h"
#include "tests/support/size_limit.h"

namespace nilas::output {
namespace step_series_test {

namespace fs = std::filesystem;
using test::ScratchFolder;

constexpr std::size_t k_columns = 3, k_block = StepSeries::k_block;
constexpr std::size_t k_bytes = sizeof(double) * k_columns * k_block;  // of a block

double number(std::size_t row, std::size_t column) {
  if (row == 7 && column == 1) return -std::numeric_limits<double>::infinity();
  return std::sin(static_cast<double>(k_columns * row + column));
}

void add_rows(StepSeries& series, std::size_t to) {
  for (std::size_t row = series.rows(); row < to; ++row)
    series.append({number(row, 0), number(row, 1), number(row, 2)});
}

/// Some ranges within blocks, at their borders, across them and beyond the end.
void expect_numbers(const StepSeries& series, std::size_t rows) {
  ASSERT_EQ(series.rows(), rows);
  for (const auto& [first, last] : std::vector<std::pair<std::size_t, std::size_t>>{{0, rows},
                                                                                    {0, 0},
                                                                                    {3, k_block - 1},
                                                                                    {k_block - 1, 2 * k_block + 1},
                                                                                    {k_block, 2 * k_block},
                                                                                    {rows, rows + 9},
                                                                                    {rows - 1, rows + 9},
                                                                                    {rows + 1, rows + 2}})
    for (std::size_t c = 0; c < k_columns; ++c) {
      std::vector<double> expected;
      for (std::size_t row = first; row < std::min(last, rows); ++row) expected.push_back(number(row, c));
      EXPECT_EQ(series.column(c, first, last), expected) << first << " to " << last;
    }
}

TEST(StepSeries, HasTheSameNumbersInMemoryAndInAFile) {
  const ScratchFolder folder;
  for (const std::size_t rows : {2 * k_block + 100, 3 * k_block}) {
    StepSeries memory(k_columns), file(k_columns, folder / "s.bin", {});
    for (StepSeries* each : {&memory, &file}) {
      add_rows(*each, rows);
      expect_numbers(*each, rows);
    }
    EXPECT_EQ(memory.file(), nullptr);
    EXPECT_EQ(fs::file_size(folder / "s.bin"), k_bytes * (rows / k_block));
  }
}

/// What a state holds is all that the table has in memory.
TEST(StepSeries, HoldsLessThanABlockInMemoryHoweverManyRowsThereAre) {
  const ScratchFolder folder;
  StepSeries series(k_columns, folder / "s.bin", {});
  for (std::size_t blocks = 1; blocks < 40; ++blocks) {
    add_rows(series, blocks * k_block + k_block - 1);
    State state;
    series.save(StateWriter(state));
    std::vector<double> rest;
    StateReader(state).get("rest", rest);
    EXPECT_EQ(rest.size(), k_columns * (k_block - 1));
    EXPECT_EQ(fs::file_size(folder / "s.bin"), k_bytes * blocks);
  }
}

TEST(StepSeries, GoesOnAsSaved) {
  const ScratchFolder folder;
  State state;
  const std::size_t saved = 2 * k_block + 30;
  {
    StepSeries series(k_columns, folder / "s.bin", {});
    add_rows(series, saved);
    series.save(StateWriter(state));
    add_rows(series, 5 * k_block);
  }
  StepSeries rest(k_columns, folder / "s.bin", 2 * k_bytes);
  EXPECT_EQ(fs::file_size(folder / "s.bin"), 2 * k_bytes) << "later blocks are cut off";
  rest.restore(StateReader(state), saved);
  expect_numbers(rest, saved);
  add_rows(rest, 4 * k_block + 1);
  expect_numbers(rest, 4 * k_block + 1);
}

TEST(StepSeries, RefusesAFileThatIsNotWhatItWas) {
  const ScratchFolder folder;
  const fs::path file = folder / "s.bin";
  State state;
  const std::size_t saved = 3 * k_block + 1;
  {
    StepSeries series(k_columns, file, {});
    add_rows(series, saved);
    series.save(StateWriter(state));
  }
  const std::string bytes = test::read_text(file);
  const auto resume = [&] { StepSeries(k_columns, file, 3 * k_bytes).restore(StateReader(state), saved); };
  EXPECT_NO_THROW(resume());
  for (const std::size_t place : {std::size_t{0}, k_bytes + 5, 3 * k_bytes - 1}) {
    std::string other = bytes;
    other[place] = static_cast<char>(other[place] ^ 1);
    std::ofstream(file, std::ios::binary) << other;
    test::expect_refusal(resume, {"s.bin: has changed since the checkpoint was written, or is damaged"});
  }
  std::ofstream(file, std::ios::binary) << bytes.substr(0, 3 * k_bytes - 1);
  test::expect_refusal(resume, {"s.bin: holds", "less than"});
  fs::remove(file);
  test::expect_refusal<FileError>(resume, {"s.bin"});
}

TEST(StepSeries, NamesTheFileThatCannotBeWrittenOrRead) {
  const ScratchFolder folder;
  StepSeries series(k_columns, folder / "s.bin", {});
  add_rows(series, k_block);
  {
    const test::SizeLimit limit(k_bytes + 10);
    test::expect_refusal<FileError>([&] { add_rows(series, 2 * k_block); }, {"s.bin: cannot write: "});
  }
  EXPECT_EQ(fs::file_size(folder / "s.bin"), k_bytes) << "whole blocks remain";
  fs::resize_file(folder / "s.bin", 100);
  test::expect_refusal<FileError>([&] { series.column(0, 0, k_block); }, {"s.bin: cannot read: "});
}

}  // namespace step_series_test
}  // namespace nilas::output
