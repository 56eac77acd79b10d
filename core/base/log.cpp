#include "core/base/log.h"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>

#include "core/base/error.h"

namespace nilas {

std::shared_ptr<spdlog::logger> make_logger(const std::string& level, const std::string& file, LogFile existing) {
  auto console = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
  console->set_level(spdlog::level::from_str(level));
  console->set_pattern("%^%l%$: %v");
  auto logger = std::make_shared<spdlog::logger>("nilas", console);
  if (!file.empty()) {
    try {
      auto sink = std::make_shared<spdlog::sinks::basic_file_sink_mt>(file, existing == LogFile::replace);
      sink->set_level(spdlog::level::debug);
      sink->set_pattern("%Y-%m-%d %H:%M:%S.%e %l: %v");
      logger->sinks().push_back(sink);
    } catch (const spdlog::spdlog_ex& e) {
      throw FileError(file + ": cannot write the log: " + e.what());
    }
  }
  logger->set_level(spdlog::level::debug);
  logger->flush_on(spdlog::level::info);
  return logger;
}

void WarningCounts::warn(const std::string& kind, const std::string& message) {
  if (++counts_[kind] == 1) logger_->warn("{}", message);
}

void WarningCounts::summarise() const {
  for (const auto& [kind, count] : counts_)
    if (count > 1) logger_->warn("{}: {} times in all", kind, count);
}

void WarningCounts::save(StateWriter out) const {
  out.add("kinds", counts_.size());
  std::size_t k = 0;
  for (const auto& [kind, count] : counts_) {
    StateWriter entry = out.group(std::to_string(k++));
    entry.add("kind", kind);
    entry.add("count", count);
  }
}

void WarningCounts::restore(const StateReader& in) {
  std::size_t kinds = 0;
  in.get("kinds", kinds);
  counts_.clear();
  for (std::size_t k = 0; k < kinds; ++k) {
    std::string kind;
    in.group(std::to_string(k)).get("kind", kind);
    in.group(std::to_string(k)).get("count", counts_[kind]);
  }
}

}  // namespace nilas
