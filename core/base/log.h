#pragma once
/// Logging: one logger per program run, handed to whoever speaks. Repeated warnings are counted and shown once.
#include <spdlog/logger.h>

#include <map>
#include <memory>
#include <string>

#include "core/base/state.h"

namespace nilas {

/// Treatment of an existing log file.
enum class LogFile { replace, append };

/// A logger that writes to the console (stderr) at `level` and, when `file` is not empty, everything to that file.
/// Levels: trace debug info warn error off. Throws FileError when the file cannot be opened.
std::shared_ptr<spdlog::logger> make_logger(const std::string& level, const std::string& file,
                                            LogFile existing = LogFile::replace);

/// Warnings by kind: the first of a kind is logged, all are counted.
class WarningCounts {
 public:
  explicit WarningCounts(std::shared_ptr<spdlog::logger> logger) : logger_(std::move(logger)) {}
  void warn(const std::string& kind, const std::string& message);
  /// Logs how often each kind occurred beyond the first.
  void summarise() const;
  const std::map<std::string, long>& counts() const { return counts_; }

  void save(StateWriter out) const;
  /// Counts earlier warnings as already reported.
  void restore(const StateReader& in);

 private:
  std::shared_ptr<spdlog::logger> logger_;
  std::map<std::string, long> counts_;
};

}  // namespace nilas
