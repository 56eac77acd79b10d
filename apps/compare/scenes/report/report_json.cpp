/// The JSON object of compare.json.
#include "apps/compare/scenes/report/answer.h"
#include "apps/compare/scenes/report/paired_text.h"
#include "apps/compare/scenes/report/run_command.h"
#include "apps/compare/scenes/report/tables.h"
#include "apps/compare/scenes/run/study_json.h"
#include "apps/compare/workshop/json_store.h"

namespace nilas::compare {

namespace {

Json json_of(const Estimate& e) {
  return {{"mean", number_or_null(e.mean)}, {"standard_error", number_or_null(e.standard_error)}, {"runs", e.count}};
}

Json numbers_or_null(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number_or_null(value));
  return list;
}

Json json_of(const PairedDifference& d) {
  if (d.realisations.empty()) return nullptr;
  return {{"realisations", d.realisations},
          {"differences_N", numbers_or_null(d.values)},
          {"chance_limits_N", numbers_or_null(d.limits)},
          {"mean_N", number_or_null(d.mean)},
          {"half_width_95_N", number_or_null(d.half_width)},
          {"beyond_chance", d.beyond_chance},
          {"sure", name_of(d.certainty)}};
}

Json windows_json(const Findings& found) {
  Json windows = Json::array();
  for (const auto& span : found.windows)
    windows.push_back(span ? Json{{"from_s", span->from}, {"to_s", span->to}, {"reason", span->reason}}
                           : Json(nullptr));
  return windows;
}

Json json_of(const std::optional<Coverage>& c) {
  return c ? Json{{"runs", c->runs}, {"share", c->share}, {"median_width", number_or_null(c->width)}} : Json(nullptr);
}

Json setting_json(const SceneReport& report, const Merit& m) {
  const CompareSetting& s = report.study.plan.settings[m.setting];
  return {{"label", report.label(m.setting)},
          {"solver", s.solver},
          {"law", s.law},
          {"step_s", s.step},
          {"tolerance_m_s", s.tolerance},
          {"stabilisation", s.stabilisation},
          {"integrator", s.integrator},
          {"simplifications", simplifications_text(s)},
          {"runs", m.planned},
          {"done", m.done},
          {"trouble", m.trouble},
          {"compute_s_per_s", number_or_null(m.time)},
          {"compute_spread_s_per_s", number_or_null(m.time_spread)},
          {"error", number_or_null(m.error)},
          {"floor", number_or_null(m.floor)},
          {"told_from_chaos", m.significant},
          {"dominated", m.dominated},
          {"load_N", json_of(m.load)},
          {"load_difference_N", json_of(m.load_difference)},
          {"realisations", m.realisations},
          {"partial", m.partial},
          {"from_reference", json_of(m.from_reference)},
          {"from_own", json_of(m.from_own)},
          {"motion_rms_m", json_of(m.motion)},
          {"turn_rad", json_of(m.turn)},
          {"penetration_max_m", number_or_null(m.penetration_max_m)},
          {"step_load_error_median_1", number_or_null(m.step_load_median)},
          {"step_load_error_p95_1", number_or_null(m.step_load_p95)},
          {"imbalance_relative", number_or_null(m.energy_error)}};
}

/// The simplifications that have no row in an ablation: they change nothing in the scene, or Nilas makes them itself.
Json absent_json(const SceneStudy& study) {
  Json list = to_json(study.absent);
  for (const Inexpressible& one : inexpressible_simplifications())
    if (study.ablation) list.push_back({{"what", one.name}, {"why", one.reason}});
  return list;
}

}  // namespace

Json report_json(const SceneReport& report) {
  const SceneStudy& study = report.study;
  const Findings& found = report.found;
  const StudyTiming& timing = report.timing;
  Json settings = Json::array(), orders = Json::array();
  for (const auto& m : found.merits) settings.push_back(setting_json(report, m));
  for (const auto& order : found.orders)
    orders.push_back({{"of", order.rest}, {"order", order.order}, {"steps", order.steps}});
  std::vector<std::string> text = answer_lines(report);
  for (const auto& line : detail_lines(report)) text.push_back(line);
  return {{"scene", study.scene.string()},
          {"complete", report.ended_by.empty() && report.late.empty()},
          {"measure", found.measure.name},
          {"unit", found.measure.unit},
          {"channel", found.headline},
          {"windows", windows_json(found)},
          {"shared_realisations", found.shared},
          {"same_ice", found.same_ice},
          {"scale", number_or_null(found.measure.scale)},
          {"reference", study.reference},
          {"judged_in_its_place_by", found.judges.stand_in},
          {"reference_moves", found.check.moves ? Json(*found.check.moves) : Json(nullptr)},
          {"reference_coarse", found.check.coarse},
          {"chaos", number_or_null(found.chance.run_N)},
          {"horizon_s", found.horizon.known ? Json(found.horizon.until_s) : Json(nullptr)},
          {"horizon_ends", found.horizon.ends},
          {"simulated_s", study.plan.end - study.plan.start},
          {"realisations", study.plan.realisations},
          {"load_error_coverage", json_of(found.coverage)},
          {"load_error_coverage_alone", json_of(found.coverage_alone)},
          {"chosen", found.choice.chosen ? Json(report.label(*found.choice.chosen)) : Json(nullptr)},
          {"chosen_command", run_command(report)},
          {"settings", settings},
          {"orders", orders},
          {"left_out", to_json(study.plan.omissions)},
          {"cannot_run", to_json(study.refused)},
          {"simplifications_without_a_row", absent_json(study)},
          {"not_done_for_the_budget", report.late},
          {"with_more_time", outlook_json(report.outlook)},
          {"text", text},
          {"warnings", caveat_lines(report)},
          {"jobs", timing.jobs},
          {"elapsed_s", timing.elapsed_s},
          {"jobs_at_work", number_or_null(timing.busy)},
          {"slowdown_by_neighbours", number_or_null(timing.slowdown)},
          {"parallel_efficiency", number_or_null(timing.efficiency())},
          {"time_spread_relative", number_or_null(found.time_spread)}};
}

}  // namespace nilas::compare
