#pragma once
/// parts.csv: the joints of the vessel's parts and the contact loads on them, one row per step. Columns:
/// docs/output_reference.md.
#include <filesystem>
#include <string>
#include <vector>

#include "core/output/csv_row.h"
#include "core/output/output_file.h"
#include "core/sim/step_record.h"

namespace nilas {

/// time_s, then for each part its columns behind its name, as rudder_joint_fx_N.
std::vector<std::string> part_columns(const std::vector<PartInfo>& parts);

class PartsCsv {
 public:
  /// `keep`: as of OutputFile. Throws FileError, InputError.
  PartsCsv(const std::filesystem::path& path, const RunInfo& info, std::optional<std::int64_t> keep = {});
  /// Throws FileError.
  void row(double t, const std::vector<PartRecord>& parts);
  void finish() { file_.close(); }
  const OutputFile& file() const { return file_; }

 private:
  OutputFile file_;
  std::vector<PartInfo> parts_;
  CsvRow row_;
};

}  // namespace nilas
