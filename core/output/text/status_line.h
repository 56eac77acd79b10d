#pragma once
/// The line of a terminal that is drawn again and again and gives way to what else is printed.
#include <spdlog/logger.h>

#include <memory>
#include <mutex>
#include <ostream>
#include <string>

namespace nilas {

/// May be used from several threads.
class StatusLine {
 public:
  /// `out` must outlive the line.
  explicit StatusLine(std::ostream& out) : out_(out) {}

  void draw(const std::string& text);
  /// Nothing where none is shown.
  void erase();

 private:
  std::ostream& out_;
  std::mutex mutex_;
  bool shown_ = false;
};

/// Makes `logger` erase the line before its messages.
void make_room(spdlog::logger& logger, std::shared_ptr<StatusLine> line);

}  // namespace nilas
