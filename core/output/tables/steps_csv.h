#pragma once
/// steps.csv: solution, accounts of energy and momentum, and timing of each step. Columns: docs/reference/outputs.md.
#include <filesystem>
#include <string>
#include <vector>

#include "core/output/file/csv_row.h"
#include "core/output/file/output_file.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

/// Names of the columns. `status` is a word and `state_hash`, the last, hexadecimal digits; all others are numbers.
std::vector<std::string> step_columns(const sim::RunInfo& info);
/// The numbers of a step in the order of those columns.
std::vector<double> step_numbers(const sim::RunInfo& info, const sim::StepRecord& record);

class StepsCsv {
 public:
  /// Opens the file. `keep`: as in OutputFile. Throws FileError, InputError.
  StepsCsv(const std::filesystem::path& path, const sim::RunInfo& info, std::optional<std::int64_t> keep = {});
  /// Writes a row, with the fewest digits that read back to the same bits. Throws FileError.
  void row(const sim::StepRecord& record);
  void finish() { file_.close(); }
  const OutputFile& file() const { return file_; }

 private:
  OutputFile file_;
  CsvRow row_;
  sim::RunInfo info_;
};

}  // namespace nilas::output
