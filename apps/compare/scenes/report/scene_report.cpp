#include "apps/compare/scenes/report/scene_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/compare/scenes/judge/ranking.h"
#include "core/output/loads/ice_load_text.h"

namespace nilas::compare {

std::string SceneReport::label(std::size_t setting) const {
  return label_of(study.plan.settings[setting], study.plan.settings.front());
}

std::string SceneReport::quoted_label(std::size_t setting) const {
  return setting == 0 ? "the scene's own setting" : '"' + label(setting) + '"';
}

std::vector<std::string> SceneReport::labels() const {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < study.plan.settings.size(); ++k) all.push_back(label(k));
  return all;
}

bool SceneReport::compared() const { return anything_compared(found.merits); }

std::string window_text(const SceneReport& report) {
  const Findings& found = report.found;
  const Plan& plan = report.study.plan;
  double from = plan.end, latest = plan.start, to = plan.end;
  for (const int r : found.shared) {
    if (!found.measure.is_load() || static_cast<std::size_t>(r) >= found.windows.size() || !found.windows[r]) continue;
    from = std::min(from, found.windows[r]->from);
    latest = std::max(latest, found.windows[r]->from);
    to = found.windows[r]->to;
  }
  if (!(from < to)) return fmt::format("{} to {} s", moment_text(plan.start), moment_text(plan.end));
  const std::string later =
      latest > from ? fmt::format(" (other realisations begin at up to {} s)", moment_text(latest)) : "";
  return fmt::format("{} to {} s{}", moment_text(from), moment_text(to), later);
}

std::string moment_text(double time) { return fmt::format("{:.5g}", time); }

/// The unit of the third digit of a value: 0.1 for 12.3; 0 for 0.
static double third_digit(double value) { return std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2); }

std::string three_digits(double value) {
  constexpr double k_whole = 999.5, k_plain = 1e6;
  const double size = std::abs(value);
  if (!(size >= k_whole && size < k_plain)) return fmt::format("{:.3g}", value);
  const double unit = third_digit(value);
  return fmt::format("{:.0f}", std::round(value / unit) * unit);
}

std::string quantity_text(double value, const std::string& unit) {
  if (!std::isfinite(value)) return "not known";
  if (unit == "N") {
    const output::ForceUnit readable = output::force_unit(value);
    return fmt::format("{} {}", three_digits(value / readable.size), readable.name);
  }
  const double size = std::abs(value);
  if (unit == "m" && size > 0 && size < 0.1)
    return size < 1e-4 ? fmt::format("{:.3g} um", 1e6 * value) : fmt::format("{:.3g} mm", 1e3 * value);
  return fmt::format("{:.3g} {}", value, unit);
}

std::string uncertainty_text(double value, double uncertainty, const std::string& unit) {
  constexpr double k_half = 0.5;
  if (!std::isfinite(uncertainty) || uncertainty < k_half * third_digit(value)) return "";
  return " +- " + (unit.empty() ? fmt::format("{:.2g}", uncertainty) : quantity_text(uncertainty, unit));
}

std::string percent_text(double share) { return fmt::format("{:.3g} %", 100 * share); }

}  // namespace nilas::compare
