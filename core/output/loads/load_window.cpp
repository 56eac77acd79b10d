#include "core/output/loads/load_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nilas::output {

namespace {

/// Tolerance for the rounding of sums of many steps against times that a user names.
constexpr double k_rounding = 1e-6;  // share of a step

/// Number of steps that end at or before `t`.
std::size_t steps_until(const LoadCourse& course, double t) {
  const double count = std::floor((t - course.start) / course.h + k_rounding);
  return static_cast<std::size_t>(std::clamp(count, 0.0, static_cast<double>(course.steps)));
}

LoadWindow from_to(const LoadCourse& course, double from, double to, const std::string& reason) {
  LoadWindow window;
  window.first = steps_until(course, from);
  window.last = std::max(window.first, steps_until(course, to));
  window.from = course.start + static_cast<double>(window.first) * course.h;
  window.to = course.start + static_cast<double>(window.last) * course.h;
  window.reason = reason;
  return window;
}

}  // namespace

std::vector<double> LoadWindow::of(const std::vector<double>& series) const {
  const auto end = std::min(last, series.size()), begin = std::min(first, end);
  return {series.begin() + static_cast<std::ptrdiff_t>(begin), series.begin() + static_cast<std::ptrdiff_t>(end)};
}

LoadWindow load_window(const LoadCourse& course) {
  const double end = course.start + static_cast<double>(course.steps) * course.h;
  if (course.asked) {
    LoadWindow window = from_to(course, course.asked->at(0), course.asked->at(1), "as asked");
    const double least = k_rounding * course.h;
    if (course.ramp_end && window.from < *course.ramp_end - least)
      window.reason += fmt::format("; it holds the ramp (to {:g} s)", *course.ramp_end);
    if (course.first_ice && window.from < *course.first_ice - least)
      window.reason += fmt::format("; ice first touches at {:g} s", *course.first_ice);
    if (window.steps() > 0) return window;
    return from_to(course, course.start, end,
                   fmt::format("the whole run, which has no step in the window asked for, {:g} to {:g} s",
                               course.asked->at(0), course.asked->at(1)));
  }
  const bool ramp_ends = course.ramp_end && *course.ramp_end < end - k_rounding * course.h;
  if (course.ramp_end && !ramp_ends)
    return from_to(
        course, course.first_ice.value_or(course.start), end,
        fmt::format("{}; the ramp lasts until {:g} s, so the speed still rises",
                    course.first_ice ? "from the first contact with ice" : "the whole run", *course.ramp_end));
  if (course.first_ice && (!ramp_ends || *course.first_ice > *course.ramp_end))
    return from_to(course, *course.first_ice, end, "from the first contact with ice");
  if (ramp_ends) return from_to(course, *course.ramp_end, end, "from the end of the ramp");
  return from_to(course, course.start, end, "the whole run");
}

}  // namespace nilas::output
