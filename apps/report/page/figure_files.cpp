#include "apps/report/page/figure_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "apps/report/templates.h"
#include "core/output/text/fill_template.h"
#include "core/output/text/plot.h"

namespace nilas::report {

namespace {

using Json = nlohmann::ordered_json;

/// The colours of Okabe and Ito, which those who see colours differently can tell apart; then some for plots of many
/// curves.
constexpr std::array k_colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9",
                               "#000000", "#7b3fbf", "#8a5a2b", "#e0359b", "#7a9a01", "#9c1c28"};

const char* colour_of(std::size_t k) { return k_colours[k % k_colours.size()]; }

/// Rows "x y low high" of a curve; a blank line where there is no value, which parts the line.
std::string curve_rows(const Curve& curve, const Plot& plot) {
  std::string rows;
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    const bool drawn =
        std::isfinite(curve.y[k]) && !(plot.log_y && curve.y[k] <= 0) && !(plot.log_x && curve.x[k] <= 0);
    const bool ranged = !curve.low.empty() && drawn;
    rows += drawn ? fmt::format("{:.9g} {:.6g} {:.6g} {:.6g}\n", curve.x[k], curve.y[k],
                                ranged ? curve.low[k] : curve.y[k], ranged ? curve.high[k] : curve.y[k])
                  : "\n";
  }
  return rows;
}

Json formats_of(const std::string& id) {
  return {{{"terminal", "svg size 760,420 font 'sans,12' background '#ffffff'"}, {"file", id + ".svg"}},
          {{"terminal", "pdfcairo size 16cm,9cm font 'sans,10'"}, {"file", id + ".pdf"}}};
}

/// The range of x of all curves; null on a logarithmic axis, whose ends gnuplot finds better.
Json range_json(const Plot& plot) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Curve& curve : plot.curves)
    for (const double x : curve.x) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  if (plot.log_x || !(low < high)) return nullptr;
  return {{"low", low}, {"high", high}};
}

/// The range of y that is shown; null for that of all values.
Json shown_json(const Plot& plot) {
  if (!plot.y_range) return nullptr;
  return {{"low", plot.y_range->front()}, {"high", plot.y_range->back()}};
}

/// The lowest value that a logarithmic axis shows, eight decades below the largest; null on another axis.
Json lowest_json(const Plot& plot) {
  constexpr double k_decades = 1e-8;
  double high = 0, low = std::numeric_limits<double>::infinity();
  for (const Curve& curve : plot.curves)
    for (const double y : curve.y)
      if (y > 0) {
        high = std::max(high, y);
        low = std::min(low, y);
      }
  if (!plot.log_y || low > k_decades * high) return nullptr;
  return k_decades * high;
}

Json figure_json(const Plot& plot) {
  Json curves = Json::array(), levels = Json::array();
  for (std::size_t k = 0; k < plot.curves.size(); ++k) {
    const Curve& curve = plot.curves[k];
    const std::string rows = curve_rows(curve, plot);
    if (rows.find_first_not_of('\n') == std::string::npos) continue;  // gnuplot takes no block without a point
    curves.push_back({{"block", fmt::format("curve_{}", k)},
                      {"rows", rows},
                      {"name", curve.name},
                      {"colour", colour_of(k)},
                      {"dash", k < k_colours.size() ? 1 : 2},
                      {"has_range", !curve.low.empty()},
                      {"style", curve.is_dots    ? "points pt 7 ps 0.4"
                                : curve.is_steps ? "steps lw 1.2"
                                                 : "lines lw 1.2"}});
  }
  for (const Level& level : plot.levels)
    levels.push_back({{"y", level.y},
                      {"name", level.name},
                      {"low", level.y - level.half_width},
                      {"high", level.y + level.half_width},
                      {"has_band", level.half_width > 0}});
  return {{"title", plot.title},
          {"x_label", plot.x_label},
          {"y_label", plot.y_label},
          {"log_x", plot.log_x},
          {"log_y", plot.log_y},
          {"curves", curves},
          {"levels", levels},
          {"x_range", range_json(plot)},
          {"y_low", lowest_json(plot)},
          {"y_range", shown_json(plot)},
          {"formats", formats_of(plot.id)}};
}

std::string place_rows(const HullPicture& picture) {
  std::string rows;
  for (const PlaceCell& cell : picture.load.cells)
    rows += fmt::format("{:.6g} {:.6g} {:.6g}\n", cell.along, cell.height - picture.water, cell.impulse);
  return rows;
}

}  // namespace

std::vector<std::string> write_figures(const ReportPage& page, const std::filesystem::path& folder) {
  std::vector<std::string> files;
  const auto note = [&](const std::string& id) {
    files.push_back(id + ".svg");
    files.push_back(id + ".pdf");
  };
  for (const Section& section : page.sections)
    for (const Plot& plot : section.plots) {
      const Json figure = figure_json(plot);
      if (figure.at("curves").empty()) continue;
      output::plot(folder, output::fill_template(report_template("figure.gnuplot"), figure, output::Escape::gnuplot));
      note(plot.id);
    }
  if (page.hull) {
    const Json place{
        {"rows", place_rows(*page.hull)},      {"side", page.hull->is_vessel ? "to port" : "0 towards the ice"},
        {"half", 0.5 * page.hull->load.width}, {"low", -0.5 * page.hull->outline},
        {"high", 0.5 * page.hull->outline},    {"formats", formats_of("load-by-place")}};
    output::plot(folder, output::fill_template(report_template("place.gnuplot"), place, output::Escape::gnuplot));
    note("load-by-place");
  }
  return files;
}

}  // namespace nilas::report
