#include "core/output/text/phase_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nilas::output {

PhaseLines::PhaseLines(ConsoleStyle style, std::string phase, double now, const PhaseTimes& times)
    : times_(times),
      pause_(style == ConsoleStyle::terminal ? times.redraw : times.again),
      phase_(std::move(phase)),
      first_(now + times.first),
      since_(now),
      due_(first_) {}

void PhaseLines::next(std::string phase, double now) {
  phase_ = std::move(phase);
  since_ = now;
  due_ = std::max(first_, now + times_.settle);
}

std::optional<std::string> PhaseLines::line(double now) {
  if (now < due_) return std::nullopt;
  due_ = now + pause_;
  const double so_far = now - since_;
  return phase_ + (so_far < 1 ? "" : ", " + duration_text(std::floor(so_far)) + " so far");
}

}  // namespace nilas::output
