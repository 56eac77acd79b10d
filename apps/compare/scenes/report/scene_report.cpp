#include "apps/compare/scenes/report/scene_report.h"

#include <fmt/format.h>

#include "apps/compare/scenes/judge/ranking.h"
#include "core/output/loads/ice_load_text.h"

namespace nilas::compare {

std::string SceneReport::label(std::size_t setting) const {
  return label_of(study.plan.settings[setting], study.plan.settings.front());
}

std::vector<std::string> SceneReport::labels() const {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < study.plan.settings.size(); ++k) all.push_back(label(k));
  return all;
}

bool SceneReport::compared() const { return anything_compared(found.merits); }

std::string quantity_text(double value, const std::string& unit) {
  if (!std::isfinite(value)) return "not known";
  if (unit == "N") return output::force_text(value);
  const double size = std::abs(value);
  if (unit == "m" && size > 0 && size < 0.1)
    return size < 1e-4 ? fmt::format("{:.3g} um", 1e6 * value) : fmt::format("{:.3g} mm", 1e3 * value);
  return fmt::format("{:.3g} {}", value, unit);
}

std::string percent_text(double share) { return fmt::format("{:.3g} %", 100 * share); }

}  // namespace nilas::compare
