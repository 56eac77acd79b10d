#pragma once
/// The status line of a terminal, which is redrawn and gives way to other output.
#include <spdlog/logger.h>

#include <memory>
#include <mutex>
#include <ostream>
#include <string>

namespace nilas::output {

/// The status line; may be used from several threads.
class StatusLine {
 public:
  /// `out` must outlive the line.
  explicit StatusLine(std::ostream& out) : out_(out) {}

  void draw(const std::string& text);
  /// Erases the line if one is shown.
  void erase();

 private:
  std::ostream& out_;
  std::mutex mutex_;
  bool shown_ = false;
};

/// Makes `logger` erase the line before its messages.
void make_room(spdlog::logger& logger, std::shared_ptr<StatusLine> line);

}  // namespace nilas::output
