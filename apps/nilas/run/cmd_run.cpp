#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/nilas/commands/commands.h"
#include "apps/nilas/commands/program_identity.h"
#include "apps/nilas/run/open_water.h"
#include "apps/nilas/run/resume.h"
#include "apps/nilas/run/run_options.h"
#include "apps/nilas/run/twin_runs.h"
#include "apps/view/live_server.h"
#include "core/base/error.h"
#include "core/base/machine.h"
#include "core/base/stop_request.h"
#include "core/bodies/module.h"
#include "core/output/run/claim_folder.h"
#include "core/output/run/closing_account.h"
#include "core/output/run/program_versions.h"
#include "core/output/run/run_folder.h"
#include "core/output/run/simulated_totals.h"
#include "core/output/text/console.h"
#include "core/output/text/phase_progress.h"
#include "core/sim/simulation.h"

namespace nilas::commands {

namespace {

/// The folder that the scene names, else a dated one.
std::filesystem::path default_folder(const scene::Scene& scene) {
  return scene.output.folder.empty() ? output::dated_folder(scene.name) : std::filesystem::path(scene.output.folder);
}

/// The open-water run of --open-water-run, if any. Throws, as OpenWater does, before a file of an earlier run is
/// replaced.
std::optional<OpenWater> stored_open_water(const RunOptions& options, const scene::Scene& scene) {
  if (options.open_water) OpenWater::demand_towed(scene);
  if (options.open_water_run.empty()) return std::nullopt;
  return OpenWater::stored(options.open_water_run);
}

/// How a run ended.
struct Ending {
  std::string status = "done";
  int exit_code = exit_done;
  std::string message = {};
  std::string interrupted = {};  ///< for an interrupted run: when it ended and how to continue it
  std::string early = {};        ///< why a run that is done ended before its end time; empty: it did not
};

/// A path as a shell reads it: in quotes unless all of its characters are plain.
std::string for_shell(const std::string& path) {
  constexpr std::string_view k_plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-+,:@%";
  if (path.find_first_not_of(k_plain) == std::string::npos) return path;
  std::string quoted = "'";
  for (const char c : path) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

class Run {
 public:
  explicit Run(const RunOptions& options)
      : options_(options),
        scene_(read_flagged_scene(options.scene)),
        open_water_(stored_open_water(options, scene_)),
        folder_(options.out.empty() ? default_folder(scene_) : std::filesystem::path(options.out), options.force,
                scene_.inputs),
        logger_(make_logger(console_level(), folder_.log_file().string())),
        warnings_(logger_) {}

  /// Continues a stopped run in its folder.
  Run(const RunOptions& options, StoppedRun stopped)
      : options_(options),
        scene_(std::move(stopped.scene)),
        open_water_(stored_open_water(options, scene_)),
        folder_(stopped.folder, std::move(stopped.lock).value()),
        goes_on_(true),
        checkpoint_(std::move(stopped.checkpoint)),
        origin_(std::move(stopped.origin)),
        logger_(make_logger(console_level(), folder_.log_file().string(), LogFile::append)),
        warnings_(logger_) {}

  int execute() {
    if (options_.view) open_view();
    const auto built = build();
    sim::Simulation& simulation = *built;
    if (options_.open_water) open_water_ = tow_without_ice();
    if (options_.twins > 0) build_twins(simulation);
    say_what_was_built(simulation.info());
    output::Console console(options_.json ? std::cerr : std::cout, run_style(), scene_.time.start, scene_.time.end);
    console.make_room_for(*logger_);
    if (checkpoint_)
      go_on(simulation, console);
    else
      begin(simulation);
    if (live_) live_->written(folder_.replay_bytes());
    const Ending ending = advance(simulation, console);
    const double wall = wall_seconds(), processor = run_processor_seconds();
    if (!ending.early.empty())
      logger_->warn("the run ends at {:g} s instead of {:g} s: {}", simulation.time(), scene_.time.end, ending.early);
    if (!ending.message.empty())
      logger_->log(ending.exit_code == exit_interrupted ? spdlog::level::warn : spdlog::level::err, "{}",
                   ending.message);
    warnings_.summarise();
    output::SummaryInput input = summary_input(ending, wall, processor);
    output::add_totals(simulation, input);
    if (twins_) input.twins = twins_->statistics(folder_.statistics().window());
    const auto twins = input.twins;
    input.ice_load = folder_.statistics().ice_load(twins ? &*twins : nullptr);
    if (input.ice_load && open_water_)
      if (const std::string fault = open_water_->deduct_from(*input.ice_load, simulation.info().vessel_mass);
          !fault.empty())
        logger_->warn("--open-water: {}", fault);
    const auto ice_load = input.ice_load;
    const auto& columns = simulation.info().module_columns;
    const bool crushes = std::find(columns.begin(), columns.end(), "crushed_overlap_max_m") != columns.end();
    std::optional<output::BrokenIce> ice;
    if (scene_.fracture && simulation.info().floes > 0)
      ice = {simulation.info().floes, floes_of(simulation.bodies()), input.crushed_mass,
             input.brash_mass,        input.extruded_mass,           crushes};
    const auto summary = folder_.finish(std::move(input), simulation.bodies());
    if (live_) live_->written(folder_.replay_bytes());
    live_.reset();
    if (const auto count = simulation.info().warnings.size(); count > 0)
      logger_->warn("{} about the scene {} printed at the start; see nilas.log", count == 1 ? "a warning" : "warnings",
                    count == 1 ? "was" : "were");
    if (options_.json)
      std::cout << summary.dump(2) << "\n";
    else
      console.close(output::closing_account(folder_.statistics(),
                                            {.wall_s = wall,
                                             .processor_s = processor,
                                             .resuming_s = resuming_,
                                             .figures = simulation.figures(),
                                             .interrupted = ending.interrupted},
                                            folder_.path(), ice, twins ? &*twins : nullptr, ice_load));
    return ending.exit_code;
  }

 private:
  static long floes_of(const bodies::Bodies& bodies) {
    return std::count(bodies.kind.begin(), bodies.kind.end(), bodies::BodyKind::floe);
  }
  /// The console's style while the run advances. With --json, standard output is for the results alone.
  output::ConsoleStyle run_style() const {
    return options_.json ? output::phase_style(options_.quiet, true) : output::console_style(options_.quiet);
  }
  output::ConsoleStyle before_run_style() const { return output::phase_style(options_.quiet, options_.json); }
  std::string console_level() const { return options_.quiet ? "warn" : options_.log_level; }
  /// Wall time of all sessions of the run [s].
  double wall_seconds() const { return wall_before_ + output::steady_seconds() - started_; }
  /// Processor time of all sessions of the run, on all threads [s].
  double run_processor_seconds() const { return processor_before_ + processor_seconds() - processor_started_; }

  std::unique_ptr<sim::Simulation> build() {
    output::PhaseProgress progress(std::cerr, before_run_style(),
                                   scene_.ice ? "laying out the ice" : "building the scene");
    progress.make_room_for(*logger_);
    try {
      return std::make_unique<sim::Simulation>(scene_, options_.threads, warnings_);
    } catch (...) {
      if (!goes_on_) folder_.abandon();
      throw;
    }
  }

  /// Opens the live view before anything takes long, so that a port in use is told at once.
  void open_view() {
    try {
      if (scene_.output.trajectory_every <= 0)
        throw InputError(
            "--view shows the stored frames, and this run stores none: set <output trajectory_every> above 0");
      live_ = std::make_unique<view::LiveServer>(options_.view_address, scene_.name, folder_.replay_file());
    } catch (...) {
      if (!goes_on_) folder_.abandon();
      throw;
    }
    std::cerr << "live view: " << live_->address() << "\n";
  }

  OpenWater tow_without_ice() {
    const output::PhaseProgress progress(std::cerr, before_run_style(), "towing the vessel without ice first");
    try {
      return OpenWater::towed(scene_, options_.threads);
    } catch (...) {
      if (!goes_on_) folder_.abandon();
      throw;
    }
  }

  void build_twins(const sim::Simulation& simulation) {
    const output::PhaseProgress progress(std::cerr, before_run_style(), "building the perturbed runs");
    try {
      twins_.emplace(scene_, simulation, options_.twins, options_.threads);
    } catch (...) {
      folder_.abandon();
      throw;
    }
  }

  void begin(const sim::Simulation& simulation) {
    if (goes_on_) {
      logger_->info("the run stopped before its first checkpoint, so it begins again");
      output::clear_after(folder_.path());
    }
    folder_.open(scene_, simulation.info(), warnings_);
    folder_.start(scene_.time.start, simulation.initial_ledger(), simulation.bodies(),
                  [&] { return simulation.drawn(); });
  }

  void go_on(sim::Simulation& simulation, output::Console& console) {
    const StateReader in(*checkpoint_);
    simulation.restore(in.group("simulation"));
    folder_.resume(scene_, simulation.info(), warnings_, in.group("outputs"));
    warnings_.restore(in.group("warnings"));
    in.get("wall_s", wall_before_);
    in.get("processor_s", processor_before_);
    in.get("resuming_s", resuming_);
    resuming_ += output::steady_seconds() - started_;
    steps_saved_ = simulation.steps();
    logger_->info("the run continues from {:g} s", simulation.time());
    console.go_on_from(simulation.time());
    checkpoint_.reset();
  }

  void write_checkpoint(const sim::Simulation& simulation) {
    const double begun = output::steady_seconds();
    State state;
    StateWriter out(state);
    simulation.save(out.group("simulation"));
    warnings_.save(out.group("warnings"));
    out.add("wall_s", wall_seconds());
    out.add("processor_s", run_processor_seconds());
    out.add("resuming_s", resuming_);
    if (!origin_) origin_ = checkpoint_origin(scene_.fingerprint);
    folder_.write_checkpoint(*origin_, std::move(state));
    steps_saved_ = simulation.steps();
    logger_->debug("a checkpoint at {:g} s was written in {:.1f} ms", simulation.time(),
                   1e3 * (output::steady_seconds() - begun));
  }

  Ending advance(sim::Simulation& simulation, output::Console& console) {
    const long steps = scene::number_of_steps(scene_.time), done = simulation.steps();
    const double every = scene_.output.checkpoint_every;
    Ending ending;
    const long checkpoint_steps = every > 0 ? std::max(1L, std::lround(every / scene_.time.step)) : 0;
    listen_for_stop();
    try {
      for (long k = done; k < steps && !stop_requested(); ++k) {
        ending.early = simulation.end_of_course();
        if (!ending.early.empty()) break;
        if (live_) live_->control().hold(simulation.time(), stop_requested);
        if (stop_requested()) break;
        const sim::StepRecord record = twins_ ? twins_->step(simulation) : simulation.step();
        folder_.store(record, simulation.last_problem());
        folder_.record(
            record, simulation.solved_substeps(), simulation.bodies(),
            [&](std::int64_t floe) { return simulation.of_body(bodies::k_damage, floe); },
            [&] { return simulation.drawn(); });
        if (live_) live_->written(folder_.replay_bytes());
        console.progress(simulation.time(), k + 1 - done);
        if (checkpoint_steps > 0 && (k + 1) % checkpoint_steps == 0) write_checkpoint(simulation);
      }
    } catch (const Interruption&) {
      return interrupted_at(simulation.time());  // within a step, which no checkpoint may hold
    } catch (const SimulationError& e) {
      folder_.store_last(simulation.last_problem());
      return {"failed", exit_numerics, e.what()};
    }
    const bool is_due = checkpoint_steps > 0 || (stop_requested() && can_be_saved());
    if (is_due && steps_saved_ != simulation.steps()) write_last_checkpoint(simulation, checkpoint_steps > 0);
    if (stop_requested()) return interrupted_at(simulation.time());
    return ending;
  }

  /// One that was not asked for must not cost the run its outputs where it cannot be written.
  void write_last_checkpoint(const sim::Simulation& simulation, bool is_asked) {
    try {
      write_checkpoint(simulation);
    } catch (const FileError& e) {
      if (is_asked) throw;
      logger_->warn("no checkpoint could be written: {}", e.what());
    }
  }

  /// What the reference integrator remembers cannot be saved.
  bool can_be_saved() const { return scene_.contact.integrator != Integrator::reference; }

  Ending interrupted_at(double time) const {
    const std::string when = fmt::format("at {:g} s of {:g} s", time, scene_.time.end), how = how_to_continue();
    return {.status = "interrupted",
            .exit_code = exit_interrupted,
            .message = "The run was interrupted " + when + "; its outputs are complete up to there. " + how,
            .interrupted = when + ". " + how};
  }

  /// A sentence on how an interrupted run is continued.
  std::string how_to_continue() const {
    if (steps_saved_ >= 0) {
      return "`nilas run --resume " + for_shell(folder_.path().string()) + "` continues the run" +
             (twins_ ? ", without its perturbed runs." : ".");
    }
    if (!can_be_saved()) return "The run cannot be resumed: the reference integrator has no checkpoints.";
    return "The run cannot be resumed: it has no checkpoint; --checkpoint-every SECONDS writes some on the way.";
  }

  void say_what_was_built(const sim::RunInfo& info) {
    logger_->debug("scene {}", scene_.file.string());
    constexpr std::size_t k_indent = 2;
    const bool terminal = isatty(STDERR_FILENO) == 1;
    const auto fitted = [&](const std::string& text) { return terminal ? output::wrapped(text, k_indent) : text; };
    for (const auto& text : sim::warning_texts(info)) logger_->warn("{}", fitted(text));
    for (const auto& note : scene_.notes) logger_->info("{}", fitted(note));
    for (const auto& note : scene_.derived) logger_->info("{}", fitted(note));
    for (const auto& [name, why] : info.modules) logger_->debug("built: {} ({})", name, why);
    std::string absent;
    for (const auto& name : info.not_built) absent += " " + name;
    logger_->debug("not asked for, so not built:{}", absent);
  }

  output::SummaryInput summary_input(const Ending& ending, double wall, double processor) const {
    output::SummaryInput input;
    input.status = ending.status;
    input.exit_code = ending.exit_code;
    input.ended_early = ending.early;
    input.wall_s = wall;
    input.processor_s = processor;
    input.resuming_s = resuming_;
    input.seed = scene_.seed;
    input.threads = options_.threads;
    input.machine = system_text();
    input.versions = output::program_versions();
    return input;
  }

  const RunOptions& options_;
  scene::Scene scene_;
  std::optional<OpenWater> open_water_;  ///< if it is asked for
  output::RunFolder folder_;
  bool goes_on_ = false;                         ///< the run continues one that the folder holds
  std::optional<State> checkpoint_;              ///< the state from which the run continues
  std::optional<sim::CheckpointOrigin> origin_;  ///< the origin of the checkpoints, once there are any
  std::unique_ptr<view::LiveServer> live_;       ///< the live view, if it is asked for
  std::optional<TwinRuns> twins_;                ///< the perturbed runs, if they are asked for
  long steps_saved_ = -1;                        ///< steps in the newest checkpoint; -1: there is none
  double started_ = output::steady_seconds(), wall_before_ = 0;
  double processor_started_ = processor_seconds(), processor_before_ = 0;
  double resuming_ = 0;  ///< wall time in which sessions after the first built the scene again [s]
  std::shared_ptr<spdlog::logger> logger_;
  WarningCounts warnings_;
};

/// States whether a run that is done can be continued. `summary`: the text of its summary.json.
std::string how_to_go_on(const std::string& summary) {
  const std::string early = nlohmann::json::parse(summary).value("ended_early", "");
  return early.empty() ? "--until with a later time continues it" : "it cannot be continued: " + early;
}

int resume_run(const RunOptions& options) {
  StoppedRun stopped = find_stopped_run(options.resume, options.scene);
  if (stopped.summary.empty()) return Run(options, std::move(stopped)).execute();
  if (options.json)
    std::cout << stopped.summary;
  else if (!options.quiet)
    std::cout << options.resume << ": the run is done already; " << how_to_go_on(stopped.summary) << "\n";
  return exit_done;
}

}  // namespace

void add_run(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("run", "Simulates a scene to its end and writes a run folder.");
  auto options = std::make_shared<RunOptions>();
  const CLI::Option* scene = add_run_options(*command, *options);
  command->callback([&action, options, command, scene] {
    const bool resumes = command->get_option("--resume")->count() > 0;
    if (!resumes && scene->count() == 0) throw CLI::RequiredError("scene");
    action = [options, command, resumes] {
      if (!resumes) return Run(*options).execute();
      demand_resumable(*command);
      return resume_run(*options);
    };
  });
}

}  // namespace nilas::commands
