#include "apps/report/page/report_page.h"

#include <fmt/format.h>

#include <cmath>

#include "apps/report/page/headline.h"
#include "apps/report/page/ice_section.h"
#include "apps/report/page/load_sections.h"
#include "apps/report/page/numerics_sections.h"
#include "apps/report/page/scene_section.h"
#include "apps/report/templates.h"
#include "apps/view/page.h"
#include "core/output/text/fill_template.h"

namespace nilas::report {

namespace {

using Json = nlohmann::ordered_json;

/// Numbers with six significant digits, which a screen does not need more of; null where one is not finite.
Json numbers_json(const std::vector<double>& values) {
  constexpr int k_digits = 6;
  Json list = Json::array();
  for (const double value : values) {
    if (!std::isfinite(value)) {
      list.push_back(nullptr);
      continue;
    }
    const double power = value == 0 ? 0 : std::floor(std::log10(std::abs(value)));
    const double unit = std::pow(10, std::abs(k_digits - 1 - power));
    const bool small = power < k_digits - 1;
    list.push_back(small ? std::round(value * unit) / unit : std::round(value / unit) * unit);
  }
  return list;
}

Json plot_json(const Plot& plot) {
  Json curves = Json::array(), levels = Json::array();
  for (const Curve& curve : plot.curves)
    curves.push_back({{"name", curve.name},
                      {"x", numbers_json(curve.x)},
                      {"y", numbers_json(curve.y)},
                      {"low", numbers_json(curve.low)},
                      {"high", numbers_json(curve.high)},
                      {"dots", curve.is_dots},
                      {"steps", curve.is_steps}});
  for (const Level& level : plot.levels)
    levels.push_back({{"name", level.name}, {"y", level.y}, {"half_width", level.half_width}});
  return {{"id", plot.id},       {"x_label", plot.x_label},     {"y_label", plot.y_label}, {"log_x", plot.log_x},
          {"log_y", plot.log_y}, {"over_time", plot.over_time}, {"curves", curves},        {"levels", levels}};
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

}  // namespace

ReportPage report_page(RunFindings& found) {
  ReportPage page;
  page.title = (found.run.scene ? found.run.scene->name : "Run") + " (" + found.run.name + ")";
  page.headline = headline(found);
  const std::string address = peak_address(found);
  if (!address.empty()) {
    page.see = "To see the largest load in motion, call: nilas view " + found.run.name + ". Then open " + address;
    if (std::filesystem::exists(found.run.folder / "replay.html")) page.address = address;
  }
  page.hull = hull_picture(found);
  page.sections.push_back(scene_section(found));
  page.sections.push_back(loads_section(found));
  page.sections.push_back(spectra_section(found));
  page.sections.push_back(statistics_section(found));
  page.sections.push_back(place_section(found, page.hull));
  page.sections.push_back(pressure_section(found));
  page.sections.push_back(ice_section(found));
  page.sections.push_back(breaks_section(found));
  page.sections.push_back(energy_section(found));
  page.sections.push_back(solver_section(found));
  page.sections.push_back(time_section(found));
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
