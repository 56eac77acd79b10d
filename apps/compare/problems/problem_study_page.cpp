#include "apps/compare/problems/problem_study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "apps/compare/problems/problem_study_run.h"
#include "core/output/file/output_file.h"
#include "core/output/text/html.h"

namespace nilas {

namespace {

constexpr const char* k_style =
    "body{font:14px/1.5 sans-serif;max-width:1100px;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;font-size:12px;margin:.5em 0}td,th{padding:1px 6px;text-align:right;"
    "border-bottom:1px solid #ddd;white-space:nowrap}td:first-child,th:first-child{text-align:left}"
    "td.best{font-weight:bold;background:#eee}td.no{color:#666;font-style:italic}.wide{overflow-x:auto}"
    "summary{cursor:pointer;margin:.5em 0}svg{max-width:100%;height:auto}.lead{font-size:16px}"
    ".note{background:#f4f0e0;padding:.5em 1em}";

std::string cell(const std::string& text, const char* kind = "") {
  return fmt::format("<td{}>{}</td>", *kind != '\0' ? fmt::format(" class='{}'", kind) : "", html_text(text));
}

std::string heading(const std::vector<std::string>& names) {
  std::string out = "<div class='wide'><table><tr>";
  for (const auto& name : names) out += "<th>" + html_text(name) + "</th>";
  return out + "</tr>\n";
}

constexpr const char* k_end_table = "</table></div>\n";

std::string milliseconds(double seconds) {
  constexpr double k_ms = 1e3;
  return std::isfinite(seconds) ? fmt::format("{:.3g}", k_ms * seconds) : "";
}

std::string scientific(double x) { return std::isfinite(x) ? fmt::format("{:.1e}", x) : ""; }

/// The drawing itself. What gnuplot names in it is the same in all of them.
std::string drawing(const std::filesystem::path& folder, const StudyFigure& figure) {
  return fmt::format("<h3>{}</h3>\n{}\n", html_text(figure.title), inline_svg(folder / (figure.name + ".svg")));
}

std::string drawings(const std::filesystem::path& folder, const std::vector<StudyFigure>& figures,
                     const std::function<bool(const StudyFigure&)>& chosen) {
  std::string html;
  for (const auto& figure : figures)
    if (chosen(figure)) html += drawing(folder, figure);
  return html;
}

std::string score_table(const Comparison& c) {
  std::string html = heading({"solver", "solved", "fastest on", "times the fastest (geometric mean)", "median ms"});
  for (std::size_t s = 0; s < c.solvers.size(); ++s) {
    std::vector<double> own;
    for (const auto& times : c.times) own.push_back(times[s]);
    const SolverScore& score = c.scores[s];
    html += "<tr>" + cell(c.solvers[s]) + cell(fmt::format("{} of {}", score.solved, score.problems)) +
            cell(std::to_string(score.fastest)) +
            cell(score.solved > 0 ? fmt::format("{:.3g}", score.mean_ratio) : "") + cell(milliseconds(median(own))) +
            "</tr>\n";
  }
  return html + k_end_table +
         "<p>The mean is over the problems that the solver solved; the median counts a failure as endless, and is "
         "empty where most failed.</p>\n";
}

std::string class_table(const StudyReport& report, const Comparison& c) {
  std::vector<std::string> names{"solver"};
  std::vector<Comparison> parts;
  for (const auto& one : problem_classes(report.rows)) {
    const Comparison part = restricted(c, one.problems);
    if (part.problems.empty()) continue;
    names.push_back(fmt::format("{} ({})", one.name, part.problems.size()));
    parts.push_back(part);
  }
  std::string html = heading(names);
  for (std::size_t s = 0; s < c.solvers.size(); ++s) {
    html += "<tr>" + cell(c.solvers[s]);
    for (const auto& part : parts) {
      const SolverScore& score = part.scores[s];
      html += cell(score.solved > 0 ? fmt::format("{}, {:.3g} times", score.solved, score.mean_ratio) : "0");
    }
    html += "</tr>\n";
  }
  return html + k_end_table +
         "<p>Solved, and the geometric mean of the time over that of the fastest. The mass ratio is that of what the "
         "sides of contacts feel, known for files of the global form; whether most loaded contacts slide or stick is "
         "taken from the most accurate answer of all runs. Redundant (hyperstatic) contact cannot be told from the "
         "files and is not a class of its own.</p>\n";
}

std::string time_matrix(const StudyReport& report, const Comparison& c) {
  std::map<std::pair<std::string, std::string>, const StudyRow*> runs;
  std::map<std::string, int> contacts;
  for (const auto& row : report.rows) {
    contacts[row.problem.name] = row.problem.contacts;
    if (row.law == c.law && row.tolerance == c.tolerance) runs[{row.problem.name, row.solver}] = &row;
  }
  std::vector<std::string> names{"ms", "contacts"};
  names.insert(names.end(), c.solvers.begin(), c.solvers.end());
  std::string html = heading(names);
  for (std::size_t p = 0; p < c.problems.size(); ++p) {
    html += "<tr>" + cell(c.problems[p]) + cell(std::to_string(contacts[c.problems[p]]));
    const double best = *std::min_element(c.times[p].begin(), c.times[p].end());
    for (std::size_t s = 0; s < c.solvers.size(); ++s) {
      const double t = c.times[p][s];
      html += std::isfinite(t) ? cell(milliseconds(t), t == best ? "best" : "")
                               : cell(in_words(runs.at({c.problems[p], c.solvers[s]})->outcome), "no");
    }
    html += "</tr>\n";
  }
  return html + k_end_table;
}

std::string failure_table(const StudyReport& report) {
  std::map<std::string, std::map<RunOutcome, int>> counts;
  std::vector<std::string> solvers;
  std::string unreadable;
  for (const auto& row : report.rows) {
    if (row.solver.empty()) {
      unreadable += fmt::format("<li>{}: {}</li>\n", html_text(row.problem.name), html_text(row.message));
      continue;
    }
    if (counts.find(row.solver) == counts.end()) solvers.push_back(row.solver);
    ++counts[row.solver][row.outcome];
  }
  std::vector<std::string> names{"solver"};
  for (int k = 0; k <= static_cast<int>(RunOutcome::unreadable); ++k)
    names.emplace_back(in_words(static_cast<RunOutcome>(k)));
  std::string html = heading(names);
  for (const auto& solver : solvers) {
    html += "<tr>" + cell(solver);
    for (int k = 0; k <= static_cast<int>(RunOutcome::unreadable); ++k) {
      const int n = counts[solver][static_cast<RunOutcome>(k)];
      html += cell(n > 0 ? std::to_string(n) : "");
    }
    html += "</tr>\n";
  }
  html += k_end_table;
  if (!unreadable.empty()) html += "<p>Files that hold no readable problem:</p><ul>" + unreadable + "</ul>\n";
  return html;
}

std::string run_table(const StudyReport& report) {
  std::string html = heading({"problem", "contacts", "solver", "law", "tolerance [m/s]", "outcome", "time [ms]",
                              "iterations", "law map [m/s]", "natural map [m/s]", "claimed", "said"});
  for (const auto& row : report.rows)
    html += "<tr>" + cell(row.problem.name) + cell(std::to_string(row.problem.contacts)) + cell(row.solver) +
            cell(row.law) + cell(std::isfinite(row.tolerance) ? in_words(row.tolerance) : "") +
            cell(in_words(row.outcome), row.solved() ? "" : "no") + cell(milliseconds(row.seconds)) +
            cell(std::isfinite(row.seconds) ? std::to_string(row.iterations) : "") +
            cell(scientific(row.residuals.law_map_m_s)) + cell(scientific(row.residuals.natural_map_m_s)) +
            cell(row.claimed) + cell(row.message) + "</tr>\n";
  return fmt::format("<details><summary>{} rows</summary>{}{}</details>\n", report.rows.size(), html, k_end_table);
}

std::string how_measured(const StudyReport& report) {
  return fmt::format(
      "<h2>How this was measured</h2>\n<p>Every run is a process of its own (<code>nilas solve</code>), on one core "
      "with "
      "one thread, {} at a time, from zero impulses. A problem counts as solved where <code>law_map_m_s</code>, "
      "computed "
      "by Nilas from the impulses alone, is at most the tolerance and the solve took at most {:g} s, whatever the "
      "solver "
      "claims. The time is that of the solve without reading the file, the least of {} where it is below 0.05 s. "
      "Profiles take the problems that all solvers of the law were tried on; a solver that does not apply to a "
      "problem has not solved it.</p>\n<p>{} of {} planned runs were done in {:.3g} s of a budget of {:g} s; {} were "
      "left out. Problems: {}. Machine: {}. Tables: <code>compare.csv</code>, <code>profiles.csv</code>, "
      "<code>work-precision.csv</code>; pictures also as PNG.</p>\n",
      report.jobs, report.limit_s, k_study_repeats, report.planned - std::min(report.planned, report.dropped.size()),
      report.planned, report.wall_s, report.budget_s, report.dropped.size(), html_text(report.problems.string()),
      html_text(report.machine));
}

std::string state_of(const StudyReport& report) {
  std::string html;
  if (report.status != "done")
    html += fmt::format(
        "<p class='note'>This study is {}: what follows is what is done so far. <code>nilas compare "
        "--resume</code> goes on.</p>\n",
        report.status == "running" ? "running, or was killed" : html_text(report.status));
  const std::string dropped = dropped_text(report);
  if (!dropped.empty()) html += "<p class='note'>Left out for lack of time: " + html_text(dropped) + "</p>\n";
  return html;
}

}  // namespace

std::string dropped_text(const StudyReport& report) {
  std::map<std::pair<std::string, double>, std::set<std::string>> by;
  std::map<std::pair<std::string, double>, int> runs;
  std::vector<std::pair<std::string, double>> order;
  std::set<std::string> all;
  for (const auto& row : report.rows)
    if (!row.solver.empty()) all.insert(row.problem.name);
  for (const auto& row : report.dropped) {
    const std::pair key(row.law, row.tolerance);
    if (runs[key]++ == 0) order.push_back(key);
    by[key].insert(row.problem.name);
    all.insert(row.problem.name);
  }
  std::string text;
  for (const auto& key : order) {
    const auto& problems = by[key];
    const std::string names = problems.size() == all.size() && all.size() > 1
                                  ? fmt::format("all {} problems", all.size())
                                  : fmt::format("{}", fmt::join(problems, ", "));
    text += fmt::format("{}{} runs at {} m/s ({}) on {}", text.empty() ? "" : "; ", runs[key], in_words(key.second),
                        key.first, names);
  }
  return text;
}

void write_study_page(const std::filesystem::path& folder, const StudyReport& report,
                      const std::vector<Comparison>& comparisons, const std::vector<StudyFigure>& figures,
                      const std::string& no_pictures) {
  using Kind = StudyFigure::Kind;
  std::string html = fmt::format(
      "<!doctype html><html lang='en'><head><meta charset='utf-8'><title>nilas compare --problems</title><style>{}"
      "</style></head>\n<body><h1>Solvers on stored contact problems</h1>\n",
      k_style);
  const bool any = !comparisons.empty();
  const StudyFigure* const first = figures.empty() ? nullptr : &figures.front();
  html += any ? "<p class='lead'>" + html_text(headline(comparisons.front())) + "</p>\n"
              : "<p class='lead'>No problem has been tried with all solvers yet.</p>\n";
  if (first != nullptr) html += drawing(folder, *first);
  if (!no_pictures.empty()) html += "<p class='note'>There are no pictures: " + html_text(no_pictures) + "</p>\n";
  html += state_of(report);
  if (any) html += score_table(comparisons.front());
  if (first != nullptr) {
    html +=
        "<h2>Accuracy against time</h2>\n<p>A mark per tolerance: how long, and what was reached. Further left is "
        "faster, further down more accurate. Medians count a failure as endless, so a solver has a point only where "
        "it solved most; tolerances that were not tried on all of the problems are left out of them.</p>\n" +
        drawings(folder, figures, [](const StudyFigure& f) { return f.kind == Kind::medians; }) +
        drawings(folder, figures, [](const StudyFigure& f) { return f.kind == Kind::problems; }) +
        "<h2>The other profiles</h2>\n<p>A performance profile shows the share of the problems that a solver "
        "solved within so many times the time of the fastest: its left end how often it was the fastest, its right "
        "end how many it solved. A data profile shows the same share against the time itself.</p>\n" +
        drawings(folder, figures, [first](const StudyFigure& f) {
          return &f != first && (f.kind == Kind::performance || f.kind == Kind::data);
        });
  }
  if (any) {
    const Comparison& c = comparisons.front();
    html += "<h2>By class of problem</h2>\n" + class_table(report, c);
    html += fmt::format("<h2>Times at {} m/s, law {}</h2>\n", in_words(c.tolerance), html_text(c.law)) +
            time_matrix(report, c);
  }
  html += "<h2>Runs by outcome, all tolerances</h2>\n" + failure_table(report);
  html += "<h2>All runs</h2>\n" + run_table(report);
  html += "<h2>In words</h2>\n<p>";
  for (const auto& c : comparisons) html += fmt::format("Law {}. {} ", html_text(c.law), html_text(headline(c)));
  html += "</p>\n" + how_measured(report) + "</body></html>\n";
  write_whole(folder / "compare.html", html);
}

}  // namespace nilas
