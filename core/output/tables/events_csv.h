#pragma once
/// events.csv: floes that broke, a row each. Columns: docs/reference/outputs.md.
#include <filesystem>
#include <optional>
#include <vector>

#include "core/output/file/output_file.h"
#include "core/sim/account/step_record.h"

namespace nilas {

class EventsCsv {
 public:
  /// `keep`: as of OutputFile. Throws FileError, InputError.
  explicit EventsCsv(const std::filesystem::path& path, std::optional<std::int64_t> keep = {});
  /// Those of one step. Throws FileError.
  void rows(const std::vector<FractureEvent>& events);
  void finish() { file_.close(); }
  const OutputFile& file() const { return file_; }

 private:
  OutputFile file_;
};

}  // namespace nilas
