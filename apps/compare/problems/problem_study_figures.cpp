#include "apps/compare/problems/problem_study_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "contact/registry.h"
#include "core/output/file/csv_row.h"
#include "core/output/file/output_file.h"
#include "core/output/text/plot.h"

namespace nilas {

namespace {

constexpr std::size_t k_panels = 6;  // single problems
constexpr double k_widest = 1e4;     // end of the performance profile at most

/// One look per solver on all pictures: colour, dashes and mark differ, so that grey print tells them apart.
std::string look_of(const std::string& solver) {
  static const std::vector<const char*> colours{"#000000", "#e69f00", "#56b4e9", "#009e73",
                                                "#cc79a7", "#0072b2", "#d55e00", "#7f7f7f"};
  static const std::vector<const char*> dashes{"'-'", "1", "'.'", "'-.'", "'--.'"};
  if (solver == "auto") return "lc rgb '#000000' dt 1 pt 7 ps 0.7 lw 2.6";
  const auto& all = solver_registry();
  const auto found = std::find_if(all.begin(), all.end(), [&](const SolverEntry& e) { return e.name == solver; });
  const auto k = static_cast<std::size_t>(found - all.begin()) + 1;
  // 7 is the mark of auto
  return fmt::format("lc rgb '{}' dt {} pt {} ps 0.7 lw 1.6", colours[k % colours.size()], dashes[k % dashes.size()],
                     k < 7 ? k : k + 1);
}

void add_profile(std::string& csv, const Comparison& c, const char* kind, const std::vector<Profile>& all, double from,
                 double to) {
  for (std::size_t s = 0; s < c.solvers.size(); ++s) {
    const auto add = [&](double x, double share) {
      CsvRow row;
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

/// Smallest and largest x, to whole decades.
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

void write_profiles(const std::filesystem::path& file, const std::vector<Comparison>& comparisons) {
  std::string csv = csv_header({"law", "tolerance_m_s", "kind", "solver", "ratio_1_or_time_s", "share_1"});
  for (const auto& c : comparisons) {
    add_profile(csv, c, "performance", c.by_ratio, 1, std::min(k_widest, decades(c.by_ratio).second));
    const auto [low, high] = decades(c.by_time);
    add_profile(csv, c, "data", c.by_time, low, high);
  }
  write_whole(file, csv);
}

void write_points(const std::filesystem::path& file, std::vector<WorkPoint> points) {
  std::stable_sort(points.begin(), points.end(), [](const WorkPoint& a, const WorkPoint& b) {
    return std::tuple(a.law, a.problem, a.solver, -a.tolerance) < std::tuple(b.law, b.problem, b.solver, -b.tolerance);
  });
  std::string csv = csv_header({"law", "problem", "solver", "tolerance_m_s", "solve_s", "law_map_m_s"});
  for (const auto& point : points) {
    CsvRow row;
    row.text(point.law).text(point.problem.empty() ? "median" : point.problem).text(point.solver);
    row.shortest(point.tolerance).shortest(point.seconds).shortest(point.residual);
    csv += row.line();
  }
  write_whole(file, csv);
}

/// Both terminals: as wide as the page, and half as large again.
std::string on_both(const std::string& name, int width, int height, const std::string& script) {
  return fmt::format(
      "set terminal svg size {},{} font 'sans,12' background '#ffffff'\nset output '{}.svg'\n{}unset output\n"
      "set terminal pngcairo size {},{} font 'sans,18'\nset output '{}.png'\n{}unset output\n",
      width, height, name, script, 3 * width / 2, 3 * height / 2, name, script);
}

/// Within single quotes of gnuplot.
std::string quoted(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out;
}

std::string profile_script(const StudyFigure& figure, const Comparison& c) {
  const bool performance = figure.kind == StudyFigure::Kind::performance;
  const auto [low, high] = decades(performance ? c.by_ratio : c.by_time);
  std::string script = fmt::format(
      "reset\nset datafile separator ','\nset logscale x\nset format x '10^{{%L}}'\nset xrange [{}:{}]\n"
      "set yrange [-0.02:1.02]\nset ytics 0.2\nset grid lc rgb '#dddddd'\nset key outside right noenhanced\n"
      "set xlabel '{}'\nset ylabel 'share of the {} problems solved [-]'\n",
      low, performance ? std::min(k_widest, high) : high,
      performance ? "time over that of the fastest solver of the problem [-]" : "time of the solve [s]",
      c.problems.size());
  std::string drawn;
  for (const auto& solver : c.solvers) {
    const std::string rows = fmt::format(
        "'profiles.csv' using (strcol(1) eq '{}' && strcol(3) eq '{}' && strcol(4) eq '{}' && "
        "abs($2/{}-1) < 1e-9 ? $5 : NaN):6",
        c.law, performance ? "performance" : "data", solver, c.tolerance);
    const std::string look = look_of(solver);
    drawn +=
        fmt::format("{}{} with steps {} notitle, {} with points {} notitle, keyentry with linespoints {} title '{}'",
                    drawn.empty() ? "plot " : ", ", rows, look, rows, look, look, solver);
  }
  return on_both(figure.name, 960, 430, script + drawn + "\n");
}

std::string curves(const std::string& law, const std::string& problem, const std::vector<std::string>& solvers,
                   bool titled) {
  std::string drawn;
  for (const auto& solver : solvers)
    drawn += fmt::format(
        "{}'work-precision.csv' using (strcol(1) eq '{}' && strcol(2) eq '{}' && strcol(3) eq '{}' ? $5 : NaN):"
        "($6 > 1e-17 ? $6 : 1e-17) with linespoints {} {}",
        drawn.empty() ? "plot " : ", ", law, quoted(problem), solver, look_of(solver),
        titled ? "title '" + solver + "'" : "notitle");
  return drawn + "\n";
}

constexpr const char* k_work_axes =
    "reset\nset datafile separator ','\nset logscale xy\nset format '10^{%L}'\nset grid lc rgb '#dddddd'\n"
    "set key outside right noenhanced\nset xlabel 'time of the solve [s]'\nset ylabel 'law\\_map\\_m\\_s reached "
    "[m/s]'\n";

std::string panels_script(const StudyFigure& figure, const std::vector<std::string>& problems,
                          const std::vector<std::string>& solvers) {
  constexpr std::size_t k_columns = 3;
  constexpr double k_panel = 250, k_names = 90;  // heights
  const std::size_t lines = (problems.size() + k_columns - 1) / k_columns;
  const double height = k_panel * static_cast<double>(lines) + k_names;
  std::string script =
      fmt::format("{}set multiplot\nunset key\nset xtics font ',9'\nset ytics font ',9'\nset size {},{}\n", k_work_axes,
                  1.0 / k_columns, k_panel / height);
  for (std::size_t k = 0; k < problems.size(); ++k) {
    const double left = static_cast<double>(k % k_columns) / k_columns,
                 below = 1 - static_cast<double>(k / k_columns + 1) * k_panel / height;
    script += fmt::format("set origin {},{}\nset title '{}' noenhanced font ',10'\n{}", left, below,
                          quoted(problems[k]), curves(figure.law, problems[k], solvers, false));
  }
  // the names of all lines below the panels
  script += fmt::format(
      "set size 1,{}\nset origin 0,0\nset margins 0,0,0,0\nunset title\nunset xlabel\nunset ylabel\nunset tics\n"
      "unset border\nunset grid\nset key center center maxrows 4 noenhanced\nset xrange [1:2]\nset yrange [1:2]\nplot ",
      k_names / height);
  for (std::size_t s = 0; s < solvers.size(); ++s)
    script +=
        fmt::format("{}keyentry with linespoints {} title '{}'", s > 0 ? ", " : "", look_of(solvers[s]), solvers[s]);
  return on_both(figure.name, 960, static_cast<int>(height), script + ", NaN notitle\nunset multiplot\n");
}

}  // namespace

std::vector<StudyFigure> draw_study(const std::filesystem::path& folder, const std::vector<StudyRow>& rows,
                                    const std::vector<Comparison>& comparisons) {
  using Kind = StudyFigure::Kind;
  std::vector<WorkPoint> points = median_points(rows, comparisons);
  const std::vector<WorkPoint> single = problem_points(rows, comparisons, k_panels);
  points.insert(points.end(), single.begin(), single.end());
  write_profiles(folder / "profiles.csv", comparisons);
  write_points(folder / "work-precision.csv", points);
  std::vector<StudyFigure> figures;
  std::string script;
  std::set<std::string> laws;
  for (const auto& c : comparisons) {
    const std::string at = c.law + "-" + in_words(c.tolerance);
    for (const Kind kind : {Kind::performance, Kind::data}) {
      const bool ratio = kind == Kind::performance;
      figures.push_back(
          {kind, (ratio ? "performance-" : "data-") + at,
           fmt::format("{} profile at {} m/s, law {}", ratio ? "Performance" : "Data", in_words(c.tolerance), c.law),
           c.law, c.tolerance});
      script += profile_script(figures.back(), c);
    }
    if (laws.insert(c.law).second && std::any_of(points.begin(), points.end(), [&](const WorkPoint& point) {
          return point.law == c.law && point.problem.empty();
        })) {
      figures.push_back({Kind::medians, "work-precision-" + c.law,
                         fmt::format("Work and precision, medians over the problems, law {}", c.law), c.law, 0});
      script += on_both(figures.back().name, 960, 430, k_work_axes + curves(c.law, "median", c.solvers, true));
    }
  }
  std::vector<std::string> problems;
  for (const auto& point : single)
    if (std::find(problems.begin(), problems.end(), point.problem) == problems.end()) problems.push_back(point.problem);
  if (!problems.empty()) {
    figures.push_back({Kind::problems, "problems-" + comparisons.front().law,
                       "Work and precision on single problems, from the quickest to the slowest to be solved",
                       comparisons.front().law, 0});
    script += panels_script(figures.back(), problems, comparisons.front().solvers);
  }
  if (!script.empty()) plot(folder, script);
  return figures;
}

}  // namespace nilas
