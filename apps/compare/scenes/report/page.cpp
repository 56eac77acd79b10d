#include "apps/compare/scenes/report/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/compare/scenes/report/answer.h"
#include "apps/compare/scenes/report/front_view.h"
#include "apps/compare/scenes/report/methods.h"
#include "apps/compare/scenes/report/paired_text.h"
#include "apps/compare/scenes/report/run_command.h"
#include "apps/compare/scenes/report/tables.h"
#include "apps/compare/workshop/json_store.h"
#include "apps/compare/workshop/page_text.h"
#include "apps/compare/workshop/special_numbers.h"
#include "core/output/file/output_file.h"
#include "core/output/text/html.h"
#include "core/output/text/script_json.h"

namespace nilas::compare {

namespace {

std::string number_text(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "";
}
std::string number_text(double value) { return std::isfinite(value) ? three_digits(value) : ""; }
/// The text with each "+-", as terminals have it, replaced by one sign.
std::string typeset(std::string text) {
  const std::string ascii = "+-", sign = "±";
  for (std::size_t at = 0; (at = text.find(ascii, at)) != std::string::npos; at += sign.size())
    text.replace(at, ascii.size(), sign);
  return text;
}

std::string with_error(double value, double error) {
  return std::isfinite(value) ? number_text(value) + typeset(uncertainty_text(value, error, "")) : "";
}

const char* caption_of(const std::string& picture) {
  if (picture == "differences")
    return "Mean ice load of each setting minus that of the scene's own setting, run by run on the same ice. Small "
           "points are realisations. Large points are their means, with 95 % intervals where there are three "
           "realisations or more. The grey band is what chance alone makes of two runs of one realisation (95 %).";
  if (picture == "front")
    return "Cost and error of each setting: fast ones stand on the left, accurate ones at the bottom. Numbers are "
           "those of the table. Vertical bars are standard errors over the realisations. Horizontal bars are the "
           "scatter of computing times among runs of one setting (standard deviation), where it was measured. Hollow "
           "triangles mark settings whose error may be chance: their true error may lie anywhere below the mark.";
  if (picture == "motion")
    return "The same, with the distance from the reference's motion as the error, as long as motions can be predicted.";
  if (picture == "steps") return "Error over the time step for settings that differ in nothing else.";
  return "Left: change that each simplification makes, alone and all together, with the standard error over the "
         "realisations. Right: computing time that it saves.";
}

std::string remark_of(const Merit& m, const Choice& choice) {
  std::string remark = choice.chosen == m.setting   ? "recommended"
                       : m.dominated || m.done == 0 ? ""
                                                    : "none is both faster and better";
  if (!m.trouble.empty()) remark = m.trouble;
  if (m.partial)
    remark += fmt::format("{}* {} only", remark.empty() ? "" : "; ",
                          m.realisations.empty() ? "other realisations" : realisations_text(m.realisations));
  return remark;
}

const char* class_of(bool shown) { return shown ? "n" : "n weak"; }

const char* class_of(const PairedDifference& d, double reference_moves) {
  return class_of(is_sure(d) && !is_below_change(d, reference_moves));
}

/// Whether an error is significant and smaller than the change of the reference with its own step.
bool error_below_change(const Merit& m, const Findings& found) {
  return m.significant && m.error < found.check.moves.value_or(0);
}

std::string mean_load_text(const Merit& m) {
  return with_error(m.load.mean, m.load.standard_error) + (m.partial ? " *" : "");
}

Json load_cells(const Merit& m, double moves) {
  constexpr double k_without_reference = 0;
  return {{"from_reference", typeset(difference_cell(m.from_reference, moves))},
          {"reference_class", class_of(m.from_reference, moves)},
          {"from_own", typeset(difference_cell(m.from_own, k_without_reference))},
          {"own_class", class_of(m.from_own, k_without_reference)},
          {"std", number_text(m.load_std.mean)},
          {"p99", number_text(m.load_p99.mean)},
          {"max", number_text(m.load_max.mean)}};
}

/// The error with its share of the scale, or a remark if it may be chance.
std::string error_text(const Merit& m, const Findings& found) {
  const Measure& measure = found.measure;
  if (!std::isfinite(m.error)) return "";
  if (!m.significant)
    return std::isfinite(m.floor) ? fmt::format("not significant (below {:.2g})", m.floor) : "not known";
  const bool share = measure.scale > 0 && measure.name != "turn";
  if (error_below_change(m, found)) return number_text(m.error) + " (less than the reference's own change)";
  return number_text(m.error) + (share ? fmt::format(" ({:.2g} %)", 100 * m.error / measure.scale) : "");
}

/// Median and 95th percentile in percent; empty where no step was checked.
std::string step_load_cell(const Merit& m) {
  return std::isfinite(m.step_load_p95)
             ? fmt::format("{:.2g} / {:.2g}", 100 * m.step_load_median, 100 * m.step_load_p95)
             : "";
}

Json setting_row(const SceneReport& report, const Merit& m) {
  const Findings& found = report.found;
  const bool fails = m.failed > 0 || m.done == 0;
  return {{"kind", fails                              ? "fails"
                   : found.choice.chosen == m.setting ? "chosen"
                                                      : ""},
          {"number", m.setting + 1},
          {"label", report.label(m.setting)},
          {"full", full_label(report.study.plan.settings[m.setting])},
          {"time", with_error(m.time, m.time_spread)},
          {"ms_per_step", number_text(m.ms_per_step)},
          {"error", error_text(m, found)},
          {"error_class", class_of(m.significant && !error_below_change(m, found))},
          {"load_or_floor", found.measure.is_load() ? mean_load_text(m) : number_text(m.floor)},
          {"load_cells", found.measure.is_load() ? load_cells(m, found.check.moves.value_or(0)) : Json(nullptr)},
          {"motion", number_text(m.motion.mean)},
          {"penetration", number_text(m.penetration_max_m)},
          {"energy", number_text(m.energy_error, "{:.1e}")},
          {"residual", number_text(m.law_map_m_s, "{:.1e}")},
          {"step_load", step_load_cell(m)},
          {"unconverged", number_text(100 * m.unconverged_share, "{:.2g}")},
          {"remark", remark_of(m, found.choice)}};
}

/// What is shown of each setting at its mark, from the rows of the tables.
std::vector<std::vector<std::pair<std::string, std::string>>> figures_of(const Json& settings, const Findings& found) {
  std::vector<std::vector<std::pair<std::string, std::string>>> figures;
  const std::string unit = " [" + found.measure.unit + "]";
  for (const Json& row : settings) {
    const auto text = [&](const char* key) { return row.at(key).get<std::string>(); };
    figures.push_back(
        {{"computing time [s/s]", text("time")},
         {"error" + unit, text("error")},
         {found.measure.is_load() ? "mean ice load [N]" : "may be chance up to" + unit, text("load_or_floor")},
         {"deepest penetration [m]", text("penetration")},
         {"remark", text("remark")}});
  }
  return figures;
}

Json run_row(const SceneReport& report, const RunRow& row) {
  const bool grid = row.run.kind == RunKind::grid;
  return {{"kind", row.result.done() ? "" : "fails"},
          {"number", grid ? Json(row.run.setting + 1) : Json(nullptr)},
          {"id", row.run.id},
          {"label", grid ? report.label(row.run.setting) : plain_name_of(row.run.kind)},
          {"realisation", row.run.realisation},
          {"status", row.result.status},
          {"cpu", number_text(row.result.wall_s > 0 ? row.result.cpu_s : k_unknown)},
          {"ms", number_text(row.result.ms_per_step())},
          {"from_reference", number_text(row.load_difference.value_or(k_unknown))},
          {"from_own", number_text(row.own_difference.value_or(k_unknown))},
          {"motion", number_text(row.motion ? row.motion->rms_m : k_unknown)},
          {"cause", row.result.cause}};
}

std::vector<std::string> table_notes(const SceneReport& report) {
  const Findings& found = report.found;
  std::vector<std::string> notes;
  const bool partial = std::any_of(found.merits.begin(), found.merits.end(), [](const Merit& m) { return m.partial; });
  notes.push_back(
      fmt::format("All figures are over {}{}. A ± below half a unit of the third digit is left out. After ±: for a "
                  "time, the scatter among runs of one setting; for a load, the standard error over the realisations.",
                  found.shared.empty() ? "no realisation" : realisations_text(found.shared),
                  partial ? ", except those marked *: their means must not be compared with the others, "
                            "their differences may be"
                          : ""));
  if (found.check.moves)
    notes.push_back(
        fmt::format("With its step doubled the reference changes by {}. It cannot show errors below that, which the "
                    "tables mark as less than the reference's own change.",
                    quantity_text(*found.check.moves, found.measure.unit)));
  if (!found.measure.is_load()) return notes;
  notes.push_back(fmt::format("Each mean ice load is that along the course over {}.", window_text(report)));
  notes.emplace_back(
      "The error is the mean of a setting's differences from the reference, run by run on the same ice. It is "
      "significant where chance alone makes so large a difference in less than 5 % of cases.");
  return notes;
}

Json outlook_view(const SceneReport& report) {
  Json list = Json::array();
  for (const auto& line : outlook_lines(report.outlook, report.study, report.found)) {
    const bool command = line.starts_with("  ");
    list.push_back({{"heading", list.empty() ? "With more computing time" : ""},
                    {"command", command ? line.substr(2) : ""},
                    {"sentence", command ? "" : line}});
  }
  return list;
}

Json reference_view(const SceneReport& report) {
  const Findings& found = report.found;
  if (!found.measure.is_load() || !found.judges.stand_in.empty() || report.study.ablation) return nullptr;
  const JudgingLoads& reference = found.reference;
  return {{"load", with_error(reference.mean.mean, reference.mean.standard_error)},
          {"std", number_text(reference.std.mean)},
          {"p99", number_text(reference.p99.mean)},
          {"max", number_text(reference.max.mean)}};
}

/// A sentence about the first setting, because labels name only the differences from it.
std::string own_setting(const SceneStudy& study) {
  if (study.plan.settings.empty()) return "";
  const std::string own = full_label(study.plan.settings.front());
  return study.ablation ? "Without any simplification: " + own + "."
                        : "The scene's own setting is " + own + ". The others are named by what they change in it.";
}

Json view_of(const SceneReport& report) {
  const Plan& plan = report.study.plan;
  const Findings& found = report.found;
  Json settings = Json::array(), runs = Json::array();
  for (const auto& m : found.merits) settings.push_back(setting_row(report, m));
  for (const auto& row : found.rows) runs.push_back(run_row(report, row));
  const Json fronts = fronts_view(report, figures_of(settings, found));
  const auto details = detail_lines(report);
  const std::string quantity = found.measure.is_load()        ? "mean ice load"
                               : found.measure.name == "turn" ? "attitude"
                                                              : "position, rms";
  const std::string scene = report.study.scene.stem().string();
  return {{"page_title", scene + ": nilas compare"},
          {"page_heading", scene + (report.study.ablation ? ": effect and cost of each simplification"
                                                          : ": accuracy and cost of contact settings")},
          {"subtitle", fmt::format("{:g} s simulated, {} settings, {} realisation{}", plan.end - plan.start,
                                   plan.settings.size(), plan.realisations, plan.realisations == 1 ? "" : "s")},
          {"status", report.ended_by.empty() ? "" : "This comparison is not complete: " + report.ended_by + "."},
          {"answer", answer_lines(report)},
          {"run_command", run_command(report)},
          {"fronts", output::script_json(fronts)},
          {"own_setting", own_setting(report.study)},
          {"quantity", quantity},
          {"unit", found.measure.unit},
          {"load", found.measure.is_load()},
          {"reference", reference_view(report)},
          {"settings", settings},
          {"table_notes", table_notes(report)},
          {"caveats", caveat_lines(report)},
          {"outlook", outlook_view(report)},
          {"details", details.empty() ? Json(nullptr) : Json{{"lines", details}}},
          {"methods", method_lines(report)},
          {"run_count", found.rows.size()},
          {"runs", runs},
          {"ablation_hint", report.study.ablation ? "" : report.study.scene.filename().string()}};
}

void write_scene_page(const std::filesystem::path& folder, Json view, const std::vector<std::string>& pictures,
                      const std::string& no_figures) {
  Json figures = Json::array();
  for (const auto& picture : pictures)
    figures.push_back({{"name", picture},
                       {"svg", output::inline_svg(folder / (picture + ".svg"))},
                       {"caption", caption_of(picture)}});
  view["figures"] = figures;
  view["no_figures"] = no_figures;
  output::write_whole(folder / "compare.html", page_text("scene_page.html", std::move(view)));
}

}  // namespace

void write_first_page(const std::filesystem::path& folder, const SceneReport& report) {
  write_scene_page(folder, view_of(report), {}, "The pictures are not drawn yet.");
}

std::string write_report(const std::filesystem::path& folder, const SceneReport& report) {
  output::write_whole(folder / "compare.csv", runs_csv(report));
  output::write_whole(folder / "settings.csv", settings_csv(report));
  output::write_whole(folder / "loads.csv", loads_csv(report));
  write_json(folder / "compare.json", report_json(report));
  const Json view = view_of(report);
  write_scene_page(folder, view, {}, "The pictures are not drawn yet.");  // the page is complete even if drawing fails
  const std::vector<Picture> pictures = pictures_of(report);
  const Drawings drawings = draw(folder, pictures);
  const std::string missing = !drawings.trouble.empty() ? "Pictures are missing: " + drawings.trouble
                              : pictures.empty()        ? "There is nothing to draw."
                                                        : "";
  write_scene_page(folder, view, drawings.drawn, missing);
  return drawings.trouble;
}

}  // namespace nilas::compare
