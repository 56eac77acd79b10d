/// The page of a comparison, and all that it leaves on disk.
#include <fmt/format.h>

#include <algorithm>

#include "apps/compare/scenes/report/paired_text.h"
#include "apps/compare/scenes/report/study_outputs.h"
#include "apps/compare/scenes/report/study_pictures.h"
#include "core/base/error.h"
#include "core/output/file/output_file.h"
#include "core/output/text/console.h"
#include "core/output/text/html.h"

namespace nilas {

namespace {

std::string cell(const std::string& text) { return "<td>" + html_text(text) + "</td>"; }
std::string cell(double value, const char* format = "{:.3g}") {
  return "<td class=n>" + (std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : std::string()) + "</td>";
}
/// 1.23 +- 0.04
std::string cell(const Estimate& e, const std::string& mark = "") {
  if (!std::isfinite(e.mean)) return "<td></td>";
  return "<td class=n>" + fmt::format("{:.4g}", e.mean) +
         (std::isfinite(e.standard_error) ? fmt::format(" &plusmn; {:.2g}", e.standard_error) : "") + mark + "</td>";
}
/// Sure ones stand out.
std::string difference(const PairedDifference& d) {
  std::string text = html_text(difference_cell(d));
  const std::string ascii = "+-", symbol = "&plusmn;";
  if (const auto at = text.find(ascii); at != std::string::npos) text.replace(at, ascii.size(), symbol);
  return fmt::format("<td class='{}'>", is_sure(d) ? "d sure" : "d") + text + "</td>";
}

const std::vector<std::pair<std::string, std::string>>& captions() {
  static const std::vector<std::pair<std::string, std::string>> all{
      {"differences",
       "Run by run on the same ice: the mean ice load of each setting less that of the scene's own. Large points are "
       "means over the realisations, with 95 % where there are three and more; small points are realisations. The grey "
       "band is what chance alone does to two runs of one realisation (95 %)."},
      {"front",
       "Left is fast, low is accurate. A point is a setting, its number that of the table; bars are standard errors "
       "over realisations. "
       "Hollow triangles stand at the level below which differences cannot be told from chaos: their true errors may "
       "lie anywhere below. All points are over the same realisations; settings that lack one are left out."},
      {"motion", "The same settings by how far they leave the reference's motions while these can be predicted."},
      {"steps", "Error over the time step, everything else the same."},
      {"ablation",
       "Left: what each simplification of older tools changes, alone and all together, with the standard error over "
       "realisations. Right: the computing time that "
       "it saves."}};
  return all;
}

}  // namespace

std::string StudyOutputs::settings_table() const {
  const bool load = found_.measure == "load";
  std::string html = fmt::format(
      "<table><tr><th>no.</th><th>setting</th><th>s per simulated s</th><th>ms per step</th><th>error "
      "[{0}]</th><th>smallest that could be told from chaos [{0}]</th>{1}"
      "<th>rms distance [m]</th><th>deepest penetration [m]</th><th>energy error</th><th>law residual "
      "[m/s]</th><th>steps short of the tolerance</th><th></th></tr>\n",
      found_.unit,
      load
          ? "<th>mean ice load [N]</th><th>from the reference, run by run [N]</th><th>from the scene's own, run by run "
            "[N]</th><th>std [N]</th><th>99 % [N]</th><th>largest [N]</th>"
          : "");
  if (load && found_.stand_in.empty() && !study_.ablation)
    html += "<tr><td></td><td>reference</td><td></td><td></td><td></td><td></td>" + cell(found_.reference_mean) +
            "<td></td><td></td>" + cell(found_.reference_std.mean) + cell(found_.reference_p99.mean) +
            cell(found_.reference_max.mean) + "<td></td><td></td><td></td><td></td><td></td><td></td></tr>\n";
  for (const auto& m : found_.merits) {
    std::string remark = found_.chosen == m.setting   ? "chosen"
                         : m.dominated || m.done == 0 ? ""
                                                      : "nothing is faster and better";
    if (!m.trouble.empty()) remark = m.trouble;
    if (m.partial)
      remark += fmt::format("{}* {} only", remark.empty() ? "" : "; ",
                            m.realisations.empty() ? "other realisations" : realisations_text(m.realisations));
    html += fmt::format("<tr class='{}'>", m.failed > 0 || m.done == 0  ? "fails"
                                           : found_.chosen == m.setting ? "chosen"
                                                                        : "");
    html += cell(static_cast<double>(m.setting + 1)) + "<td title='" +
            html_text(full_label(study_.plan.settings[m.setting])) + "'>" + html_text(label(m.setting)) + "</td>";
    html += "<td class=n>" + (std::isfinite(m.time) ? fmt::format("{:.3g}", m.time) : "") +
            (std::isfinite(m.time_spread) ? fmt::format(" &plusmn; {:.1g}", m.time_spread) : "") + "</td>" +
            cell(m.ms_per_step);
    html += "<td class=n>" +
            (!std::isfinite(m.error) ? std::string()
             : m.told                ? fmt::format("{:.3g}", m.error)
                                     : "not told") +
            "</td>" + cell(m.floor);
    if (load)
      html += cell(m.load, m.partial ? " *" : "") + difference(m.from_reference) + difference(m.from_own) +
              cell(m.load_std.mean) + cell(m.load_p99.mean) + cell(m.load_max.mean);
    html += cell(m.motion.mean) + cell(m.penetration_max_m) + cell(m.energy_error, "{:.1e}") +
            cell(m.law_map_m_s, "{:.1e}");
    html += cell(100 * m.unconverged_share, "{:.2g} %") + cell(remark) + "</tr>\n";
  }
  return html +
         fmt::format(
             "</table>\n<p>All figures of a setting are over {}{}. After &plusmn;: of a time what alike runs scatter "
             "by, "
             "of a load the standard error over realisations. 99 % and largest are those of the load's absolute "
             "value.{}</p>\n",
             found_.shared.empty() ? "no realisation" : realisations_text(found_.shared),
             std::any_of(found_.merits.begin(), found_.merits.end(), [](const Merit& m) { return m.partial; })
                 ? ", but for those marked *: their means must not be set beside the others', their differences may be"
                 : "",
             load ? " Differences are taken run by run on the same ice; after &plusmn; stands what holds for their "
                    "mean with "
                    "95 % (Student). Sure in a realisation: beyond what chance alone does to two runs of that ice, "
                    "while "
                    "of other ice nothing is known."
                  : "");
}

std::string StudyOutputs::runs_table() const {
  std::string html =
      "<table><tr><th>run</th><th>setting</th><th>realisation</th><th>status</th><th>computing [s]</th><th>ms per "
      "step</th><th>load from the reference "
      "[N]</th><th>from the scene's own [N]</th><th>rms distance [m]</th><th></th></tr>\n";
  constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& row : found_.rows) {
    const bool grid = row.run.kind == RunKind::grid;
    html += fmt::format("<tr class='{}'>", row.result.done() ? "" : "fails") + cell(row.run.id) +
            cell(grid ? label(row.run.setting) : name_of(row.run.kind)) +
            cell(static_cast<double>(row.run.realisation)) + cell(row.result.status) +
            cell(row.result.wall_s > 0 ? row.result.cpu_s : k_nan) + cell(row.result.ms_per_step()) +
            cell(row.load_difference.value_or(k_nan)) + cell(row.own_difference.value_or(k_nan)) +
            cell(row.motion ? row.motion->rms_m : k_nan) + cell(row.result.cause) + "</tr>\n";
  }
  return html + "</table>\n";
}

/// Over what loads are taken, and what chance does to them.
std::vector<std::string> StudyOutputs::load_notes() const {
  std::vector<std::string> notes;
  if (found_.measure != "load") return notes;
  std::string windows;
  for (std::size_t r = 0; r < found_.windows.size(); ++r)
    if (const auto& span = found_.windows[r])
      windows += fmt::format("{}{:g} s to {:g} s in realisation {}{}", windows.empty() ? "" : "; ", span->from,
                             span->to, r, span->reason.empty() ? "" : " (" + span->reason + ")");
  notes.push_back(
      fmt::format("The ice load is that of the ice on the vessel along its course, positive astern ({}), over "
                  "the same time in all runs of a realisation: {}.",
                  found_.headline, windows));
  if (std::isnan(found_.chaos)) {
    notes.emplace_back("What chance does to mean loads was not measured: no twin is done.");
    return notes;
  }
  notes.push_back(fmt::format(
      "Chance, over {}: a run's mean load scatters by {} (standard deviation), as twins that start "
      "1e-12 m aside and the realisations tell. Differences below Student's 95 % limit of that are not called "
      "errors.",
      such_ice(), quantity_text(found_.chaos, "N")));
  notes.emplace_back(
      "Chance, in one realisation: what its twins differ by, or what settings scatter by that solve the same law with "
      "the same steps as tightly, whichever is more, at Student's 95 % limit.");
  return notes;
}

std::vector<std::string> StudyOutputs::ablation_notes() const {
  std::vector<std::string> notes{
      "Each simplification is judged by the same scene without any: exact friction cone, projection, continuous "
      "detection, gyroscopic torque, six load cells. Ice that crushes does so by its growing contact area, between "
      "floes too, and is cut out; ice that splits does so by its fracture toughness, along curved cracks."};
  const auto of_ice = [](const Omission& one) { return one.what == name_of(Simplification::uniform_ice); };
  if (std::none_of(study_.absent.begin(), study_.absent.end(), of_ice))
    notes.emplace_back(
        "Where the scene draws no properties of its ice, the flexural strength varies by 25 % over ten thicknesses: "
        "strengths scatter by 20 to 30 % in nature; the length is a choice, not a measurement.");
  for (const auto& setting : study_.plan.settings)
    if (setting.simplifications.size() == 1)
      notes.push_back(fmt::format("\"{}\": {}.", name_of(setting.simplifications.front()),
                                  meaning_of(setting.simplifications.front())));
  for (const auto& one : study_.absent) notes.push_back(fmt::format("No row \"{}\": {}.", one.what, one.why));
  for (const Inexpressible& one : inexpressible_simplifications())
    notes.push_back(fmt::format("No row \"{}\", which Nilas simplifies itself: {}.", one.name, one.reason));
  return notes;
}

std::string StudyOutputs::how_measured() const {
  const Plan& plan = study_.plan;
  std::string html = "<ul>";
  const auto item = [&](const std::string& text) { html += "<li>" + html_text(text) + "</li>\n"; };
  if (study_.ablation)
    for (const auto& text : ablation_notes()) item(text);
  else if (!found_.stand_in.empty())
    item("Judged by " + found_.stand_in + ", as no run of the reference is done.");
  else if (study_.reference != "auto")
    item("Judged by the run in " + study_.reference + ".");
  else if (study_.event_driven)
    item(
        "Judged by the same scene integrated between impacts with a local error of 1e-15 per step, 1e-13 on closed "
        "contacts (integrator reference), which nilas "
        "verify holds against closed forms.");
  else
    item(fmt::format(
        "Judged by {} with steps of {:g} s, half the finest that is compared, integrator {}, solved to {:.0e} m/s. {}",
        plan.reference.solver, plan.reference.step, plan.reference.integrator, plan.reference.tolerance,
        found_.reference_moves ? fmt::format("With steps twice as long it moves by {}.",
                                             quantity_text(*found_.reference_moves, found_.unit))
                               : "How far it moves with its step was not measured."));
  item(fmt::format(
      "{} of each setting: {}. A setting's error is the mean of its differences from the reference, "
      "realisation by realisation.",
      plan.realisations == 1 ? "One realisation" : fmt::format("{} realisations", plan.realisations),
      plan.realisations == 1 ? "the scene itself"
      : found_.same_ice
          ? "the scene itself and starts 1e-12 m aside: by its seed this scene draws no other ice, so that "
            "nothing here holds for other ice"
      : plan.vary_seed ? "the scene itself, then other seeds and starts 1e-12 m aside, the same ones for every setting"
                       : "the scene itself and starts 1e-12 m aside"));
  for (const auto& note : load_notes()) item(note);
  item(!found_.horizon_known ? "How long motions can be predicted was not measured: no twin is done."
       : found_.horizon_ends
           ? fmt::format(
                 "Motions are compared until {:.4g} s, where two runs that begin 1e-12 m apart first part by {}.",
                 found_.horizon_s, quantity_text(found_.horizon_threshold_m, "m"))
           : "Motions are compared over the whole time: twins do not part.");
  item(fmt::format(
      "Times: processor time of a process pinned to a core of its own with one thread, without reading, packing ice "
      "and writing; the median of the realisations. {} at a time. {}",
      timing_.jobs,
      std::isfinite(timing_.slowdown)
          ? fmt::format("The first setting's first {} steps took {:.2f} times as long as alone on the machine.",
                        study_.probe_steps, timing_.slowdown)
          : "What neighbours cost was not measured."));
  if (std::isfinite(found_.time_spread))
    item(
        fmt::format("Times of one setting's runs scatter by {:.3g} % (standard deviation).", 100 * found_.time_spread));
  for (const auto& list : by_reason(plan.omissions)) item("Left out for " + list + ".");
  for (const auto& refused : study_.refused) item(fmt::format("Cannot run: {}: {}", refused.what, refused.why));
  return html + "</ul>\n";
}

std::string StudyOutputs::page(const std::filesystem::path& folder, const std::vector<std::string>& pictures,
                               const std::string& instead) const {
  const std::string scene = study_.scene.stem().string();
  std::string html = fmt::format(
      "<!doctype html><html lang='en'><head><meta charset='utf-8'><title>{0}: nilas compare</title><style>{1}"
      "td.n{{text-align:right;white-space:nowrap;font-variant-numeric:tabular-nums}}tr.chosen{{background:#fff3e0;font-"
      "weight:bold}}td.d{{"
      "white-space:nowrap;color:#666}}td.sure{{color:#000;font-weight:bold}}p."
      "warning{{border-left:4px solid #d55e00;padding-left:.7em}}"
      "figure{{margin:1em 0}}figcaption{{color:#555}}</style></head><body><h1>{0}: {2}</h1>\n",
      html_text(scene), k_page_style, study_.ablation ? "what each simplification costs" : "the price of accuracy");
  html += fmt::format("<p>{:g} s simulated, {} settings, {} realisation{}</p>\n", study_.plan.end - study_.plan.start,
                      study_.plan.settings.size(), study_.plan.realisations, study_.plan.realisations == 1 ? "" : "s");
  const auto lines = sentences();
  const auto figure = [&](const std::string& name) {
    const auto caption =
        std::find_if(captions().begin(), captions().end(), [&](const auto& c) { return c.first == name; });
    html += "<figure>" + inline_svg(folder / (name + ".svg")) + "<figcaption>" + caption->second +
            "</figcaption></figure>\n";
  };
  html += "<p><b>" + html_text(lines.front()) + "</b></p>\n";
  if (found_.chosen && lines.size() > 1) html += "<p>" + html_text(lines[1]) + "</p>\n";
  for (const auto& warning : warnings()) html += "<p class=warning>" + html_text(warning) + "</p>\n";
  for (const auto& line : outlook_lines(outlook_, study_, found_))
    html +=
        line.starts_with("  ") ? "<pre>" + html_text(line.substr(2)) + "</pre>\n" : "<p>" + html_text(line) + "</p>\n";
  for (const auto& picture : pictures) figure(picture);
  if (pictures.empty()) html += "<p class=warning>" + html_text(instead) + "</p>\n";
  html += "<h2>Settings</h2>\n<p>" + html_text(own_setting()) + "</p>\n" + settings_table() + "<h2>In words</h2>\n<p>";
  for (const auto& line : lines) html += html_text(line) + "<br>\n";
  html += "</p><h2>How it was measured</h2>\n" + how_measured();
  html += fmt::format("<details><summary>All {} runs</summary>{}</details>\n", found_.rows.size(), runs_table());
  if (!study_.ablation)
    html += fmt::format(
        "<p>What each simplification of older tools costs on this scene is a page of its own: nilas compare {} "
        "--ablate.</p>\n",
        html_text(study_.scene.filename().string()));
  return html +
         "<p>Every figure with its unit: compare.csv (a row per run), settings.csv, loads.csv, compare.json.</p>"
         "</body></html>\n";
}

void StudyOutputs::write_page(const std::filesystem::path& folder) const {
  write_whole(folder / "compare.html", page(folder, {}, "The pictures are not drawn yet."));
}

std::string StudyOutputs::write(const std::filesystem::path& folder) const {
  write_whole(folder / "compare.csv", runs_csv());
  write_whole(folder / "settings.csv", settings_csv());
  write_whole(folder / "loads.csv", loads_csv());
  write_whole(folder / "compare.json", json().dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  write_page(folder);  // without its pictures it still says all there is
  const Drawings drawings = found_.merits.empty() ? Drawings{} : draw_study(folder, study_, found_, labels());
  write_whole(folder / "compare.html", page(folder, drawings.drawn,
                                            drawings.trouble.empty() ? "There is nothing to draw."
                                                                     : "Pictures are missing: " + drawings.trouble));
  return drawings.trouble;
}

}  // namespace nilas
