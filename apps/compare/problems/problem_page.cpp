#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "apps/compare/problems/problem_report.h"
#include "apps/compare/problems/problem_study_run.h"
#include "apps/compare/workshop/json_store.h"
#include "apps/compare/workshop/page_text.h"
#include "core/output/file/output_file.h"
#include "core/output/text/html.h"

namespace nilas::compare {

namespace {

std::string milliseconds(double seconds) {
  constexpr double k_ms = 1e3;
  return std::isfinite(seconds) ? fmt::format("{:.3g}", k_ms * seconds) : "";
}

std::string scientific(double x) { return std::isfinite(x) ? fmt::format("{:.1e}", x) : ""; }

Json scores_of(const SolverComparison& c) {
  Json scores = Json::array();
  for (std::size_t s = 0; s < c.solvers.size(); ++s) {
    std::vector<double> own;
    for (const auto& times : c.times) own.push_back(times[s]);
    const SolverScore& score = c.scores[s];
    scores.push_back({{"solver", c.solvers[s]},
                      {"solved", score.solved},
                      {"problems", score.problems},
                      {"fastest", score.fastest},
                      {"ratio", score.solved > 0 ? fmt::format("{:.3g}", score.mean_ratio) : ""},
                      {"median", milliseconds(median(own))}});
  }
  return scores;
}

/// Adds the columns and rows of the table by class of problem.
void add_classes(const ProblemReport& report, const SolverComparison& c, Json& view) {
  Json classes = Json::array(), rows = Json::array();
  std::vector<SolverComparison> parts;
  for (const auto& one : problem_classes(report.rows)) {
    const SolverComparison part = restricted(c, one.problems);
    if (part.problems.empty()) continue;
    classes.push_back({{"name", one.name}, {"count", part.problems.size()}});
    parts.push_back(part);
  }
  for (std::size_t s = 0; s < c.solvers.size(); ++s) {
    Json cells = Json::array();
    for (const auto& part : parts) {
      const SolverScore& score = part.scores[s];
      cells.push_back(score.solved > 0 ? fmt::format("{}, {:.3g} times", score.solved, score.mean_ratio) : "0");
    }
    rows.push_back({{"solver", c.solvers[s]}, {"cells", cells}});
  }
  view["classes"] = classes;
  view["class_rows"] = rows;
}

Json times_of(const ProblemReport& report, const SolverComparison& c) {
  std::map<std::pair<std::string, std::string>, const StudyRow*> runs;
  std::map<std::string, int> contacts;
  for (const auto& row : report.rows) {
    contacts[row.problem.name] = row.problem.contacts;
    if (row.law == c.law && row.tolerance == c.tolerance) runs[{row.problem.name, row.solver}] = &row;
  }
  Json rows = Json::array();
  for (std::size_t p = 0; p < c.problems.size(); ++p) {
    Json cells = Json::array();
    const double best = *std::min_element(c.times[p].begin(), c.times[p].end());
    for (std::size_t s = 0; s < c.solvers.size(); ++s) {
      const double t = c.times[p][s];
      const bool solved = std::isfinite(t);
      cells.push_back({{"kind", !solved     ? "no"
                                : t == best ? "n best"
                                            : "n"},
                       {"text", solved ? milliseconds(t) : in_words(runs.at({c.problems[p], c.solvers[s]})->outcome)}});
    }
    rows.push_back({{"problem", c.problems[p]}, {"contacts", contacts[c.problems[p]]}, {"cells", cells}});
  }
  return rows;
}

Json comparison_view(const ProblemReport& report, const SolverComparison& c) {
  Json view{{"scores", scores_of(c)},
            {"tolerance", in_words(c.tolerance)},
            {"law", c.law},
            {"solvers", c.solvers},
            {"times", times_of(report, c)}};
  add_classes(report, c, view);
  return view;
}

/// Adds the runs by solver and outcome, and the files that cannot be read.
void add_outcomes(const ProblemReport& report, Json& view) {
  constexpr int k_outcomes = static_cast<int>(RunOutcome::unreadable) + 1;
  std::map<std::string, std::map<int, int>> counts;
  std::vector<std::string> solvers;
  Json outcomes = Json::array(), rows = Json::array(), files = Json::array();
  for (const auto& row : report.rows) {
    if (row.solver.empty()) {
      files.push_back({{"name", row.problem.name}, {"message", row.message}});
      continue;
    }
    if (counts.find(row.solver) == counts.end()) solvers.push_back(row.solver);
    ++counts[row.solver][static_cast<int>(row.outcome)];
  }
  for (int k = 0; k < k_outcomes; ++k) outcomes.push_back(in_words(static_cast<RunOutcome>(k)));
  for (const auto& solver : solvers) {
    Json cells = Json::array();
    for (int k = 0; k < k_outcomes; ++k)
      cells.push_back(counts[solver][k] > 0 ? std::to_string(counts[solver][k]) : "");
    rows.push_back({{"solver", solver}, {"cells", cells}});
  }
  view["outcomes"] = outcomes;
  view["outcome_rows"] = rows;
  view["unreadable"] = files.empty() ? Json(nullptr) : Json{{"files", files}};
}

Json rows_of(const ProblemReport& report) {
  Json rows = Json::array();
  for (const auto& row : report.rows) {
    const bool ran = std::isfinite(row.seconds);
    rows.push_back({{"problem", row.problem.name},
                    {"contacts", row.problem.contacts},
                    {"solver", row.solver},
                    {"law", row.law},
                    {"tolerance", std::isfinite(row.tolerance) ? in_words(row.tolerance) : ""},
                    {"outcome", in_words(row.outcome)},
                    {"outcome_class", row.solved() ? "" : "no"},
                    {"time", milliseconds(row.seconds)},
                    {"iterations", ran ? std::to_string(row.iterations) : ""},
                    {"law_map", scientific(row.residuals.law_map_m_s)},
                    {"natural_map", scientific(row.residuals.natural_map_m_s)},
                    {"claimed", row.claimed},
                    {"message", row.message}});
  }
  return rows;
}

Json figures_of(const std::filesystem::path& folder, const std::vector<ProblemPicture>& pictures,
                const std::vector<ProblemPicture::Kind>& kinds) {
  Json figures = Json::array();
  for (std::size_t k = 1; k < pictures.size(); ++k)  // the first is next to the answer
    if (std::find(kinds.begin(), kinds.end(), pictures[k].kind) != kinds.end())
      figures.push_back(
          {{"title", pictures[k].title}, {"svg", output::inline_svg(folder / (pictures[k].picture.name + ".svg"))}});
  return figures;
}

void add_figures(const std::filesystem::path& folder, const std::vector<ProblemPicture>& pictures, Json& view) {
  using Kind = ProblemPicture::Kind;
  view["first_figure"] = nullptr;
  if (!pictures.empty())
    view["first_figure"] = {{"title", pictures.front().title},
                            {"svg", output::inline_svg(folder / (pictures.front().picture.name + ".svg"))}};
  view["work_figures"] = figures_of(folder, pictures, {Kind::medians, Kind::problems});
  const Json profiles = figures_of(folder, pictures, {Kind::performance, Kind::data});
  view["profiles"] = profiles.empty() ? Json(nullptr) : Json{{"figures", profiles}};
}

std::string status_text(const ProblemReport& report) {
  if (report.status == "done") return "";
  return fmt::format("This study is {}. The page shows what is done so far.",
                     report.status == "running" ? "running, or was killed" : report.status);
}

void add_method(const ProblemReport& report, Json& view) {
  view["jobs"] = report.jobs;
  view["limit"] = fmt::format("{:g}", report.limit_s);
  view["repeats"] = k_study_repeats;
  view["done"] = report.planned - std::min(report.planned, report.dropped.size());
  view["planned"] = report.planned;
  view["wall"] = fmt::format("{:.3g}", report.wall_s);
  view["budget"] = fmt::format("{:g}", report.budget_s);
  view["dropped"] = report.dropped.size();
  view["folder"] = report.problems.string();
  view["machine"] = report.machine;
}

}  // namespace

std::string dropped_text(const ProblemReport& report) {
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

void write_problem_page(const std::filesystem::path& folder, const ProblemReport& report,
                        const std::vector<SolverComparison>& comparisons, const std::vector<ProblemPicture>& pictures,
                        const std::string& no_pictures) {
  Json sentences = Json::array();
  for (const auto& c : comparisons) sentences.push_back(fmt::format("Law {}. {}", c.law, headline(c)));
  Json view{{"page_title", "nilas compare --problems"},
            {"page_heading", "Solvers on stored contact problems"},
            {"subtitle", fmt::format("{} rows of runs on the problems in {}", report.rows.size(),
                                     report.problems.filename().string())},
            {"status", status_text(report)},
            {"answer", comparisons.empty() ? Json{"No problem has been tried with all solvers yet."}
                                           : Json{headline(comparisons.front())}},
            {"comparison", comparisons.empty() ? Json(nullptr) : comparison_view(report, comparisons.front())},
            {"left_out", dropped_text(report)},
            {"no_figures", no_pictures},
            {"sentences", sentences},
            {"row_count", report.rows.size()},
            {"rows", rows_of(report)}};
  add_outcomes(report, view);
  add_figures(folder, pictures, view);
  add_method(report, view);
  output::write_whole(folder / "compare.html", page_text("problem_page.html", view));
}

}  // namespace nilas::compare
