#pragma once
/// events.csv: one row per floe that broke. Columns: docs/reference/outputs.md.
#include <filesystem>
#include <optional>
#include <vector>

#include "core/output/file/output_file.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

class EventsCsv {
 public:
  /// Opens the file. `keep`: as in OutputFile. Throws FileError, InputError.
  explicit EventsCsv(const std::filesystem::path& path, std::optional<std::int64_t> keep = {});
  /// Writes the events of one step. Throws FileError.
  void rows(const std::vector<fracture::FractureEvent>& events);
  void finish() { file_.close(); }
  const OutputFile& file() const { return file_; }

 private:
  OutputFile file_;
};

}  // namespace nilas::output
