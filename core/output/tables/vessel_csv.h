#pragma once
/// vessel.csv: loads on the vessel and its motion, one row per step. Columns: docs/reference/outputs.md.
#include <filesystem>
#include <vector>

#include "core/output/file/csv_row.h"
#include "core/output/file/output_file.h"
#include "core/output/tables/vessel_channels.h"

namespace nilas::output {

class VesselCsv {
 public:
  /// Opens the file. `keep`: as in OutputFile. Throws FileError, InputError.
  VesselCsv(const std::filesystem::path& path, const VesselChannels& channels, std::optional<std::int64_t> keep = {});
  /// Writes a row. `values`: as read from the channels. Throws FileError.
  void row(double t, const std::vector<double>& values);
  void finish() { file_.close(); }
  const OutputFile& file() const { return file_; }

 private:
  OutputFile file_;
  CsvRow row_;
};

}  // namespace nilas::output
