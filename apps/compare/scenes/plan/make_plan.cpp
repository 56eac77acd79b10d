#include "apps/compare/scenes/plan/make_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "apps/compare/workshop/special_numbers.h"

namespace nilas::compare {

namespace {

/// The share of the budget for the runs. The rest is for starting, reading, drawing and for estimates that are too low.
constexpr double k_share_of_runs = 0.85;

/// A plan while it is cut to fit: an input, what is kept of it, and what that costs.
struct Draft {
  const PlanInput* input;
  std::vector<std::size_t> candidates;  ///< settings that have not been given up for good
  std::vector<std::size_t> kept;
  int realisations;
  double length;  ///< simulated [s]
  double reference_tolerance;
  double room_s;  ///< processor time that is available [s]

  double setting_seconds(std::size_t k) const {
    const CompareSetting &setting = input->settings[k], &first = input->settings.front();
    return input->cost.setup_s +
           input->cost.steps_seconds(length, solver_weight(setting, first)) * first.step / setting.step;
  }
  /// The processor time of a run of the reference [s]. It has a factor of two, because problems grow harder as ice
  /// piles up, most of all for tight solves.
  double reference_seconds(double step) const {
    constexpr double k_harder = 2;
    const double weight = k_harder * input->cost.reference_weight(reference_tolerance);
    return input->cost.setup_s + input->cost.steps_seconds(length, weight) * input->settings.front().step / step;
  }
  /// The step of the reference [s]: half the finest step that is kept, or its own if it goes from event to event.
  double reference_step() const {
    if (!input->request.check) return input->reference.step;
    double finest = k_infinity;
    for (const std::size_t k : kept) finest = std::min(finest, input->settings[k].step);
    return 0.5 * finest;
  }
  double references_seconds() const {
    if (!input->request.reference) return 0;
    return reference_seconds(reference_step()) * realisations +
           (input->request.check ? reference_seconds(2 * reference_step()) : 0);
  }
  double total() const {
    double sum = setting_seconds(0) * realisations;  // its perturbed runs
    for (const std::size_t k : kept) sum += setting_seconds(k) * realisations;
    return sum + references_seconds();
  }
  double wall_seconds() const {
    return std::max(total() / input->request.jobs, input->request.reference ? reference_seconds(reference_step()) : 0);
  }
  /// Whether the plan fits. With many jobs, the longest run may take more wall time than all others together.
  bool fits() const {
    const double longest = input->request.reference ? reference_seconds(reference_step()) : setting_seconds(0);
    return total() <= room_s && longest * input->request.jobs <= room_s;
  }
  bool reference_takes_most() const {
    constexpr double k_most = 0.3;
    return input->request.reference && !input->request.fixed_reference && references_seconds() > k_most * total();
  }
};

/// The draft with all that was asked for.
Draft whole_draft(const PlanInput& input) {
  const PlanRequest& request = input.request;
  Draft draft{&input, {}, {}, request.realisations, request.end - request.start, input.reference.tolerance, 0};
  for (std::size_t k = 0; k < input.settings.size(); ++k) draft.kept.push_back(k);
  draft.candidates = draft.kept;
  draft.room_s = request.budget_s > 0 ? std::max(0.0, k_share_of_runs * request.budget_s - k_closing_s) * request.jobs
                                      : k_infinity;
  return draft;
}

/// The tightest tolerance of the settings that are kept [m/s]; k_usual_tolerance if all of them make a fixed number of
/// sweeps.
double tightest_tolerance(const Draft& draft) {
  double least = k_infinity;
  for (const std::size_t k : draft.kept)
    if (draft.input->settings[k].tolerance > 0) least = std::min(least, draft.input->settings[k].tolerance);
  return std::isfinite(least) ? least : k_usual_tolerance;
}

Draft with_core_only(Draft draft) {
  draft.kept.resize(std::min(draft.kept.size(), draft.input->core));
  return draft;
}

Draft with_looser_reference(Draft draft) {
  constexpr double k_decade = 10, k_rounding = 1 + 1e-9;
  while (draft.reference_tolerance * k_decade <= loosest_reference(tightest_tolerance(draft)) * k_rounding &&
         !draft.fits() && draft.reference_takes_most())
    draft.reference_tolerance *= k_decade;
  return draft;
}

/// Leaves out the settings that solve tighter than the first, because more simulated time is more informative than
/// they.
Draft without_tighter_settings(Draft draft) {
  const double own = draft.input->settings.front().tolerance;
  if (draft.input->request.fixed_tolerances || !(own > 0) || !draft.reference_takes_most()) return draft;
  const auto tighter = [&](std::size_t k) {
    const double tolerance = draft.input->settings[k].tolerance;
    return tolerance > 0 && tolerance < own;
  };
  std::erase_if(draft.kept, tighter);
  std::erase_if(draft.candidates, tighter);
  return with_looser_reference(draft);
}

Draft with_realisations(Draft draft, int at_most) {
  if (!draft.input->request.fixed_realisations) draft.realisations = std::min(draft.realisations, at_most);
  return draft;
}

/// The length rounded down to two digits, which a noisy estimate does not change often.
double rounded_down(double length) {
  const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1);
  return std::floor(length / unit) * unit;
}

/// Cuts the simulated time, but keeps a share of the time from the start of the load's window on, and at least
/// k_least_mean_steps.
Draft shortened(Draft draft, double share) {
  constexpr int k_halvings = 40;
  const double full = draft.length, step = coarsest_step(draft.input->settings);
  const double window_from = draft.input->cost.window_from;
  const double before = std::isnan(window_from) ? 0 : std::clamp(window_from - draft.input->request.start, 0.0, full);
  const double least = std::min(full, before + std::max(share * (full - before), k_least_mean_steps * step));
  double low = least, high = full;
  for (int k = 0; k < k_halvings; ++k) {
    draft.length = 0.5 * (low + high);
    (draft.fits() ? low : high) = draft.length;
  }
  draft.length = std::max(least, std::floor(rounded_down(low) / step) * step);
  return draft;
}

/// Leaves out settings from the end, but keeps `least` of them.
Draft with_fewer_settings(Draft draft, std::size_t least) {
  while (!draft.fits() && draft.kept.size() > least) draft.kept.pop_back();
  return draft;
}

/// Takes back settings that were cut from the end as far as there is room, since cheap ones may follow costly ones.
Draft refilled(Draft draft) {
  const std::vector<std::size_t> whole = draft.kept;
  for (const std::size_t k : draft.candidates) {
    if (std::find(whole.begin(), whole.end(), k) != whole.end()) continue;
    draft.kept.push_back(k);
    if (!draft.fits()) draft.kept.pop_back();
  }
  std::sort(draft.kept.begin(), draft.kept.end());
  return draft;
}

/// The draft cut to fit where a reference judges.
Draft cut_against_reference(Draft draft) {
  if (!draft.fits()) draft = with_core_only(draft);
  if (!draft.fits()) draft = with_looser_reference(draft);
  if (!draft.fits()) draft = without_tighter_settings(draft);
  if (!draft.fits()) draft = with_realisations(draft, 2);
  if (!draft.fits() && !draft.input->request.fixed_length) draft = shortened(draft, 0);
  return refilled(with_fewer_settings(draft, 1));
}

/// The draft cut to fit where the first setting judges. The settings are in the order of their importance, and each is
/// informative by itself. Fewer of them are better than a window that holds only the first contact with the ice.
Draft cut_against_first(Draft draft) {
  constexpr double k_quarter = 0.25;
  if (!draft.fits()) draft = with_realisations(draft, 2);
  if (!draft.fits()) draft = shortened(draft, k_quarter);
  if (!draft.fits()) draft = with_realisations(draft, 1);
  draft = with_fewer_settings(draft, 2);
  if (!draft.fits()) draft = shortened(draft, 0);
  return refilled(with_fewer_settings(draft, 1));
}

std::vector<Omission> omissions_of(const Draft& draft) {
  const PlanInput& input = *draft.input;
  const PlanRequest& request = input.request;
  std::vector<Omission> omissions;
  const auto omit = [&](const std::string& what) {
    omissions.push_back({what, fmt::format("the budget of {:g} s", request.stated_budget_s)});
  };
  if (draft.length < request.end - request.start)
    omit(fmt::format("simulated time from {:g} s to {:g} s", request.start + draft.length, request.end));
  if (draft.realisations < request.realisations)
    omit(fmt::format("{} of {} realisations", request.realisations - draft.realisations, request.realisations));
  if (draft.reference_tolerance > input.reference.tolerance * 2)
    omit(fmt::format("the reference at {:.0e} m/s (it is solved to {:.0e} m/s)", input.reference.tolerance,
                     draft.reference_tolerance));
  for (std::size_t k = 0; k < input.settings.size(); ++k)
    if (std::find(draft.kept.begin(), draft.kept.end(), k) == draft.kept.end())
      omit(fmt::format("{} (about {:.3g} s of processor time)", label_of(input.settings[k], input.settings.front()),
                       draft.setting_seconds(k) * draft.realisations));
  return omissions;
}

/// The rank of a run within its realisation. The most informative runs come first, so that a budget that is used up
/// early costs the least: the run that judges the others, then the first setting and its perturbed run, which show the
/// effect of chance, then the other settings. If the first setting judges, the most important setting comes before its
/// perturbed run.
int rank_of(const PlannedRun& run, bool first_judges) {
  const bool first = run.realisation == 0;
  switch (run.kind) {
    case RunKind::reference:
      return first ? 0 : 3;
    case RunKind::twin:
      return 2;
    case RunKind::check:
      return 3;
    case RunKind::grid:
      break;
  }
  return run.setting == 0 || (first_judges && first && run.setting == 1) ? 1 : 4;
}

std::vector<PlannedRun> runs_of(const Draft& draft) {
  const PlanRequest& request = draft.input->request;
  const double step = draft.reference_step();
  std::vector<PlannedRun> runs;
  for (int r = 0; r < draft.realisations; ++r) {
    runs.push_back({fmt::format("s00-r{}", r), RunKind::grid, 0, r, draft.setting_seconds(0)});
    if (request.reference)
      runs.push_back({fmt::format("reference-r{}", r), RunKind::reference, 0, r, draft.reference_seconds(step)});
    if (request.reference && request.check && r == 0)
      runs.push_back({"check-r0", RunKind::check, 0, 0, draft.reference_seconds(2 * step)});
    runs.push_back({fmt::format("s00-r{}-twin", r), RunKind::twin, 0, r, draft.setting_seconds(0)});
    for (std::size_t k = 1; k < draft.kept.size(); ++k)
      runs.push_back({fmt::format("s{:02d}-r{}", k, r), RunKind::grid, k, r, draft.setting_seconds(draft.kept[k])});
  }
  const auto place = [&](const PlannedRun& run) {
    return std::tuple(run.realisation, rank_of(run, !request.reference), run.setting);
  };
  std::stable_sort(runs.begin(), runs.end(),
                   [&](const PlannedRun& a, const PlannedRun& b) { return place(a) < place(b); });
  return runs;
}

Plan plan_of(const Draft& draft) {
  const PlanRequest& request = draft.input->request;
  Plan plan;
  plan.start = request.start;
  plan.scene_end = request.end;
  plan.end = request.start + draft.length;
  plan.realisations = draft.realisations;
  for (const std::size_t k : draft.kept) plan.settings.push_back(draft.input->settings[k]);
  plan.reference = plan.check = draft.input->reference;
  plan.reference.tolerance = plan.check.tolerance = draft.reference_tolerance;
  plan.reference.step = draft.reference_step();
  plan.check.step = 2 * plan.reference.step;
  constexpr double k_samples = 60;
  const double step = coarsest_step(draft.input->settings);
  plan.sample_every = step * std::max(1.0, std::floor(draft.length / k_samples / step));
  plan.omissions = omissions_of(draft);
  plan.runs = runs_of(draft);
  plan.estimate_s = draft.wall_seconds() + k_closing_s;
  plan.setup_s = draft.input->cost.setup_s;
  return plan;
}

}  // namespace

Plan make_plan(const PlanInput& input) {
  const Draft whole = whole_draft(input);
  const bool first_judges = !input.request.reference && !input.request.fixed_length;
  Plan plan = plan_of(first_judges ? cut_against_first(whole) : cut_against_reference(whole));
  plan.whole_s = (whole.wall_seconds() + k_closing_s) / k_share_of_runs;
  return plan;
}

}  // namespace nilas::compare
