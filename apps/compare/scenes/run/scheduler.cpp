#include "apps/compare/scenes/run/scheduler.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/compare/scenes/run/load_series.h"
#include "apps/compare/scenes/run/scene_run.h"
#include "core/base/error.h"
#include "core/output/text/console.h"

namespace nilas::compare {

namespace {

/// The status of a run that took far longer than expected.
constexpr const char* k_too_slow = "too slow";

class Scheduler {
 public:
  Scheduler(SceneStudy& study, const SceneStore& store, std::map<std::string, RunResult> done, double started_s,
            const Narrator& narrator, const RunWords& words, const std::function<bool()>& stop)
      : study_(study),
        store_(store),
        started_s_(started_s),
        narrator_(narrator),
        words_(words),
        stop_(stop),
        allotment_(study.plan, study.budget_s, study.budget_s, study.jobs,
                   std::max(1.0, static_cast<double>(study.jobs) / usable_cores())) {
    allotment_.took(done);
    for (const auto& run : study.plan.runs)
      if (done.count(run.id) == 0) runs_.push_back(run);
    ended_ = study.plan.runs.size() - runs_.size();
  }

  SessionEnd run() {
    std::vector<ChildTask> tasks;
    for (const auto& planned : runs_) tasks.push_back(task_of(scene_run(planned)));
    const double pool_started = output::steady_seconds();
    session_.runs_begun_s = elapsed();
    ChildHooks hooks;
    hooks.stop = [this] { return stop_() || !session_.file_error.empty(); };
    hooks.begin = [this](std::size_t k, ChildTask& task) { return begin(runs_[k], task); };
    hooks.ended = [this](std::size_t k, const ChildResult& ended) { end(runs_[k], ended); };
    run_children(tasks, study_.jobs, hooks);
    session_.pool_s = output::steady_seconds() - pool_started;
    session_.results = all_results();
    session_.left_s = left_s(session_.results);
    session_.realisation_s = allotment_.pace().realisation_s(study_.plan, study_.jobs, allotment_.share());
    return std::move(session_);
  }

 private:
  double elapsed() const { return output::steady_seconds() - started_s_; }
  double left_s(const std::map<std::string, RunResult>& results) const {
    return allotment_.pace().left_s(study_.plan, results, study_.jobs, allotment_.share());
  }

  /// The results on disk and those of this session that are not stored.
  std::map<std::string, RunResult> all_results() const {
    auto results = store_.results(study_.plan);
    for (const auto& [id, result] : made_) results[id] = result;
    return results;
  }

  SceneRun scene_run(const PlannedRun& run) const {
    SceneRun out{study_.scene,     store_.run_folder(run.id), store_.run_folder(run.id + ".log"),
                 study_.overrides, study_.plan.end,           study_.plan.sample_every};
    for (const scene::Overrides& more :
         {study_.plan.setting_of(run).overrides(), realisation_overrides(study_.seed, run, study_.plan.vary_seed)})
      out.overrides.insert(out.overrides.end(), more.begin(), more.end());
    return out;
  }

  bool begin(const PlannedRun& run, ChildTask& task) {
    const double before = study_.plan.end;
    const RunStart start = allotment_.begin(run, elapsed());
    note_shorter_plan(before);
    if (study_.budget_s > 0 && run.realisation > 0) note_room();
    if (start.too_slow) {
      RunResult& result = made_[run.id];
      result.status = k_too_slow;
      result.cause = "not begun, because another realisation of this setting was too slow";
      ++ended_;
    } else if (!start.begins) {
      session_.late.push_back(run.id);
      if (start.too_long()) note_too_long(run, start);
    }
    task = task_of(scene_run(run));  // the plan may end earlier by now
    task.limit_s = start.limit_s;
    return start.begins;
  }

  void note_too_long(const PlannedRun& run, const RunStart& start) {
    session_.too_long.push_back(run.id);
    made_[run.id].cause = fmt::format("not begun, because {:.3g} s were expected and {:.3g} s of the budget were left",
                                      start.expected_s, start.left_s);
  }

  void end(const PlannedRun& run, const ChildResult& ended) {
    session_.busy_s += ended.wall_s;
    const std::filesystem::path folder = store_.run_folder(run.id);
    RunResult result = read_run(folder, store_.run_folder(run.id + ".log"), ended);
    if (run.id == "s00-r0") result.first_steps_ms = first_steps_ms(folder);
    judge_end(run, result);
    if (ended.exit_code == exit_file || ended.exit_code == k_exit_not_started) {
      note_file_error("run " + run.id + ": " + result.cause);
      result.status = "interrupted";
    }
    const auto keep = [&] {
      keep_load_series(folder);
      put_on_disk(folder);
    };
    if (result.done() && !kept(keep)) result.status = "interrupted";
    made_[run.id] = result;
    if (result.status == "budget") session_.late.push_back(run.id);
    // runs that were interrupted or that the budget ended are made again when the comparison is resumed
    if (result.done() || result.failed()) kept([&] { store_.write_result(run.id, result); });
    if (!study_.keep_runs) thin_out(folder);
    ++ended_;
    narrator_.line(fmt::format("[{}/{}] {:<14} {:<11} {:>8}  {}", ended_, study_.plan.runs.size(), run.id,
                               result.status, output::duration_text(result.wall_s), words_.label(run)));
    if (!result.cause.empty()) narrator_.line("    " + result.cause);
  }

  /// The time of the steps that the probe made too [ms]; 0 if the run made fewer.
  double first_steps_ms(const std::filesystem::path& folder) const {
    const StepTimes times = read_step_times(folder);
    if (times.ms.size() < study_.probe_steps) return 0;
    double sum = 0;
    for (std::size_t k = 0; k < study_.probe_steps; ++k) sum += times.ms[k];
    return sum;
  }

  /// Sets the status of a run that was ended at its limit. It is done if all runs are compared over no more than it
  /// reached.
  void judge_end(const PlannedRun& run, RunResult& result) {
    const RunEnd end = run_end(result, study_.plan.start);
    const double before = study_.plan.end;
    switch (allotment_.ended(run, end)) {
      case RunVerdict::as_it_ended:
        break;
      case RunVerdict::far_enough:
        result.status = "done";
        result.cause = fmt::format("the budget ended it at {:g} s; all runs are compared up to {:g} s", end.reached_s,
                                   study_.plan.end);
        break;
      case RunVerdict::too_slow:
        result.status = k_too_slow;
        result.cause = fmt::format("ended after {:.3g} s, although {:.3g} s were expected", result.wall_s,
                                   allotment_.expected_of(run.id));
        break;
    }
    note_shorter_plan(before);
  }

  void note_shorter_plan(double before) {
    if (!(study_.plan.end < before)) return;
    store_.write(study_);
    narrator_.sentences(words_.shorter(study_.plan, before, allotment_.pace().factor()));
  }

  /// States once, after the first realisation, if the budget has no room for the others, from the times of the runs.
  void note_room() {
    if (room_noted_ || ended_ == 0) return;
    room_noted_ = true;
    constexpr double k_least_s = 1e-3;
    const double wanted = left_s(all_results()), room = std::max(k_least_s, study_.budget_s - elapsed());
    if (wanted > room)
      narrator_.sentences(
          fmt::format("The other realisations need about {}, but {} of the budget are left. Their runs are made in "
                      "order until it is used up.",
                      output::duration_text(wanted), output::duration_text(room)));
  }

  void note_file_error(const std::string& error) {
    if (session_.file_error.empty()) session_.file_error = error;
  }
  /// Writes, and returns whether that worked. A full disk ends the comparison, but only after the report on what is
  /// done.
  bool kept(const std::function<void()>& write) {
    try {
      write();
      return true;
    } catch (const FileError& e) {
      note_file_error(e.what());
      return false;
    }
  }

  SceneStudy& study_;
  const SceneStore& store_;
  double started_s_;
  const Narrator& narrator_;
  const RunWords& words_;
  const std::function<bool()>& stop_;
  Allotment allotment_;
  std::vector<PlannedRun> runs_;
  std::map<std::string, RunResult> made_;  ///< results of this session
  SessionEnd session_;
  bool room_noted_ = false;
  std::size_t ended_ = 0;
};

}  // namespace

SessionEnd make_runs(SceneStudy& study, const SceneStore& store, std::map<std::string, RunResult> done,
                     double started_s, const Narrator& narrator, const RunWords& words,
                     const std::function<bool()>& stop) {
  return Scheduler(study, store, std::move(done), started_s, narrator, words, stop).run();
}

void forget_slow_runs(const SceneStudy& study, const SceneStore& store) {
  for (const auto& [id, result] : store.results(study.plan))
    if (result.status == k_too_slow) store.forget(id);
}

}  // namespace nilas::compare
