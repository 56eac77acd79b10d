#pragma once
/// parts.csv: the joints of the vessel's parts, the contact loads on them and the rods, one row per step. Columns:
/// docs/reference/outputs.md.
#include <filesystem>
#include <string>
#include <vector>

#include "core/output/file/csv_row.h"
#include "core/output/file/output_file.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

/// The columns: time_s, then those of each part with its name in front, as rudder_joint_fx_N, then one per rod, as
/// rod_tie_N.
std::vector<std::string> part_columns(const std::vector<sim::PartInfo>& parts, const std::vector<std::string>& rods);

class PartsCsv {
 public:
  /// Opens the file. `keep`: as in OutputFile. Throws FileError, InputError.
  PartsCsv(const std::filesystem::path& path, const sim::RunInfo& info, std::optional<std::int64_t> keep = {});
  /// Throws FileError.
  void row(double t, const sim::VesselRecord& vessel);
  void finish() { file_.close(); }
  const OutputFile& file() const { return file_; }

 private:
  OutputFile file_;
  std::vector<sim::PartInfo> parts_;
  Eigen::Index rods_;
  CsvRow row_;
};

}  // namespace nilas::output
