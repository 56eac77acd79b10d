#include <cmath>

#include "apps/compare/problems/problem_report.h"
#include "apps/compare/problems/problem_study_table.h"
#include "apps/compare/workshop/json_store.h"

namespace nilas::compare {

namespace {

Json profile_json(const Profile& profile) {
  Json points = Json::array();
  for (const auto& point : profile) points.push_back({point.x, point.share});
  return points;
}

Json comparison_json(const SolverComparison& c) {
  Json solvers = Json::array();
  for (std::size_t s = 0; s < c.solvers.size(); ++s) {
    const SolverScore& score = c.scores[s];
    solvers.push_back({{"solver", c.solvers[s]},
                       {"solved", score.solved},
                       {"fastest", score.fastest},
                       {"mean_ratio_1", std::isfinite(score.mean_ratio) ? Json(score.mean_ratio) : Json()},
                       {"share_by_ratio_1", profile_json(c.by_ratio[s])},
                       {"share_by_time_s", profile_json(c.by_time[s])}});
  }
  return {{"law", c.law},
          {"tolerance_m_s", c.tolerance},
          {"problems", c.problems},
          {"headline", headline(c)},
          {"solvers", solvers}};
}

}  // namespace

Json problem_report_json(const ProblemReport& report, const std::vector<SolverComparison>& comparisons) {
  Json rows = Json::array(), dropped = Json::array(), profiles = Json::array(), classes = Json::object();
  for (const auto& row : report.rows) rows.push_back(study_json(row));
  for (const auto& row : report.dropped)
    dropped.push_back(
        {{"problem", row.problem.name}, {"solver", row.solver}, {"law", row.law}, {"tolerance_m_s", row.tolerance}});
  for (const auto& one : comparisons) profiles.push_back(comparison_json(one));
  for (const auto& one : problem_classes(report.rows))
    classes[one.name == k_unknown_class ? "not told" : one.name] = one.problems;  // a key that scripts know
  return {{"status", report.status},
          {"options",
           {{"problems", report.problems.string()},
            {"solvers", report.solvers},
            {"laws", report.laws},
            {"tolerances_m_s", report.tolerances},
            {"budget_s", report.budget_s},
            {"jobs", report.jobs}}},
          {"limit_s", report.limit_s},
          {"machine", report.machine},
          {"wall_s", report.wall_s},
          {"planned_runs", report.planned},
          {"estimate_s", report.estimate_s},
          {"at_most_s", report.at_most_s},
          {"dropped", dropped},
          {"classes", classes},
          {"profiles", profiles},
          {"rows", rows}};
}

}  // namespace nilas::compare
