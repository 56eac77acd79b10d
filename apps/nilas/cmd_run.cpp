#include <sys/utsname.h>

#include <cmath>
#include <csignal>
#include <ctime>
#include <iostream>
#include <memory>

#include "apps/nilas/commands.h"
#include "apps/nilas/scene_flags.h"
#include "core/base/error.h"
#include "core/output/closing_account.h"
#include "core/output/console.h"
#include "core/output/run_folder.h"
#include "core/sim/simulation.h"

namespace nilas {

namespace {

/// Set by SIGINT and SIGTERM; the only thing a signal handler may touch.
volatile std::sig_atomic_t stop_requested = 0;
void request_stop(int) { stop_requested = 1; }

struct RunOptions {
  SceneFlags scene;
  std::string out, log_level = "info";
  int threads = 1;
  bool force = false, json = false, quiet = false;
};

std::string default_folder(const Scene& scene) {
  if (!scene.output.folder.empty()) return scene.output.folder;
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[32];
  std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", &local);
  return "runs/" + scene.name + "-" + text;
}

std::string machine() {
  utsname name{};
  uname(&name);
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

std::map<std::string, std::string> versions() {
  return {{"nilas", NILAS_VERSION},       {"simbody", NILAS_SIMBODY_VERSION}, {"fcl", NILAS_FCL_VERSION},
          {"eigen", NILAS_EIGEN_VERSION}, {"cgal", NILAS_CGAL_VERSION},       {"tinyxml2", NILAS_TINYXML2_VERSION},
          {"compiler", NILAS_COMPILER}};
}

/// How a run ended.
struct Ending {
  std::string status = "done";
  int exit_code = exit_done;
  std::string message;
};

class Run {
 public:
  explicit Run(const RunOptions& options)
      : options_(options),
        scene_(read_flagged_scene(options.scene)),
        folder_(options.out.empty() ? default_folder(scene_) : options.out, options.force),
        logger_(make_logger(options.quiet ? "warn" : options.log_level, folder_.log_file().string())),
        warnings_(logger_) {}

  int execute() {
    const double started = steady_seconds();
    const auto built = build();
    Simulation& simulation = *built;
    say_what_was_built(simulation.info());
    folder_.open(scene_, simulation.info(), warnings_);
    folder_.start(scene_.time.start, simulation.initial_ledger(), simulation.bodies());
    Console console(std::cout, console_style(options_.quiet || options_.json), scene_.time.start, scene_.time.end);
    console.make_room_for(*logger_);
    const Ending ending = advance(simulation, console);
    const double wall = steady_seconds() - started;
    if (!ending.message.empty()) logger_->error("{}", ending.message);
    warnings_.summarise();
    const auto summary = folder_.finish(summary_input(ending, wall), simulation.bodies());
    console.close(closing_account(folder_.statistics(), wall, folder_.path()));
    if (options_.json) std::cout << summary.dump(2) << "\n";
    return ending.exit_code;
  }

 private:
  std::unique_ptr<Simulation> build() {
    try {
      return std::make_unique<Simulation>(scene_, options_.threads, warnings_);
    } catch (...) {
      folder_.abandon();
      throw;
    }
  }

  Ending advance(Simulation& simulation, Console& console) {
    const long steps = number_of_steps(scene_.time);
    stop_requested = 0;
    std::signal(SIGINT, request_stop);
    std::signal(SIGTERM, request_stop);
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is then an error of the write, with a message
    try {
      for (long k = 0; k < steps && !stop_requested; ++k) {
        const StepRecord record = simulation.step();
        folder_.store(record, simulation.last_problem());
        folder_.record(record, simulation.bodies());
        console.progress(simulation.time(), k + 1);
      }
    } catch (const SimulationError& e) {
      folder_.store_last(simulation.last_problem());
      return {"failed", exit_numerics, e.what()};
    }
    if (stop_requested)
      return {"interrupted", exit_interrupted, "interrupted at " + std::to_string(simulation.time()) + " s"};
    return {};
  }

  void say_what_was_built(const RunInfo& info) {
    logger_->debug("scene {}", scene_.file.string());
    for (const auto& note : scene_.notes) logger_->info("{}", note);
    for (const auto& [name, why] : info.modules) logger_->debug("built: {} ({})", name, why);
    std::string absent;
    for (const auto& name : info.not_built) absent += " " + name;
    logger_->debug("not asked for, so not built:{}", absent);
  }

  SummaryInput summary_input(const Ending& ending, double wall) const {
    SummaryInput input;
    input.status = ending.status;
    input.exit_code = ending.exit_code;
    input.wall_s = wall;
    input.seed = scene_.seed;
    input.threads = options_.threads;
    input.machine = machine();
    input.versions = versions();
    return input;
  }

  const RunOptions& options_;
  Scene scene_;
  RunFolder folder_;
  std::shared_ptr<spdlog::logger> logger_;
  WarningCounts warnings_;
};

}  // namespace

void add_run(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("run", "simulates a scene to its end and writes a run folder");
  auto options = std::make_shared<RunOptions>();
  add_scene_flags(*command, options->scene);
  command->add_option("--out", options->out, "run folder (default: the scene's, else runs/<scene>-<time>)");
  command->add_option("--threads", options->threads, "threads; the results do not depend on it")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_flag("--force", options->force, "write into a folder that is not empty");
  command->add_flag("--json", options->json, "summary as JSON on stdout and nothing else there");
  command->add_flag("--quiet", options->quiet, "no progress, only warnings and errors");
  command->add_option("--log-level", options->log_level, "of the console")
      ->check(CLI::IsMember({"debug", "info", "warn", "error", "off"}))
      ->capture_default_str();
  command->callback([&action, options] { action = [options] { return Run(*options).execute(); }; });
}

}  // namespace nilas
