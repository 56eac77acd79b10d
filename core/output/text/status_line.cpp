#include "core/output/text/status_line.h"

#include <spdlog/sinks/base_sink.h>

#include <utility>

namespace nilas::output {

namespace {

constexpr const char* k_erase = "\r\x1b[K";

/// Sink before the sinks that write, so that the line is erased first.
class LineEraser : public spdlog::sinks::base_sink<std::mutex> {
 public:
  explicit LineEraser(std::shared_ptr<StatusLine> line) : line_(std::move(line)) {}

 private:
  void sink_it_(const spdlog::details::log_msg&) override { line_->erase(); }
  void flush_() override {}

  std::shared_ptr<StatusLine> line_;
};

}  // namespace

void StatusLine::draw(const std::string& text) {
  const std::lock_guard hold(mutex_);
  out_ << k_erase << text << std::flush;
  shown_ = true;
}

void StatusLine::erase() {
  const std::lock_guard hold(mutex_);
  if (!shown_) return;
  out_ << k_erase << std::flush;
  shown_ = false;
}

void make_room(spdlog::logger& logger, std::shared_ptr<StatusLine> line) {
  auto eraser = std::make_shared<LineEraser>(std::move(line));
  if (!logger.sinks().empty()) eraser->set_level(logger.sinks().front()->level());
  logger.sinks().insert(logger.sinks().begin(), std::move(eraser));
}

}  // namespace nilas::output
