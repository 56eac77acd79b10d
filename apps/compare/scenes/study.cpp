#include "apps/compare/scenes/study.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

#include "apps/compare/scenes/judge/merits.h"
#include "apps/compare/scenes/judge/ranking.h"
#include "apps/compare/scenes/report/outlook.h"
#include "apps/compare/scenes/report/plan_text.h"
#include "apps/compare/scenes/report/study_outputs.h"
#include "apps/compare/scenes/run/allotment.h"
#include "apps/compare/scenes/run/given_reference.h"
#include "apps/compare/scenes/run/load_series.h"
#include "apps/compare/scenes/run/probe.h"
#include "apps/compare/scenes/run/study_folder.h"
#include "core/base/error.h"
#include "core/output/run/claim_folder.h"
#include "core/output/text/console.h"

namespace nilas {

namespace {

/// Status of a run that took far longer than was expected of it.
constexpr const char* k_too_slow = "too slow";

/// A comparison while it runs.
class Comparison {
 public:
  Comparison(const StudyOptions& options, const std::function<bool()>& stop)
      : options_(options), stop_(stop), out_(options.json ? std::cerr : std::cout) {}

  int begin() {
    const Scene scene = read_scene(options_.scene, options_.overrides);
    const Grid grid = make_grid(scene, options_.overrides, options_.grid);
    if (options_.reference != "auto") demand_reference_run(options_.reference, scene);
    folder_.emplace(options_.out.empty() ? dated_folder(scene.name + "-compare").string() : options_.out,
                    options_.force);
    try {
      describe(scene);
      for (const auto& refused : grid.refused)
        study_.refused.push_back({label_of(refused.setting, grid.settings.front()), refused.reason});
      plan(scene, grid);
      if (!stop_()) folder_->write(study_);
    } catch (...) {
      folder_->abandon();
      throw;
    }
    if (stop_()) {  // nothing is known yet that could go on
      folder_->abandon();
      say("interrupted before it began");
      return exit_interrupted;
    }
    for (const auto& line : plan_lines(study_)) tell(line);
    return execute();
  }

  int go_on() {
    folder_.emplace(options_.resume);
    study_ = folder_->read();
    const Scene scene = read_scene(study_.scene, study_.overrides);
    if (scene.fingerprint != study_.fingerprint)
      throw InputError("--resume: " + study_.scene.string() + " is no longer the scene that the comparison began with");
    if (options_.jobs > 0) study_.jobs = options_.jobs;
    if (options_.realisations) {
      if (*options_.realisations < study_.plan.realisations)
        throw InputError(fmt::format("--seeds: found {}; the comparison has {} realisations, and they can only grow",
                                     *options_.realisations, study_.plan.realisations));
      extend_realisations(study_.plan, *options_.realisations);
      folder_->write(study_);
    }
    if (options_.budget_s) {
      const bool more = *options_.budget_s == 0 || *options_.budget_s > study_.budget_s;
      study_.budget_s = *options_.budget_s;
      if (more)
        for (const auto& [id, result] : folder_->results(study_.plan))
          if (result.status == k_too_slow) folder_->forget(id);
      folder_->write(study_);
    }
    return execute();
  }

 private:
  void say(const std::string& line) const {
    if (!options_.quiet) out_ << line << "\n" << std::flush;
  }
  /// Sentences, one a line: broken to the width of a terminal, left whole for a file or a pipe.
  void tell(const std::string& sentences) const {
    const bool terminal = ::isatty(options_.json ? STDERR_FILENO : STDOUT_FILENO) != 0;
    std::istringstream text(sentences);
    for (std::string line; std::getline(text, line);)
      say(terminal && !line.starts_with("  ") ? wrapped(line, 0) : line);  // a command stays whole
  }
  static void warn(const std::string& sentence) { std::cerr << "warning: " << sentence << "\n"; }
  double elapsed() const { return steady_seconds() - started_; }
  /// Of the budget; 0: there is none.
  double left() const {
    constexpr double k_least_s = 1e-3;
    return study_.budget_s > 0 ? std::max(k_least_s, study_.budget_s - elapsed()) : 0;
  }

  void describe(const Scene& scene) {
    study_.scene = std::filesystem::absolute(scene.file);
    study_.fingerprint = scene.fingerprint;
    study_.overrides = options_.overrides;
    study_.seed = scene.seed;
    study_.ablation = options_.grid.ablate;
    study_.reference = options_.reference == "auto" ? "auto" : std::filesystem::absolute(options_.reference).string();
    study_.jobs = options_.jobs > 0 ? options_.jobs : usable_cores();
    constexpr double k_budget_s = 1200;
    study_.budget_s = options_.budget_s.value_or(k_budget_s);
    study_.keep_runs = options_.keep_runs;
    if (study_.ablation) study_.absent = absent_simplifications(scene);
  }

  Probe probe_setting(const Scene& scene, const CompareSetting& setting, const char* name, double limit_s, double end,
                      int beside = 0) {
    SceneRun run{study_.scene,
                 folder_->run_folder(name),
                 folder_->run_folder(std::string(name) + ".log"),
                 study_.overrides,
                 end,
                 0};
    const Overrides own = setting.overrides();
    run.overrides.insert(run.overrides.end(), own.begin(), own.end());
    return probe(run, scene.time.start, limit_s, beside, stop_);
  }

  /// A twentieth of the budget for the first setting and as much for the reference at two tolerances, half a minute
  /// each at most.
  void plan(const Scene& scene, const Grid& grid) {
    constexpr double k_share = 0.05, k_most_s = 30, k_least_s = 1, k_patience = 4;
    const double limit = study_.budget_s > 0 ? std::clamp(k_share * study_.budget_s, k_least_s, k_most_s) : k_most_s;
    const bool needs_reference = !study_.ablation && study_.reference == "auto";
    const auto at_most = [&](double wanted) { return study_.budget_s > 0 ? std::min(wanted, left()) : wanted; };
    tell(fmt::format("measuring what a step {} costs, about {:.2g} s each, alone on the machine ...",
                     study_.ablation   ? "without simplifications"
                     : needs_reference ? "of the scene's own setting and of the reference"
                                       : "of the scene's own setting",
                     limit));
    Probe first = probe_setting(scene, grid.settings.front(), "probe", at_most(limit), scene.time.end);
    if (first.steps == 0 && first.trouble.empty())
      first = probe_setting(scene, grid.settings.front(), "probe", at_most(k_patience * limit), scene.time.end);
    study_.probe_steps = first.steps;
    study_.probe_ms = first.total_ms();
    trouble_ = first.trouble;
    if (first.exit_code == exit_bad_input) throw InputError(first.trouble);
    PlanInput input;
    PlanRequest& request = input.request;
    request.stated_budget_s = study_.budget_s;
    request.fixed_length = study_.reference != "auto";
    request.jobs = std::min(study_.jobs, usable_cores());
    request.realisations = options_.realisations.value_or(request.realisations);
    request.fixed_realisations = options_.realisations.has_value();
    request.reference = needs_reference;
    request.start = scene.time.start;
    request.end = scene.time.end;
    CostModel& cost = input.cost = cost_model(first, request.start);
    CompareSetting& reference = input.reference;
    if (needs_reference) {
      reference = reference_setting(scene, study_.overrides, grid, options_.reference_tolerance);
      study_.event_driven = reference.integrator == "reference";
      request.check = !study_.event_driven;
      request.fixed_reference = options_.fixed_reference_tolerance;
      request.fixed_tolerances = options_.grid.names_axes();
      for (const double tolerance : measured_tolerances(options_.reference_tolerance,
                                                        options_.fixed_reference_tolerance, grid.settings.front())) {
        CompareSetting tried = reference;
        tried.tolerance = tolerance;
        const Probe tight =
            probe_setting(scene, tried, "probe-reference", at_most(0.5 * limit + first.setup_s), scene.time.end);
        const CompareSetting& own = grid.settings.front();
        cost.reference.push_back({tolerance, reference_weight(first, tight, own.step, reference.step, request.start)
                                                 .value_or(solver_weight(tried, own))});
        if (!tight.trouble.empty()) warn("the reference (" + full_label(tried) + "): " + tight.trouble);
      }
    }
    if (first.steps == 0)
      warn("what runs take is not known and all are planned: " +
           (first.trouble.empty() ? "no step was done in the time for measuring" : first.trouble));
    request.budget_s = left();
    input.settings = grid.settings;
    input.core = core_of(grid, options_.grid);
    study_.plan = make_plan(input);
    if (first.steps > 0 && study_.budget_s > 0) rehearse(scene, input);
    study_.plan.vary_seed = study_.reference == "auto";
  }

  /// Later steps cost more, and neighbours take from each other: the first setting once more over the whole time that
  /// the plan came to, beside as many as there will be, and the plan anew by what that took.
  void rehearse(const Scene& scene, PlanInput& input) {
    constexpr double k_share = 0.15, k_least_ms = 20;
    const double length = study_.plan.end - study_.plan.start;
    const bool known = input.request.jobs == 1 && input.cost.rate.back().until >= length;
    const double expected = input.cost.setup_s + input.cost.steps_seconds(length);
    if (known || study_.probe_ms < k_least_ms || expected > k_share * left() || stop_()) return;
    tell(fmt::format("and what a whole run takes beside {} other{}, about {:.2g} s ...", input.request.jobs - 1,
                     input.request.jobs == 2 ? "" : "s", expected));
    const Probe whole = probe_setting(scene, input.settings.front(), "probe-whole", 2 * k_share * left(),
                                      study_.plan.end, input.request.jobs - 1);
    if (whole.steps == 0) return;
    const auto reference = input.cost.reference;
    input.cost = cost_model(whole, input.request.start);
    input.cost.reference = reference;
    input.request.budget_s = left();
    study_.plan = make_plan(input);
  }

  std::string run_label(const PlannedRun& run) const {
    if (run.kind == RunKind::reference || run.kind == RunKind::check) return full_label(study_.plan.setting_of(run));
    return label_of(study_.plan.setting_of(run), study_.plan.settings.front());
  }

  SceneRun scene_run(const PlannedRun& run) const {
    SceneRun out{study_.scene,    folder_->run_folder(run.id), folder_->run_folder(run.id + ".log"), study_.overrides,
                 study_.plan.end, study_.plan.sample_every};
    for (const Overrides& more :
         {study_.plan.setting_of(run).overrides(), realisation_overrides(study_.seed, run, study_.plan.vary_seed)})
      out.overrides.insert(out.overrides.end(), more.begin(), more.end());
    return out;
  }

  /// What was ended at its limit counts as done where all runs are told over no more than it reached.
  void judge_end(const PlannedRun& run, RunResult& result) {
    const RunEnd end = run_end(result, study_.plan.start);
    const double before = study_.plan.end;
    switch (allotment_->ended(run, end)) {
      case RunVerdict::as_it_ended:
        break;
      case RunVerdict::far_enough:
        result.status = "done";
        result.cause =
            fmt::format("the budget ended it at {:g} s; all are told up to {:g} s", end.reached_s, study_.plan.end);
        break;
      case RunVerdict::too_slow:
        result.status = k_too_slow;
        result.cause = fmt::format("ended after {:.3g} s, where {:.3g} s were expected", result.wall_s,
                                   allotment_->expected_of(run.id));
        break;
    }
    tell_shorter(before);
  }

  void tell_shorter(double before) {
    if (!(study_.plan.end < before)) return;
    folder_->write(study_);
    tell(shorter_line(study_.plan, before, allotment_->pace().factor()));
  }

  void finish_run(const PlannedRun& run, const ChildResult& ended) {
    const std::filesystem::path folder = folder_->run_folder(run.id);
    RunResult result = read_run(folder, folder_->run_folder(run.id + ".log"), ended);
    if (run.id == "s00-r0" && std::filesystem::exists(folder / "steps.csv")) {
      const StepTimes times = read_step_times(folder);
      for (std::size_t k = 0; k < std::min(study_.probe_steps, times.ms.size()); ++k)
        result.first_steps_ms += times.ms[k];
      if (times.ms.size() < study_.probe_steps) result.first_steps_ms = 0;
    }
    judge_end(run, result);
    if (ended.exit_code == exit_file) {
      if (file_error_.empty()) file_error_ = "run " + run.id + ": " + result.cause;
      result.status = "interrupted";
    }
    if (result.done()) {
      if (!keep_loads(folder)) result.status = "interrupted";  // without its loads it is not done
    }
    session_[run.id] = result;
    if (result.status == "budget") late_.push_back(run.id);
    // what was interrupted or ended by the budget runs again when the comparison goes on
    if (result.done() || result.failed()) keep(run.id, result);
    if (!study_.keep_runs) thin_out(folder);
    ++ended_;
    say(fmt::format("[{}/{}] {:<14} {:<11} {:>8}  {}", ended_, study_.plan.runs.size(), run.id, result.status,
                    duration_text(result.wall_s), run_label(run)));
    if (!result.cause.empty()) say("    " + result.cause);
  }

  /// A disk that is full ends the comparison, but not before it has shown what is done.
  void keep(const std::string& id, const RunResult& result) {
    try {
      folder_->write_result(id, result);
    } catch (const FileError& e) {
      if (file_error_.empty()) file_error_ = e.what();
    }
  }

  bool keep_loads(const std::filesystem::path& run_folder) {
    try {
      keep_load_series(run_folder);
      return true;
    } catch (const FileError& e) {
      if (file_error_.empty()) file_error_ = e.what();
      return false;
    }
  }

  /// Once, after the first realisation: whether the budget has room for the others, by what runs really took.
  void tell_room() {
    if (room_told_ || session_.empty()) return;
    room_told_ = true;
    auto results = folder_->results(study_.plan);
    results.insert(session_.begin(), session_.end());
    const double wanted = allotment_->pace().left_s(study_.plan, results, study_.jobs), room = left();
    if (wanted > room)
      tell(fmt::format(
          "the other realisations take about {} by what the first took, {} are left of the budget: its runs "
          "are made in order as far as it reaches",
          duration_text(wanted), duration_text(room)));
  }

  void run_all(std::map<std::string, RunResult>& results) {
    std::vector<PlannedRun> runs;
    std::vector<ChildTask> tasks;
    for (const auto& run : study_.plan.runs) {
      if (results.count(run.id) > 0) continue;
      runs.push_back(run);
      tasks.push_back(task_of(scene_run(run)));
    }
    ended_ = study_.plan.runs.size() - runs.size();
    allotment_.emplace(study_.plan, study_.budget_s, study_.budget_s, study_.jobs,
                       std::max(1.0, static_cast<double>(study_.jobs) / usable_cores()));
    allotment_->took(results);
    const double pool_started = steady_seconds();
    runs_begun_s_ = elapsed();
    ChildHooks hooks;
    hooks.stop = [this] { return stop_() || !file_error_.empty(); };
    hooks.begin = [&](std::size_t k, ChildTask& task) {
      const double end = study_.plan.end;
      const RunStart start = allotment_->begin(runs[k], elapsed());
      tell_shorter(end);
      if (study_.budget_s > 0 && runs[k].realisation > 0) tell_room();
      if (start.too_slow) {
        RunResult& result = session_[runs[k].id];
        result.status = k_too_slow;
        result.cause = "not begun: another realisation of this setting was ended for its time";
        ++ended_;
      } else if (!start.begins) {
        late_.push_back(runs[k].id);
      }
      task = task_of(scene_run(runs[k]));  // the plan may end earlier by now
      task.limit_s = start.limit_s;
      return start.begins;
    };
    hooks.ended = [&](std::size_t k, const ChildResult& ended) {
      busy_s_ += ended.wall_s;
      finish_run(runs[k], ended);
    };
    run_children(tasks, study_.jobs, hooks);
    pool_s_ = steady_seconds() - pool_started;
    results = folder_->results(study_.plan);
    for (const auto& [id, result] : session_) results[id] = result;
  }

  int execute() {
    std::map<std::string, RunResult> results = folder_->results(study_.plan);
    if (study_.reference != "auto") take_reference(study_, *folder_, results);
    const Judged judged = study_.ablation              ? Judged::by_first_setting
                          : study_.reference != "auto" ? Judged::by_one_run
                                                       : Judged::by_reference;
    write_first_page(results, judged);
    run_all(results);
    if (!late_.empty())
      say(fmt::format("{} runs are not done: the budget of {:g} s was used up", late_.size(), study_.budget_s));
    Findings findings = find(study_.plan, results, folder_->path(), judged);
    const StudyTiming timing = timing_of(results);
    findings.slowdown = timing.slowdown;
    Outlook view =
        outlook(study_, findings, folder_->path(), allotment_->pace().left_s(study_.plan, results, study_.jobs),
                allotment_->pace().realisation_s(study_.plan, study_.jobs));
    if (const auto own = results.find("s00-r0");
        study_.budget_s > 0 && own != results.end() && !anything_told(findings))
      view.least_s =
          needed_budget(study_.plan, run_end(own->second, study_.plan.start), runs_begun_s_, study_.jobs).value_or(0);
    const StudyOutputs outputs{study_, findings, timing, late_, trouble_, ended_by(), view};
    try {
      const std::string picture_trouble = outputs.write(folder_->path());
      if (!picture_trouble.empty()) warn(picture_trouble);
    } catch (const FileError& e) {  // what is done is told all the same
      if (file_error_.empty()) file_error_ = e.what();
    }
    tell(outputs.text());
    if (options_.quiet)
      for (const auto& line : outputs.warnings()) warn(line);
    say(fmt::format("in {}; open {}", duration_text(elapsed()), (folder_->path() / "compare.html").string()));
    if (options_.json)
      std::cout << outputs.json().dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
    if (!file_error_.empty()) throw FileError(file_error_);
    if (stop_()) return exit_interrupted;
    return outputs.compared() ? exit_done : exit_numerics;
  }

  /// Why not all was run; empty: the comparison came to its end.
  std::string ended_by() const { return !file_error_.empty() ? file_error_ : stop_() ? "it was interrupted" : ""; }

  /// There is a page from the start, and whatever ends the program it is never blank.
  void write_first_page(const std::map<std::string, RunResult>& results, Judged judged) const {
    const Findings findings = find(study_.plan, results, folder_->path(), judged);
    const StudyTiming timing{study_.jobs, usable_cores()};
    StudyOutputs(study_, findings, timing, late_, trouble_, "it is still running, or was killed", Outlook{})
        .write_page(folder_->path());
  }

  StudyTiming timing_of(const std::map<std::string, RunResult>& results) const {
    StudyTiming timing;
    timing.jobs = study_.jobs;
    timing.cores = usable_cores();
    timing.elapsed_s = elapsed();
    const auto own = results.find("s00-r0");
    constexpr double k_least_ms = 500;  // below that a time says little
    if (study_.probe_ms > k_least_ms && own != results.end() && own->second.first_steps_ms > 0 && study_.jobs > 1 &&
        study_.jobs <= timing.cores)
      timing.slowdown = own->second.first_steps_ms / study_.probe_ms;
    if (pool_s_ > 0 && busy_s_ > 0) timing.busy = busy_s_ / pool_s_;
    return timing;
  }

  const StudyOptions& options_;
  const std::function<bool()>& stop_;
  std::ostream& out_;
  double started_ = steady_seconds();
  Study study_;
  std::optional<StudyFolder> folder_;
  std::string trouble_;                       ///< of the probe
  std::string file_error_;                    ///< what could not be written
  std::map<std::string, RunResult> session_;  ///< of this session, what is not kept too
  std::optional<Allotment> allotment_;
  bool room_told_ = false;
  std::vector<std::string> late_;  ///< runs that did not begin
  std::size_t ended_ = 0;
  double runs_begun_s_ = 0;         ///< since the start
  double busy_s_ = 0, pool_s_ = 0;  ///< wall time of the runs, and of all of them together
};

}  // namespace

int run_study(const StudyOptions& options, const std::function<bool()>& stop) {
  Comparison comparison(options, stop);
  return options.resume.empty() ? comparison.begin() : comparison.go_on();
}

}  // namespace nilas
