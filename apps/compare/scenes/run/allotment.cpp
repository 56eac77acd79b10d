#include "apps/compare/scenes/run/allotment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/compare/workshop/special_numbers.h"

namespace nilas::compare {

namespace {

constexpr double k_long_s = 30;  // shorter budgets keep less than k_closing_s for the end [s]

/// The shortest simulated time that gives a mean load [s].
double least_length(const Plan& plan) { return k_least_mean_steps * coarsest_step(plan.settings); }

/// The share of the time left that the first run may take. With one job another run must follow it.
double first_share(int jobs) {
  constexpr double k_alone = 0.45, k_beside = 0.8;
  return jobs > 1 ? k_beside : k_alone;
}

}  // namespace

RunEnd run_end(const RunResult& result, double start) {
  RunEnd end{.wall_s = result.wall_s, .done = result.done(), .timed_out = result.status == "budget"};
  const output::RunSummary& summary = result.summary;
  end.reached_s = std::isnan(summary.time_end_s) ? start : summary.time_end_s;
  if (!summary.touched.value_or(true)) return end;
  end.window_from_s = summary.window ? summary.window->from : start;  // without a vessel there is no window
  return end;
}

std::optional<double> needed_budget(const Plan& plan, const RunEnd& first, double measuring_s, int jobs) {
  constexpr double k_reserve = 1.2;
  const double reached = first.reached_s - plan.start;
  if (!(reached > 0)) return std::nullopt;
  const double end = std::isnan(first.window_from_s) ? plan.end : first.window_from_s + least_length(plan);
  const double setup = std::min(plan.setup_s, first.wall_s);
  const double one = setup + (first.wall_s - setup) / reached * (end - plan.start);
  const double wanted = measuring_s + k_closing_s + k_reserve * one / first_share(jobs);
  return rounded_budget(wanted);
}

Allotment::Allotment(Plan& plan, double budget_s, double stated_budget_s, int jobs, double first_pace)
    : plan_(plan),
      budget_s_(budget_s),
      stated_budget_s_(stated_budget_s),
      jobs_(std::max(1, jobs)),
      planned_end_(plan.end),
      pace_(first_pace, plan.setup_s) {}

void Allotment::took(const std::map<std::string, RunResult>& results) {
  pace_.took(plan_, results);
  for (const auto& [id, result] : results) begun_end_[id] = plan_.end;
}

double Allotment::left_s(double elapsed_s) const {
  if (budget_s_ <= 0) return k_infinity;
  return budget_s_ - k_closing_s * std::min(1.0, budget_s_ / k_long_s) - elapsed_s;
}

/// Whether nothing can be compared without this run.
bool Allotment::essential(const PlannedRun& run) const {
  if (run.kind == RunKind::reference) return true;
  return run.kind == RunKind::grid && run.setting <= 1 && (run.setting == 0 || run.realisation == 0);
}

double Allotment::share() const {
  const double length = planned_end_ - plan_.start;
  return length > 0 ? (plan_.end - plan_.start) / length : 1;
}

Allotment::Need Allotment::missing(const std::function<bool(const PlannedRun&)>& counts) const {
  Need sum, longest;
  for (const auto& run : plan_.runs) {
    if (run.realisation > 0 || begun_end_.count(run.id) > 0 || !counts(run)) continue;
    const Need one{expected_s(run), pace_.expected_setup_s(run)};
    sum.wall_s += one.wall_s / jobs_;
    sum.setup_s += one.setup_s / jobs_;
    if (one.wall_s > longest.wall_s) longest = one;
  }
  return sum.wall_s > longest.wall_s ? sum : longest;
}

double Allotment::least_end() const {
  return std::isnan(window_from_) ? k_infinity : window_from_ + least_length(plan_);
}

/// Whether all runs may be cut to the time that one has reached: not if another setting is done over more than twice
/// that time.
bool Allotment::worth_telling(double reached_s) const {
  constexpr double k_half = 0.5;
  if (!(reached_s >= least_end())) return false;
  return !beside_done_ || reached_s - window_from_ >= k_half * (plan_.end - window_from_);
}

void Allotment::end_at(double t) {
  const double end = plan_.coarsest_end(t);
  if (!(end < plan_.end)) return;
  plan_.end = end;
  const auto of_time = [](const Omission& o) { return o.what.starts_with("simulated time"); };
  std::erase_if(plan_.omissions, of_time);
  plan_.omissions.insert(plan_.omissions.begin(),
                         {fmt::format("simulated time from {:g} s to {:g} s", plan_.end, plan_.scene_end),
                          fmt::format("the budget of {:g} s", stated_budget_s_)});
}

/// Shortens the simulated time of all runs rather than leave out a setting, down to a quarter of the window. Below
/// that, settings are left out, the last first. The time is shortened further for the essential runs, and for the
/// perturbed run, which shows the effect of chance, if that run then fits.
void Allotment::shorten(double elapsed_s) {
  constexpr double k_reserve = 0.9, k_quarter = 0.25;
  const double room = k_reserve * std::max(0.0, left_s(elapsed_s)), least = least_end();
  if (!std::isfinite(least)) return;
  const auto fit = [&](const Need& need, double shortest, bool only_where_it_helps) {
    if (!(need.wall_s > room) || !(plan_.end > shortest)) return;
    const double kept = std::max(0.0, room - need.setup_s) / (need.wall_s - need.setup_s);
    const double end = plan_.start + (plan_.end - plan_.start) * kept;
    if (end >= shortest || !only_where_it_helps) end_at(std::max(shortest, end));
  };
  const auto all = [](const PlannedRun&) { return true; };
  const auto with_twin = [&](const PlannedRun& run) { return essential(run) || run.kind == RunKind::twin; };
  fit(missing(all), std::max(least, window_from_ + k_quarter * (planned_end_ - window_from_)), false);
  fit(missing(with_twin), least, true);
  fit(missing([&](const PlannedRun& run) { return essential(run); }), least, false);
}

RunStart Allotment::begin(const PlannedRun& run, double elapsed_s) {
  if (budget_s_ <= 0) return {};
  if (run.kind == RunKind::grid && slow_.count(run.setting) > 0) return {false, true, 0};
  if (run.realisation == 0) shorten(elapsed_s);
  constexpr double k_patience = 4, k_share = 0.1, k_twice = 2;
  const double left = left_s(elapsed_s), expected = expected_s(run);
  begun_end_[run.id] = plan_.end;
  const bool first = run.kind == RunKind::grid && run.realisation == 0;
  if (!(expected < left) && !(essential(run) && first && left > 0)) return {false, false, 0, expected, left};
  RunStart start{true, false, left};
  if (!essential(run)) {
    // a run that is far slower than expected must not take the time that the others need
    start.limit_s = std::min(left, std::max(k_patience * expected, k_share * budget_s_));
    if (start.limit_s < left) patient_[run.id] = expected;
  } else if (first && !pace_known_) {
    // the runs with which others are compared must leave time for some to be compared with them
    const double part = first_share(jobs_) * left;
    start.limit_s = expected < left ? std::min(left, std::max(k_twice * expected, part)) : part;
  }
  return start;
}

RunVerdict Allotment::ended(const PlannedRun& run, const RunEnd& end) {
  const double until = begun_end_.count(run.id) > 0 ? begun_end_.at(run.id) : planned_end_;
  const double whole = planned_end_ - plan_.start, reached = std::min(end.reached_s, until) - plan_.start;
  const bool first = run.kind == RunKind::grid && run.realisation == 0;
  if (first && run.setting == 0 && (end.done || end.timed_out)) {
    pace_known_ = true;
    window_from_ = end.window_from_s;
  }
  const bool beside = first && run.setting > 0;
  if (end.done) {
    pace_.took(run, end.wall_s, reached > 0 ? reached / whole : 1);
    beside_done_ = beside_done_ || beside;
    return RunVerdict::as_it_ended;
  }
  if (!end.timed_out) return RunVerdict::as_it_ended;
  if (end.reached_s >= plan_.end - k_step_rounding * coarsest_step(plan_.settings)) {
    beside_done_ = beside_done_ || beside;
    return RunVerdict::far_enough;
  }
  if (essential(run) && run.realisation == 0 && worth_telling(end.reached_s)) {
    pace_.took(run, end.wall_s, reached / whole);
    end_at(end.reached_s);
    beside_done_ = beside_done_ || beside;
    return RunVerdict::far_enough;
  }
  if (patient_.count(run.id) == 0) return RunVerdict::as_it_ended;
  if (run.kind == RunKind::grid) slow_.insert(run.setting);
  return RunVerdict::too_slow;
}

}  // namespace nilas::compare
