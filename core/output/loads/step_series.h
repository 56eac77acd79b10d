#pragma once
/// Numbers of every step of a run, of which its statistics are made at the end.
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/hash.h"
#include "core/base/state.h"
#include "core/output/file/output_file.h"
#include "core/output/loads/load_window.h"

namespace nilas::output {

/// A table with a row per step. With a file, whole blocks of rows stand in the file, so that memory does not grow with
/// the rows. A block holds its columns one after another as 64-bit numbers, so that a column is read by itself.
class StepSeries {
 public:
  static constexpr std::size_t k_block = 512;  ///< rows of a block

  /// A table that stays in memory.
  explicit StepSeries(std::size_t columns) : columns_(columns) {}
  /// A table in a file; `keep` as in OutputFile, after which restore() must be called. Throws as OutputFile.
  StepSeries(std::size_t columns, const std::filesystem::path& file, std::optional<std::int64_t> keep);

  /// Adds a row with a number per column. Throws FileError.
  void append(const std::vector<double>& row);
  std::size_t rows() const { return rows_; }
  /// The numbers of a column in the rows first .. last - 1, as far as there are such. Throws FileError.
  std::vector<double> column(std::size_t column, std::size_t first, std::size_t last) const;
  /// The file; null for a table in memory.
  const OutputFile* file() const { return file_.get(); }

  /// Saves the rows that are in memory, and a checksum of those in the file.
  void save(StateWriter out) const;
  /// Restores a table of so many rows. Throws FileError; throws InputError where the file does not hold what it held
  /// when the state was saved.
  void restore(const StateReader& in, std::size_t rows);

 private:
  void write_block();

  std::size_t columns_, rows_ = 0;
  std::unique_ptr<OutputFile> file_;
  std::size_t blocks_ = 0;    ///< in the file
  StateHash hash_;            ///< of their numbers
  std::vector<double> rest_;  ///< the rows after them, one after another
};

/// Neighbouring columns of a table, which must outlive it.
class SeriesPart {
 public:
  SeriesPart(const StepSeries& table, std::size_t first) : table_(&table), first_(first) {}
  /// The numbers of a column over the steps of a window. Throws FileError.
  std::vector<double> over(const LoadWindow& window, std::size_t column) const {
    return table_->column(first_ + column, window.first, window.last);
  }

 private:
  const StepSeries* table_;
  std::size_t first_;
};

}  // namespace nilas::output
