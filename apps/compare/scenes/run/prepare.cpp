#include "apps/compare/scenes/run/prepare.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/compare/scenes/run/probe.h"
#include "core/base/error.h"
#include "core/output/text/console.h"

namespace nilas::compare {

namespace {

/// The input that all measurements share.
struct Workbench {
  const scene::Scene& scene;
  const SceneStore& store;
  const SceneStudy& study;
  const std::function<bool()>& stop;
  double started_s;

  /// The time that is left of the budget [s]; 0: there is no budget.
  double left_s() const {
    constexpr double k_least_s = 1e-3;
    return study.budget_s > 0 ? std::max(k_least_s, study.budget_s - (output::steady_seconds() - started_s)) : 0;
  }
  double at_most(double wanted_s) const { return study.budget_s > 0 ? std::min(wanted_s, left_s()) : wanted_s; }

  Probe probe_setting(const CompareSetting& setting, const std::string& name, double limit_s, double end,
                      int neighbours = 0) const {
    SceneRun run{study.scene, store.run_folder(name), store.run_folder(name + ".log"), study.overrides, end, 0};
    const scene::Overrides own = setting.overrides();
    run.overrides.insert(run.overrides.end(), own.begin(), own.end());
    return probe(run, scene.time.start, limit_s, neighbours, stop);
  }
};

bool needs_reference(const SceneStudy& study) { return !study.ablation && study.reference == "auto"; }

/// The wall time that each measurement may take [s].
double probe_limit(double budget_s) {
  constexpr double k_share = 0.05, k_most_s = 30, k_least_s = 1;
  return budget_s > 0 ? std::clamp(k_share * budget_s, k_least_s, k_most_s) : k_most_s;
}

/// Measures the first setting. If it makes no step in its time, it is tried again with four times as much.
Probe probe_first(const Workbench& bench, const CompareSetting& first, double limit_s) {
  constexpr double k_patience = 4;
  Probe found = bench.probe_setting(first, "probe", bench.at_most(limit_s), bench.scene.time.end);
  if (found.steps == 0 && found.trouble.empty())
    found = bench.probe_setting(first, "probe", bench.at_most(k_patience * limit_s), bench.scene.time.end);
  if (found.exit_code == exit_bad_input) throw InputError(found.trouble);
  return found;
}

PlanRequest request_of(const SceneStudy& study, const scene::Scene& scene, const PlanWishes& wishes) {
  PlanRequest request;
  request.stated_budget_s = study.budget_s;
  request.fixed_length = study.reference != "auto";
  request.jobs = std::min(study.jobs, usable_cores());
  request.realisations = wishes.realisations.value_or(request.realisations);
  request.fixed_realisations = wishes.realisations.has_value();
  request.reference = needs_reference(study);
  request.start = scene.time.start;
  request.end = scene.time.end;
  return request;
}

/// Chooses the reference and measures what its solves cost.
void add_reference(const Workbench& bench, const Grid& grid, const PlanWishes& wishes, const Probe& first,
                   double limit_s, PlanInput& input) {
  const CompareSetting& own = grid.settings.front();
  CompareSetting& reference = input.reference;
  reference = reference_setting(bench.scene, bench.study.overrides, grid, wishes.reference_tolerance);
  input.request.check = reference.integrator != "reference";
  input.request.fixed_reference = wishes.fixed_reference_tolerance;
  input.request.fixed_tolerances = wishes.names_axes;
  for (const double tolerance :
       measured_tolerances(wishes.reference_tolerance, wishes.fixed_reference_tolerance, own)) {
    CompareSetting tried = reference;
    tried.tolerance = tolerance;
    const Probe tight = bench.probe_setting(tried, "probe-reference", bench.at_most(0.5 * limit_s + first.setup_s),
                                            bench.scene.time.end);
    input.cost.reference.push_back(
        {tolerance, reference_weight(first, tight, own.step, reference.step, input.request.start)
                        .value_or(solver_weight(tried, own))});
    // all set up the same scene, but the first process waits for files that are not in memory yet
    if (tight.steps > 0) input.cost.setup_s = std::min(input.cost.setup_s, tight.setup_s);
    if (!tight.trouble.empty()) Narrator::warning("the reference (" + full_label(tried) + "): " + tight.trouble);
  }
}

/// Runs the first setting over the whole time of the plan, next to as many runs as there will be, and makes the plan
/// again with the cost of that: later steps cost more, and runs slow each other down.
void rehearse(const Workbench& bench, const Narrator& narrator, PlanInput& input, SceneStudy& study) {
  constexpr double k_share = 0.15, k_least_ms = 20;
  const double length = study.plan.end - study.plan.start;
  const bool known = input.request.jobs == 1 && input.cost.rate.back().until >= length;
  const double expected = input.cost.setup_s + input.cost.steps_seconds(length);
  if (known || study.probe_ms < k_least_ms || expected > k_share * bench.left_s() || bench.stop()) return;
  narrator.sentences(fmt::format("Measuring a whole run next to {} other{}, which takes about {:.2g} s ...",
                                 input.request.jobs - 1, input.request.jobs == 2 ? "" : "s", expected));
  const Probe whole = bench.probe_setting(input.settings.front(), "probe-whole", 2 * k_share * bench.left_s(),
                                          study.plan.end, input.request.jobs - 1);
  if (whole.steps == 0) return;
  const auto reference = input.cost.reference;
  input.cost = cost_model(whole, input.request.start);
  input.cost.reference = reference;
  input.request.budget_s = bench.left_s();
  study.plan = make_plan(input);
}

}  // namespace

std::string prepare(const scene::Scene& scene, const Grid& grid, const PlanWishes& wishes, const SceneStore& store,
                    const Narrator& narrator, const std::function<bool()>& stop, SceneStudy& study) {
  const Workbench bench{scene, store, study, stop, wishes.started_s};
  const double limit_s = probe_limit(study.budget_s);
  narrator.sentences(fmt::format("Measuring the time of a step {}, alone on the machine, for about {:.2g} s each ...",
                                 study.ablation           ? "without simplifications"
                                 : needs_reference(study) ? "of the scene's own setting and of the reference"
                                                          : "of the scene's own setting",
                                 limit_s));
  const Probe first = probe_first(bench, grid.settings.front(), limit_s);
  study.probe_steps = first.steps;
  study.probe_ms = first.total_ms();
  PlanInput input;
  input.request = request_of(study, scene, wishes);
  input.cost = cost_model(first, input.request.start);
  if (needs_reference(study)) {
    add_reference(bench, grid, wishes, first, limit_s, input);
    study.event_driven = !input.request.check;
  }
  if (first.steps == 0)
    Narrator::warning("The time that runs take is not known, so all of them are planned: " +
                      (first.trouble.empty() ? "no step was done in the time for the measurement" : first.trouble));
  input.request.budget_s = bench.left_s();
  input.settings = grid.settings;
  input.core = wishes.core;
  study.plan = make_plan(input);
  if (first.steps > 0 && study.budget_s > 0) rehearse(bench, narrator, input, study);
  study.plan.vary_seed = study.reference == "auto";
  return first.trouble;
}

}  // namespace nilas::compare
