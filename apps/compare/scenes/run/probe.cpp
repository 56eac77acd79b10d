#include "apps/compare/scenes/run/probe.h"

#include <algorithm>
#include <numeric>

#include "apps/compare/scenes/run/allotment.h"

namespace nilas::compare {

double Probe::total_ms() const { return std::accumulate(ms.begin(), ms.end(), 0.0); }

double Probe::outside_steps_s(double process_s) const {
  const double written_ms = std::accumulate(output_ms.begin(), output_ms.end(), 0.0);
  return std::max(0.0, process_s - 1e-3 * (total_ms() + written_ms));
}

double Probe::solver_ms_until(double t) const {
  constexpr double k_rounding = 1e-9;
  double sum = 0;
  for (std::size_t k = 0; k < solver_ms.size() && time_s[k] <= t + k_rounding; ++k) sum += solver_ms[k];
  return sum;
}

Probe probe(const SceneRun& run, double start, double limit_s, int beside, const std::function<bool()>& stop) {
  std::vector<SceneRun> runs(static_cast<std::size_t>(beside) + 1, run);
  std::vector<ChildTask> tasks;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (k > 0) {
      runs[k].folder += "-beside-" + std::to_string(k);
      runs[k].log += "-beside-" + std::to_string(k);
    }
    tasks.push_back(task_of(runs[k]));
    tasks.back().limit_s = limit_s;
  }
  ChildResult ended;
  ended.stopped = true;
  run_children(tasks, beside + 1,
               {{}, [&](std::size_t k, const ChildResult& result) { ended = k == 0 ? result : ended; }, stop});
  Probe found;
  found.exit_code = ended.exit_code;
  const RunResult result = read_run(run.folder, run.log, ended);
  if (ended.exit_code == k_exit_not_started) throw FileError(own_program().string() + ": " + result.cause);
  if (!ended.timed_out) found.trouble = result.cause;
  found.window_from = run_end(result, start).window_from_s;
  StepTimes times = read_step_times(run.folder);
  found.time_s = std::move(times.time_s);
  found.ms = std::move(times.ms);
  found.solver_ms = std::move(times.solver_ms);
  found.output_ms = std::move(times.output_ms);
  found.steps = found.ms.size();
  found.length = found.steps > 0 ? found.time_s.back() - start : 0;
  found.setup_s = found.outside_steps_s(std::max(ended.cpu_s, ended.wall_s));
  std::error_code ignored;
  for (const auto& one : runs) std::filesystem::remove_all(one.folder, ignored);
  for (std::size_t k = 1; k < runs.size(); ++k) std::filesystem::remove(runs[k].log, ignored);
  return found;
}

CostModel cost_model(const Probe& first, double start) {
  CostModel cost;
  cost.setup_s = first.setup_s;
  cost.window_from = first.window_from;
  constexpr std::size_t k_stretches = 8;
  const std::size_t stretches = std::min(k_stretches, first.steps);
  std::size_t done = 0;
  double before = start;
  for (std::size_t s = 1; s <= stretches; ++s) {
    const std::size_t end = first.steps * s / stretches;
    double other = 0, solver = 0;
    for (; done < end; ++done) {
      other += 1e-3 * (first.ms[done] - first.solver_ms[done] + first.output_ms[done]);
      solver += 1e-3 * first.solver_ms[done];
    }
    const double t = first.time_s[end - 1];
    cost.rate.push_back({t - start, other / (t - before), solver / (t - before)});
    before = t;
  }
  return cost;
}

std::optional<double> reference_weight(const Probe& first, const Probe& reference, double first_step,
                                       double reference_step, double start) {
  const double together = start + std::min(first.length, reference.length);
  const double own = first.solver_ms_until(together), tight = reference.solver_ms_until(together);
  if (!(own > 0) || !(tight > 0)) return std::nullopt;
  return tight / own * reference_step / first_step;
}

}  // namespace nilas::compare
