#include "apps/compare/problems/problem_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <tuple>

#include "apps/compare/workshop/json_store.h"
#include "contact/registry.h"
#include "core/output/file/csv_row.h"
#include "core/output/file/output_file.h"
#include "core/output/text/plot.h"

namespace nilas::compare {

namespace {

constexpr std::size_t k_panels = 6;  // single problems
constexpr double k_widest = 1e4;     // end of the performance profile at most

/// The look of a solver in all pictures. Colour, dashes and mark differ, so that solvers differ in grey print too.
std::string look_of(const std::string& solver) {
  static const std::vector<const char*> colours{"#000000", "#e69f00", "#56b4e9", "#009e73",
                                                "#cc79a7", "#0072b2", "#d55e00", "#7f7f7f"};
  static const std::vector<const char*> dashes{"'-'", "1", "'.'", "'-.'", "'--.'"};
  if (solver == "auto") return "lc rgb '#000000' dt 1 pt 7 ps 0.7 lw 2.6";
  const auto& all = contact::solver_registry();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const contact::SolverEntry& e) { return e.name == solver; });
  const auto k = static_cast<std::size_t>(found - all.begin()) + 1;
  // 7 is the mark of auto
  return fmt::format("lc rgb '{}' dt {} pt {} ps 0.7 lw 1.6", colours[k % colours.size()], dashes[k % dashes.size()],
                     k < 7 ? k : k + 1);
}

void add_profile(std::string& csv, const SolverComparison& c, const char* kind, const std::vector<Profile>& all,
                 double from, double to) {
  for (std::size_t s = 0; s < c.solvers.size(); ++s) {
    const auto add = [&](double x, double share) {
      output::CsvRow row;
      row.text(c.law).shortest(c.tolerance).text(kind).text(c.solvers[s]).shortest(x).shortest(share);
      csv += row.line();
    };
    double share = 0;
    add(from, share);
    for (const auto& point : all[s]) {
      if (point.x > to) break;
      add(point.x, share = point.share);
    }
    add(to, share);
  }
}

/// The smallest and largest x, rounded outwards to whole decades.
std::pair<double, double> decades(const std::vector<Profile>& all) {
  double low = k_unsolved, high = 0;
  for (const auto& profile : all)
    for (const auto& point : profile) {
      low = std::min(low, point.x);
      high = std::max(high, point.x);
    }
  if (!(high > 0)) return {1, 10};
  const double least = std::pow(10, std::floor(std::log10(std::max(low, 1e-9))));
  return {least, std::max(10 * least, std::pow(10, std::ceil(std::log10(high))))};
}

void write_profiles(const std::filesystem::path& file, const std::vector<SolverComparison>& comparisons) {
  std::string csv = output::csv_header({"law", "tolerance_m_s", "kind", "solver", "ratio_1_or_time_s", "share_1"});
  for (const auto& c : comparisons) {
    add_profile(csv, c, "performance", c.by_ratio, 1, std::min(k_widest, decades(c.by_ratio).second));
    const auto [low, high] = decades(c.by_time);
    add_profile(csv, c, "data", c.by_time, low, high);
  }
  output::write_whole(file, csv);
}

void write_points(const std::filesystem::path& file, std::vector<WorkPoint> points) {
  std::stable_sort(points.begin(), points.end(), [](const WorkPoint& a, const WorkPoint& b) {
    return std::tuple(a.law, a.problem, a.solver, -a.tolerance) < std::tuple(b.law, b.problem, b.solver, -b.tolerance);
  });
  std::string csv = output::csv_header({"law", "problem", "solver", "tolerance_m_s", "solve_s", "law_map_m_s"});
  for (const auto& point : points) {
    output::CsvRow row;
    row.text(point.law).text(point.problem.empty() ? "median" : point.problem).text(point.solver);
    row.shortest(point.tolerance).shortest(point.seconds).shortest(point.residual);
    csv += row.line();
  }
  output::write_whole(file, csv);
}

Json with_looks(const std::vector<std::string>& solvers) {
  Json list = Json::array();
  for (const auto& solver : solvers) list.push_back({{"name", solver}, {"look", look_of(solver)}});
  return list;
}

constexpr int k_profile_height = 430;
constexpr double k_png = 1.5;  // size of the PNG over that of the SVG

Picture profile_picture(const SolverComparison& c, bool performance) {
  const auto [low, high] = decades(performance ? c.by_ratio : c.by_time);
  return {.name = fmt::format("{}-{}-{}", performance ? "performance" : "data", c.law, in_words(c.tolerance)),
          .script = "profile.gnuplot",
          .height = k_profile_height,
          .png_factor = k_png,
          .data = {{"low", low},
                   {"high", performance ? std::min(k_widest, high) : high},
                   {"x_label", performance ? "time divided by that of the fastest solver of the problem [-]"
                                           : "time of the solve [s]"},
                   {"problems", c.problems.size()},
                   {"kind", performance ? "performance" : "data"},
                   {"law", c.law},
                   {"tolerance", c.tolerance},
                   {"solvers", with_looks(c.solvers)}}};
}

Picture medians_picture(const SolverComparison& c) {
  return {.name = "work-precision-" + c.law,
          .script = "work_precision.gnuplot",
          .height = k_profile_height,
          .png_factor = k_png,
          .data = {{"law", c.law}, {"solvers", with_looks(c.solvers)}}};
}

Picture panels_picture(const SolverComparison& c, const std::vector<std::string>& problems) {
  constexpr std::size_t k_columns = 3;
  constexpr double k_panel = 250, k_names = 90;  // heights
  const std::size_t lines = (problems.size() + k_columns - 1) / k_columns;
  const double height = k_panel * static_cast<double>(lines) + k_names;
  Json panels = Json::array();
  for (std::size_t k = 0; k < problems.size(); ++k)
    panels.push_back({{"problem", problems[k]},
                      {"left", static_cast<double>(k % k_columns) / k_columns},
                      {"bottom", 1 - static_cast<double>(k / k_columns + 1) * k_panel / height}});
  return {.name = "problems-" + c.law,
          .script = "problem_panels.gnuplot",
          .height = static_cast<int>(height),
          .png_factor = k_png,
          .data = {{"law", c.law},
                   {"width", 1.0 / k_columns},
                   {"panel_height", k_panel / height},
                   {"names_height", k_names / height},
                   {"panels", panels},
                   {"solvers", with_looks(c.solvers)}}};
}

std::vector<std::string> problems_of(const std::vector<WorkPoint>& points) {
  std::vector<std::string> problems;
  for (const auto& point : points)
    if (std::find(problems.begin(), problems.end(), point.problem) == problems.end()) problems.push_back(point.problem);
  return problems;
}

}  // namespace

std::vector<ProblemPicture> draw_problem_study(const std::filesystem::path& folder, const std::vector<StudyRow>& rows,
                                               const std::vector<SolverComparison>& comparisons) {
  using Kind = ProblemPicture::Kind;
  std::vector<WorkPoint> points = median_points(rows, comparisons);
  const std::vector<WorkPoint> single = problem_points(rows, comparisons, k_panels);
  points.insert(points.end(), single.begin(), single.end());
  write_profiles(folder / "profiles.csv", comparisons);
  write_points(folder / "work-precision.csv", points);
  std::vector<ProblemPicture> pictures;
  std::set<std::string> laws;
  for (const auto& c : comparisons) {
    const std::string at = fmt::format("profile at {} m/s, law {}", in_words(c.tolerance), c.law);
    pictures.push_back({Kind::performance, "Performance " + at, profile_picture(c, true)});
    pictures.push_back({Kind::data, "Data " + at, profile_picture(c, false)});
    const bool has_medians = std::any_of(points.begin(), points.end(), [&](const WorkPoint& point) {
      return point.law == c.law && point.problem.empty();
    });
    if (laws.insert(c.law).second && has_medians)
      pictures.push_back({Kind::medians, fmt::format("Medians over the problems, law {}", c.law), medians_picture(c)});
  }
  if (!single.empty())
    pictures.push_back({Kind::problems, "Single problems, from the quickest to the slowest to be solved",
                        panels_picture(comparisons.front(), problems_of(single))});
  std::string script;
  for (const auto& one : pictures) script += script_of(one.picture);
  if (!script.empty()) output::plot(folder, script);
  return pictures;
}

bool is_problem_picture_file(const std::string& name) {
  static const std::regex own(
      R"((profiles|work-precision)\.csv|(performance|data|work-precision|problems)-[A-Za-z0-9+.-]+\.(svg|png))");
  return std::regex_match(name, own);
}

}  // namespace nilas::compare
