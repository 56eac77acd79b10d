#pragma once
/// structures.csv: loads on the bodies that the scene holds fixed, one row per step. Columns:
/// docs/reference/outputs.md.
#include <filesystem>

#include "core/output/file/csv_row.h"
#include "core/output/file/output_file.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

class StructuresCsv {
 public:
  /// Opens the file. `keep`: as in OutputFile. Throws FileError, InputError.
  StructuresCsv(const std::filesystem::path& path, const sim::RunInfo& info, std::optional<std::int64_t> keep = {});
  /// Throws FileError.
  void row(const sim::StepRecord& record);
  void finish() { file_.close(); }
  const OutputFile& file() const { return file_; }

 private:
  OutputFile file_;
  CsvRow row_;
  Vec2 course_;
};

}  // namespace nilas::output
