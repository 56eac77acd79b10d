#pragma once
/// bodies.csv: pose and velocity of every body, one row per body and instant. Columns: docs/reference/outputs.md.
#include <filesystem>
#include <string>

#include "core/bodies/bodies.h"
#include "core/output/file/output_file.h"

namespace nilas::output {

/// Number of bodies up to which the file is written by default.
constexpr int k_bodies_csv_default_limit = 200;

class BodiesCsv {
 public:
  /// Opens the file. `keep`: as in OutputFile. Throws FileError, InputError.
  explicit BodiesCsv(const std::filesystem::path& path, std::optional<std::int64_t> keep = {});
  /// Writes all bodies at time t [s] with 17 significant digits. The rows of one instant are written together. Throws
  /// FileError.
  void rows(double t, const bodies::Bodies& bodies);
  void finish() { file_.close(); }
  const OutputFile& file() const { return file_; }

 private:
  OutputFile file_;
  std::string block_;
};

}  // namespace nilas::output
