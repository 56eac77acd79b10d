#include "apps/compare/problems/problem_study_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "apps/compare/problems/problem_study_plan.h"

namespace nilas::compare {

namespace {

constexpr double k_heavy = 1e4;  // mass ratio
constexpr double k_good = 1e-4;  // residual of an answer that shows whether contacts slide or stick [m/s]

template <class Value>
void add_once(std::vector<Value>& list, const Value& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

/// The rows of runs by law, problem, solver and tolerance.
using RowsByRun = std::map<std::tuple<std::string, std::string, std::string, double>, const StudyRow*>;

RowsByRun by_run(const std::vector<StudyRow>& rows) {
  RowsByRun all;
  for (const auto& row : rows)
    if (!row.solver.empty()) all[{row.law, row.problem.name, row.solver, row.tolerance}] = &row;
  return all;
}

void add_scores(SolverComparison& out) {
  out.by_ratio = profiles(time_ratios(out.times));
  out.by_time = profiles(out.times);
  out.scores = scores(out.times);
}

SolverComparison compare_at(const RowsByRun& runs, const std::string& law, double tolerance,
                            const std::vector<std::string>& problems, const std::vector<std::string>& solvers) {
  SolverComparison out;
  out.law = law;
  out.tolerance = tolerance;
  out.solvers = solvers;
  for (const auto& problem : problems) {
    std::vector<double> times;
    for (const auto& solver : solvers) {
      const auto found = runs.find({law, problem, solver, tolerance});
      if (found == runs.end()) break;
      times.push_back(found->second->solved() ? found->second->seconds : k_unsolved);
    }
    if (times.size() != solvers.size()) continue;
    out.problems.push_back(problem);
    out.times.push_back(times);
  }
  add_scores(out);
  return out;
}

std::string count_of(std::size_t solved, std::size_t problems) {
  if (solved == problems && problems == 1) return "the one problem";
  return solved == problems ? fmt::format("all {} problems", problems)
                            : fmt::format("{} of {} problems", solved, problems);
}

}  // namespace

std::vector<SolverComparison> compare_solvers(const std::vector<StudyRow>& rows) {
  std::vector<std::string> laws, problems;
  std::map<std::string, std::vector<std::string>> solvers;
  std::map<std::string, std::vector<double>> tolerances;
  for (const auto& row : rows) {
    if (row.solver.empty()) continue;
    add_once(laws, row.law);
    add_once(problems, row.problem.name);
    add_once(solvers[row.law], row.solver);
    add_once(tolerances[row.law], row.tolerance);
  }
  const RowsByRun runs = by_run(rows);
  std::vector<SolverComparison> all;
  for (const auto& law : laws)
    for (const double tolerance : middle_first(tolerances[law])) {
      const SolverComparison one = compare_at(runs, law, tolerance, problems, solvers[law]);
      if (!one.problems.empty()) all.push_back(one);
    }
  return all;
}

SolverComparison restricted(const SolverComparison& all, const std::vector<std::string>& problems) {
  SolverComparison out;
  out.law = all.law;
  out.tolerance = all.tolerance;
  out.solvers = all.solvers;
  for (std::size_t k = 0; k < all.problems.size(); ++k) {
    if (std::find(problems.begin(), problems.end(), all.problems[k]) == problems.end()) continue;
    out.problems.push_back(all.problems[k]);
    out.times.push_back(all.times[k]);
  }
  add_scores(out);
  return out;
}

std::string headline(const SolverComparison& c) {
  const auto solves = [&](std::size_t k) {
    return std::tuple(c.scores[k].solved, c.scores[k].fastest, -c.scores[k].mean_ratio);
  };
  const auto wins = [&](std::size_t k) {
    return std::tuple(c.scores[k].fastest, c.scores[k].solved, -c.scores[k].mean_ratio);
  };
  std::size_t most = 0, quickest = 0;
  for (std::size_t s = 1; s < c.solvers.size(); ++s) {
    if (solves(s) > solves(most)) most = s;
    if (wins(s) > wins(quickest)) quickest = s;
  }
  const std::size_t problems = c.problems.size(), solved = c.scores[most].solved;
  const std::string start = fmt::format("At {} m/s", in_words(c.tolerance));
  if (solved == 0) return fmt::format("{} no solver solved any of {} problems within its time.", start, problems);
  const auto as_many =
      std::count_if(c.scores.begin(), c.scores.end(), [&](const SolverScore& score) { return score.solved == solved; });
  std::string text = fmt::format("{} {} solved {}", start, c.solvers[most], count_of(solved, problems));
  if (as_many > 1)
    text += fmt::format(", as did {} other{}", as_many - 1, as_many > 2 ? "s" : "");
  else if (c.solvers.size() > 1)
    text += ", more than any other";
  text += fmt::format(", in {:.3g} times the time of the fastest (geometric mean)", c.scores[most].mean_ratio);
  if (quickest == most)
    text += fmt::format(", and was itself the fastest on {:.0f} % of them.",
                        100 * static_cast<double>(c.scores[most].fastest) / static_cast<double>(problems));
  else
    text += fmt::format("; {} was the fastest most often, on {:.0f} % of them, and solved {}.", c.solvers[quickest],
                        100 * static_cast<double>(c.scores[quickest].fastest) / static_cast<double>(problems),
                        count_of(c.scores[quickest].solved, problems));
  const auto unsolved = std::count_if(c.times.begin(), c.times.end(), [](const std::vector<double>& times) {
    return std::none_of(times.begin(), times.end(), [](double t) { return std::isfinite(t); });
  });
  if (unsolved > 0) text += fmt::format(" {} {} solved by none.", unsolved, unsolved == 1 ? "was" : "were");
  return text;
}

std::vector<WorkPoint> median_points(const std::vector<StudyRow>& rows,
                                     const std::vector<SolverComparison>& comparisons) {
  const RowsByRun runs = by_run(rows);
  std::map<std::string, const SolverComparison*> first;
  std::vector<WorkPoint> points;
  for (const auto& c : comparisons) {
    // medians over different problems cannot be compared
    const SolverComparison& whole = *first.try_emplace(c.law, &c).first->second;
    if (c.problems != whole.problems) continue;
    for (std::size_t s = 0; s < c.solvers.size(); ++s) {
      std::vector<double> seconds, residuals;
      for (std::size_t p = 0; p < c.problems.size(); ++p) {
        seconds.push_back(c.times[p][s]);
        const double reached = runs.at({c.law, c.problems[p], c.solvers[s], c.tolerance})->residuals.law_map_m_s;
        residuals.push_back(std::isfinite(reached) ? reached : k_unsolved);
      }
      const WorkPoint point{c.law, "", c.solvers[s], c.tolerance, median(seconds), median(residuals)};
      if (std::isfinite(point.seconds) && std::isfinite(point.residual)) points.push_back(point);
    }
  }
  return points;
}

std::vector<WorkPoint> problem_points(const std::vector<StudyRow>& rows,
                                      const std::vector<SolverComparison>& comparisons, std::size_t count) {
  if (comparisons.empty()) return {};
  const SolverComparison& first = comparisons.front();
  std::vector<std::pair<double, std::string>> by_time;
  for (std::size_t p = 0; p < first.problems.size(); ++p)
    by_time.emplace_back(*std::min_element(first.times[p].begin(), first.times[p].end()), first.problems[p]);
  std::sort(by_time.begin(), by_time.end());
  std::vector<WorkPoint> points;
  count = std::min(count, by_time.size());
  for (std::size_t k = 0; k < count; ++k) {
    const std::string& chosen = by_time[count > 1 ? k * (by_time.size() - 1) / (count - 1) : 0].second;
    for (const auto& row : rows)
      if (row.problem.name == chosen && row.law == first.law && std::isfinite(row.seconds) &&
          std::isfinite(row.residuals.law_map_m_s))
        points.push_back({row.law, chosen, row.solver, row.tolerance, row.seconds, row.residuals.law_map_m_s});
  }
  return points;
}

std::vector<ProblemClass> problem_classes(const std::vector<StudyRow>& rows) {
  std::map<std::string, const StudyRow*> best;
  for (const auto& row : rows) {
    if (row.solver.empty()) continue;
    const auto [place, is_new] = best.try_emplace(row.problem.name, &row);
    const double known = place->second->residuals.law_map_m_s, own = row.residuals.law_map_m_s;
    if (!is_new && (own < known || std::isnan(known))) place->second = &row;
  }
  std::vector<ProblemClass> classes{
      {"mass ratio above 1e4", {}}, {"mostly sliding", {}}, {"mostly sticking", {}}, {k_unknown_class, {}}};
  for (const auto& [name, row] : best) {
    std::size_t kind = row->sliding > row->sticking ? 1 : 2;
    if (!(row->residuals.law_map_m_s <= k_good)) kind = 3;
    if (row->problem.mass_ratio > k_heavy) kind = 0;
    classes[kind].problems.push_back(name);
  }
  classes.erase(
      std::remove_if(classes.begin(), classes.end(), [](const ProblemClass& one) { return one.problems.empty(); }),
      classes.end());
  return classes;
}

}  // namespace nilas::compare
