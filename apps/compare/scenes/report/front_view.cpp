#include "apps/compare/scenes/report/front_view.h"

#include <fmt/format.h>

#include <cmath>

#include "apps/compare/scenes/judge/merits.h"
#include "apps/compare/scenes/report/front_points.h"
#include "apps/compare/scenes/report/paired_text.h"
#include "apps/compare/workshop/json_store.h"

namespace nilas::compare {

namespace {

using Figures = std::vector<std::vector<std::pair<std::string, std::string>>>;

Json axis_view(const LogAxis& axis, const std::string& label) {
  return {{"label", label}, {"low", axis.low}, {"high", axis.high}, {"tics", axis.tics}};
}

/// The runs of a setting: time [s/s] and error of each, in numbers and as texts.
Json runs_view(const Findings& found, std::size_t setting) {
  Json runs = Json::array();
  for (const auto& row : found.rows) {
    if (!row.is_grid(setting)) continue;
    const std::optional<double> error = measured_error(row, found.measure);
    const double time = row.result.done() ? row.result.compute_per_second() : 0;
    const std::optional<double> shown = found.measure.is_load() ? row.load_difference : error;
    runs.push_back({{"realisation", row.run.realisation},
                    {"status", row.result.status},
                    {"time", number_or_null(time)},
                    {"time_text", time > 0 ? three_digits(time) : ""},
                    {"error", error ? number_or_null(std::abs(*error)) : Json(nullptr)},
                    {"error_text", shown ? three_digits(*shown) : ""}});
  }
  return runs;
}

Json point_view(const FrontPoint& point, const SceneReport& report, const Findings& found, const Figures& figures) {
  const Merit& m = *point.merit;
  Json facts = Json::array();
  for (const auto& [name, value] : figures.at(m.setting))
    if (!value.empty()) facts.push_back({name, value});
  return {{"setting", m.setting + 1},
          {"label", report.label(m.setting)},
          {"full", full_label(report.study.plan.settings[m.setting])},
          {"kind", !m.significant ? "chance"
                   : m.dominated  ? "beaten"
                                  : "best"},
          {"chosen", found.choice.chosen == m.setting},
          {"in_key", in_key(m, found)},
          {"time", m.time},
          {"time_low", point.time_scatters() ? point.shortest() : m.time},
          {"time_high", point.time_scatters() ? point.longest() : m.time},
          {"error", point.error},
          {"error_low", point.lowest()},
          {"error_high", point.highest()},
          {"facts", facts},
          {"run_unit", found.measure.unit},
          {"runs", runs_view(found, m.setting)}};
}

Json front_view(const std::string& name, const std::string& title, const SceneReport& report, const Findings& found,
                const Figures& figures) {
  const std::optional<Front> front = front_of(found);
  if (!front) return nullptr;
  Json points = Json::array();
  for (const auto& point : front->points) points.push_back(point_view(point, report, found, figures));
  const std::string of = fmt::format("error of the {} [{}]", quantity_of(found.measure), found.measure.unit);
  return {{"name", name},
          {"title", title},
          {"caption",
           "Point at a mark to see its figures and its runs, which small circles show. Click it to find its row."},
          {"x", axis_view(front->time, "computing time per simulated second [s/s]")},
          {"y", axis_view(front->error, of)},
          {"reference_moves", front->reference_moves ? Json(*front->reference_moves) : Json(nullptr)},
          {"time_scatter", std::isfinite(found.time_spread) ? percent_text(found.time_spread) : ""},
          {"points", points}};
}

}  // namespace

Json fronts_view(const SceneReport& report, const Figures& figures) {
  Json fronts = Json::array();
  if (report.study.ablation) return fronts;
  const auto add = [&](Json front) {
    if (!front.is_null()) fronts.push_back(std::move(front));
  };
  add(front_view("front", "Accuracy and cost", report, report.found, figures));
  if (const auto moved = judged_by_motion(report.found))
    add(front_view("motion", "Accuracy of the motion and cost", report, *moved, figures));
  return fronts;
}

}  // namespace nilas::compare
