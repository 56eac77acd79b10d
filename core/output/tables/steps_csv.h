#pragma once
/// steps.csv: solution, accounts of energy and momentum, and timing of each step. Columns: docs/reference/outputs.md.
#include <filesystem>

#include "core/output/file/csv_row.h"
#include "core/output/file/output_file.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

class StepsCsv {
 public:
  /// Opens the file. `keep`: as in OutputFile. Throws FileError, InputError.
  StepsCsv(const std::filesystem::path& path, const sim::RunInfo& info, std::optional<std::int64_t> keep = {});
  /// Writes a row, with the fewest digits that read back to the same bits. Throws FileError.
  void row(const sim::StepRecord& record);
  void finish() { file_.close(); }
  const OutputFile& file() const { return file_; }

 private:
  void add_ledger(const sim::Ledger& ledger);

  OutputFile file_;
  CsvRow row_;
  std::size_t num_works_;
  bool elastic_;
  std::size_t num_module_values_;
};

}  // namespace nilas::output
