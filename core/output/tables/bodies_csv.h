#pragma once
/// bodies.csv: pose and velocity of every body, one row per body and instant. Columns: docs/reference/outputs.md.
#include <filesystem>
#include <string>

#include "core/bodies/bodies.h"
#include "core/output/file/output_file.h"

namespace nilas {

/// Written by default up to so many bodies.
constexpr int k_bodies_csv_default_limit = 200;

class BodiesCsv {
 public:
  /// `keep`: as of OutputFile. Throws FileError, InputError.
  explicit BodiesCsv(const std::filesystem::path& path, std::optional<std::int64_t> keep = {});
  /// All bodies at time t [s], 17 significant digits. The rows of one instant reach the file together. Throws
  /// FileError.
  void rows(double t, const Bodies& bodies);
  void finish() { file_.close(); }
  const OutputFile& file() const { return file_; }

 private:
  OutputFile file_;
  std::string block_;
};

}  // namespace nilas
