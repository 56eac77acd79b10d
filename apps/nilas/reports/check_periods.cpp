#include "apps/nilas/reports/check_periods.h"

#include <fmt/format.h>

#include "core/sim/build/natural_periods.h"

namespace nilas::commands {

PeriodsReport natural_periods_report(const scene::Scene& scene, const sim::WorldParts& parts) {
  PeriodsReport report;
  report.json = nlohmann::ordered_json::array();
  const auto add = [&](const std::string& motion, const std::string& held_by, double period, bool damped = false) {
    report.text += fmt::format("  {:<12} {:>9.3g} s  {:>7.3g} steps  held by {}{}\n", motion, period,
                               period / scene.time.step, held_by, damped ? ", damped by the step" : "");
    report.json.push_back(
        {{"motion", motion}, {"held_by", held_by}, {"period_s", period}, {"steps", period / scene.time.step}});
  };
  for (const sim::NaturalPeriod& mode : sim::natural_periods(scene, parts))
    add(mode.motion, mode.held_by(), mode.period,
        mode.on_cells && mode.period < sim::k_least_steps_on_cells * scene.time.step);
  if (const double period = sim::floe_heave_period(scene, parts); period > 0) add("floe heave", "the water", period);
  if (!report.text.empty()) report.text = "\nnatural periods, without added mass:\n" + report.text;
  return report;
}

}  // namespace nilas::commands
