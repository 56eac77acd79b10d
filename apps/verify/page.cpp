#include "apps/verify/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "apps/verify/table.h"
#include "apps/verify/templates.h"
#include "core/base/error.h"
#include "core/output/text/fill_template.h"
#include "core/output/text/html.h"
#include "core/output/text/plot.h"

namespace nilas::verify {

namespace {

/// Errors below this value are drawn at it, because the axis is logarithmic.
constexpr double k_floor = 1e-18;

/// Returns the gnuplot script of a family: cases along x, errors along y, a mark per solver, allowed errors as bars.
std::string family_script(char family, const std::vector<const Row*>& rows) {
  std::vector<std::string> cases;
  std::map<std::string, std::vector<const Row*>> by_solver;
  for (const Row* row : rows) {
    if (cases.empty() || cases.back() != row->id) cases.push_back(row->id);
    by_solver[row->model.solver].push_back(row);
  }
  const auto place = [&](const Row* row) {
    return static_cast<double>(std::find(cases.begin(), cases.end(), row->id) - cases.begin());
  };
  std::string allowed;
  int mark = 0;
  const double width = 0.7 / static_cast<double>(std::max<std::size_t>(by_solver.size(), 1));
  for (const Row* row : rows)
    allowed += fmt::format("{} {} {}\n", place(row) - 0.4, std::max(row->tolerance, k_floor), place(row) + 0.4);
  auto solvers = nlohmann::ordered_json::array();
  for (const auto& [solver, own] : by_solver) {
    ++mark;
    std::string errors;
    for (const Row* row : own)
      errors += fmt::format("{} {}\n", place(row) - 0.35 + width * (mark - 0.5),
                            std::isfinite(row->error) ? std::max(row->error, k_floor) : 1.0);
    solvers.push_back({{"mark", mark}, {"rows", errors}, {"solver", solver}});
  }
  std::string ticks;
  for (std::size_t k = 0; k < cases.size(); ++k) ticks += fmt::format("{}'{}' {}", k > 0 ? ", " : "", cases[k], k);
  const nlohmann::ordered_json data{
      {"family", std::string(1, family)},
      {"allowed", allowed},
      {"solvers", solvers},
      {"foot", k_floor / 3},
      {"right", static_cast<double>(cases.size()) - 0.4},
      {"ticks", ticks},
      {"formats",
       {{{"kind", "svg"}, {"terminal", "svg size 960,380 font 'sans,12' background '#ffffff'"}},
        {{"kind", "png"}, {"terminal", "pngcairo size 1440,570 font 'sans,14'"}}}}};
  return output::fill_template(verify_template("family.gnuplot"), data, output::Escape::gnuplot);
}

std::string family_table(const std::vector<const Row*>& rows) {
  std::string html =
      "<table><tr><th>case</th><th>quantity</th><th>input</th><th>law</th><th>solver</th><th>integrator</th>"
      "<th>step [s]</th><th>measured</th><th>expected</th><th>error</th><th>allowed</th><th>order</th><th></th></tr>\n";
  for (const Row* row : rows)
    html += fmt::format(
        "<tr class='{}'><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{:g}</td><td>{:.9g}</td>"
        "<td>{:.9g}</td><td>{:.1e}</td><td>{:.1e}</td><td>{}</td><td>{}</td></tr>\n",
        row->holds ? "holds" : "fails", row->id, output::html_text(row->quantity), output::html_text(row->input),
        row->model.law, row->model.solver, row->model.integrator, row->model.step, row->measured, row->expected,
        row->error, row->tolerance, row->proven_order > 0 ? fmt::format("{:.2f}", row->order) : "",
        row->holds ? "holds" : "FAILS " + output::html_text(row->message));
  return html + "</table>\n";
}

}  // namespace

void write_page(const std::filesystem::path& folder, const std::vector<Row>& rows) {
  std::map<char, std::vector<const Row*>> families;
  for (const auto& row : rows) families[row.family].push_back(&row);
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.holds; });
  std::string html = fmt::format(
      "<!doctype html><html lang='en'><head><meta charset='utf-8'><title>nilas verify</title><style>{}</style></head>"
      "<body><h1>Cases with known answers</h1><p>{} rows, {} of them fail. A row is one quantity of a case with one "
      "law, "
      "solver and integrator. Its error is |measured - expected| over the scale of the quantity. In the pictures each "
      "mark is a row, and the bar at its place is the allowed error. Errors of zero lie at the lower edge.</p>\n",
      output::k_page_style, rows.size(), failed);
  for (const auto& [family, own] : families) {
    output::plot(folder, family_script(family, own));
    html += fmt::format("<h2>{} {}</h2>\n", family, family_title(family));
    html += output::inline_svg(folder / fmt::format("family-{}.svg", family));
    html += "<ul>";
    for (const auto& one : catalogue()) {
      const bool shown = std::any_of(own.begin(), own.end(), [&](const Row* row) { return row->id == one.id(); });
      if (shown)
        html += fmt::format("<li><b>{}</b> {}: {}</li>\n", one.id(), output::html_text(one.title),
                            output::html_text(one.formula));
    }
    html += fmt::format("</ul><details{}><summary>{} rows</summary>{}</details>\n", failed > 0 ? " open" : "",
                        own.size(), family_table(own));
  }
  html += "</body></html>\n";
  std::ofstream out(folder / "verify.html");
  out << html;
  if (!out.flush()) throw FileError("cannot write " + (folder / "verify.html").string());
}

}  // namespace nilas::verify
