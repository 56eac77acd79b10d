#include "apps/report/page/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>

#include "apps/report/page/headline.h"
#include "apps/report/page/ice_section.h"
#include "apps/report/page/load_sections.h"
#include "apps/report/page/numerics_sections.h"
#include "apps/report/page/scene_section.h"
#include "apps/report/page/words.h"
#include "apps/report/templates.h"
#include "apps/view/page.h"
#include "core/output/text/fill_template.h"

namespace nilas::report {

namespace {

using Json = nlohmann::ordered_json;

/// Numbers with so many significant digits; null where one is not finite.
Json numbers_json(const std::vector<double>& values, int digits) {
  Json list = Json::array();
  for (const double value : values) {
    if (!std::isfinite(value)) {
      list.push_back(nullptr);
      continue;
    }
    const double power = value == 0 ? 0 : std::floor(std::log10(std::abs(value)));
    const double unit = std::pow(10, std::abs(digits - 1 - power));
    const bool small = power < digits - 1;
    list.push_back(small ? std::round(value * unit) / unit : std::round(value / unit) * unit);
  }
  return list;
}

Json plot_json(const Plot& plot) {
  Json curves = Json::array(), levels = Json::array();
  // Steps stay apart in a run that begins late, and a screen needs no more of the values.
  constexpr int k_place = 10, k_value = 6;
  for (const Curve& curve : plot.curves)
    curves.push_back({{"name", curve.name},
                      {"x", numbers_json(curve.x, k_place)},
                      {"y", numbers_json(curve.y, k_value)},
                      {"low", numbers_json(curve.low, k_value)},
                      {"high", numbers_json(curve.high, k_value)},
                      {"dots", curve.is_dots},
                      {"steps", curve.is_steps}});
  for (const Level& level : plot.levels)
    levels.push_back({{"name", level.name}, {"y", level.y}, {"half_width", level.half_width}});
  const Json range = plot.y_range ? Json(*plot.y_range) : Json(nullptr);
  return {{"id", plot.id},       {"y_range", range},    {"x_label", plot.x_label},     {"y_label", plot.y_label},
          {"log_x", plot.log_x}, {"log_y", plot.log_y}, {"over_time", plot.over_time}, {"curves", curves},
          {"levels", levels}};
}

Json table_json(const PageTable& table) {
  constexpr std::size_t k_long = 12;  // longer tables are folded
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (std::size_t k = 1; k < row.size(); ++k) cells.push_back(row[k]);
    rows.push_back({{"name", row.front()}, {"cells", cells}});
  }
  Json head = Json::array();
  for (std::size_t k = 1; k < table.head.size(); ++k) head.push_back(table.head[k]);
  return {{"first", table.head.empty() ? "" : table.head.front()},
          {"has_head", !table.head.empty()},
          {"head", head},
          {"rows", rows},
          {"caption", table.caption},
          {"is_long", table.rows.size() > k_long},
          {"summary", fmt::format("Show the table of {} rows", table.rows.size())}};
}

Json section_json(const Section& section) {
  Json drawings = Json::array(), plots = Json::array(), tables = Json::array();
  for (const Drawing& drawing : section.drawings)
    drawings.push_back({{"svg", drawing.svg}, {"caption", drawing.caption}});
  for (const Plot& plot : section.plots) plots.push_back({{"id", plot.id}, {"title", plot.title}});
  for (const PageTable& table : section.tables) tables.push_back(table_json(table));
  return {{"id", section.id}, {"title", section.title}, {"text", section.text}, {"drawings", drawings},
          {"plots", plots},   {"tables", tables},       {"gaps", section.gaps}, {"has_hull", section.has_hull}};
}

Section gaps_section(const RunData& run) {
  Section section{.id = "gaps", .title = "What is missing"};
  if (run.gaps.empty()) section.text.emplace_back("Nothing: every file that the report reads was there and whole.");
  for (const Gap& gap : run.gaps) section.gaps.push_back(gap.what + ": " + gap.why);
  return section;
}

/// The section, or its title with a gap where the run's files lack what it needs.
Section made(RunData& run, const char* id, const char* title, const std::function<Section()>& make) {
  Section section{.id = id, .title = title};
  if (!run.attempt(title, [&] { section = make(); }))
    section.gaps.emplace_back("This cannot be shown. What is missing is named at the end of the page.");
  return section;
}

/// A path as a shell takes it.
std::string quoted(const std::string& path) {
  const bool is_plain = std::all_of(path.begin(), path.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '/' || c == '.' || c == '-' || c == '_';
  });
  if (is_plain) return path;
  std::string text = "'";
  for (const char c : path) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

ReportPage report_page(RunFindings& found, bool beside_run) {
  ReportPage page;
  page.title = (found.run.scene ? found.run.scene->name : "Run") + " (" + found.run.name + ")";
  if (!found.run.attempt("The first sentences", [&] { page.headline = headline(found); }))
    page.headline = {"The load of this run cannot be told. What is missing is named at the end of the page."};
  const std::string address = peak_address(found);
  if (!address.empty()) {
    const double t = found.load->along.peak.raw_time;
    const IceFrameFile* frame = frame_near(found, t);
    page.see = "To see the largest load in motion, call: nilas view " + quoted(found.run.folder.string()) + ". ";
    if (frame != nullptr && std::abs(frame->t - t) > 0.5 * found.run.step())
      page.see += fmt::format("It shows stored frames, of which the nearest is at {}. The load may lie between two. ",
                              time_text(frame->t, found.run.step()));
    page.see += "Then open " + address;
    if (beside_run && std::filesystem::exists(found.run.folder / "replay.html")) page.address = address;
  }
  found.run.attempt("The picture of the hull", [&] { page.hull = hull_picture(found); });
  const auto add = [&](const char* id, const char* title, const std::function<Section()>& make) {
    page.sections.push_back(made(found.run, id, title, make));
  };
  add("scene", "What was run", [&] { return scene_section(found); });
  add("loads", "Loads over time", [&] { return loads_section(found); });
  add("spectra", "Spectra", [&] { return spectra_section(found); });
  add("statistics", "Statistics and exceedance", [&] { return statistics_section(found); });
  add("place", "Load by place", [&] { return place_section(found, page.hull); });
  add("pressure", "Pressure over area", [&] { return pressure_section(found); });
  add("ice", "Ice ahead", [&] { return ice_section(found); });
  add("breaks", "Breaks over time", [&] { return breaks_section(found); });
  add("energy", "Energy ledger", [&] { return energy_section(found); });
  add("solver", "Solver health", [&] { return solver_section(found); });
  add("time", "Where the time went", [&] { return time_section(found); });
  page.sections.push_back(gaps_section(found.run));
  return page;
}

std::string page_html(const ReportPage& page) {
  Json sections = Json::array(), plots = Json::array();
  for (const Section& section : page.sections) {
    sections.push_back(section_json(section));
    for (const Plot& plot : section.plots) plots.push_back(plot_json(plot));
  }
  const Json data{{"title", page.title},
                  {"headline", page.headline},
                  {"see", page.see},
                  {"address", page.address},
                  {"sections", sections}};
  const std::string body = output::fill_template(report_template("report.html"), data, output::Escape::html);
  return view::report_page(page.title, body,
                           {{"plots", plots}, {"hull", page.hull ? hull_json(*page.hull) : Json(nullptr)}});
}

}  // namespace nilas::report
