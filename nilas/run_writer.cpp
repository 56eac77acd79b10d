#include <chrono>
#include <utility>

#include "core/base/machine.h"
#include "core/output/run/program_versions.h"
#include "core/output/run/run_folder.h"
#include "core/output/run/simulated_totals.h"
#include "core/scene/time_steps.h"
#include "nilas/scene_content.h"
#include "nilas/simulation_content.h"
#include "nilas/translate.h"

namespace nilas {

using WallClock = std::chrono::steady_clock;

struct RunWriter::Content {
  Content(Simulation::Content& of, const std::filesystem::path& path, bool force)
      : run(of), scene(of.scene.content().scene), folder(path, force, scene.inputs) {
    try {
      folder.open(scene, run.simulation->info(), run.warning_counts);
    } catch (...) {
      folder.abandon();
      throw;
    }
    folder.start(scene.time.start, run.simulation->initial_ledger(), run.simulation->bodies(),
                 [this] { return run.simulation->drawn(); });
  }

  Simulation::Content& run;
  const scene::Scene& scene;
  output::RunFolder folder;
  WallClock::time_point begin = WallClock::now();
  double processor_before = processor_seconds();
  long recorded = 0;
  bool is_finished = false;
};

RunWriter::RunWriter(const Simulation& simulation, const std::filesystem::path& folder, bool force) {
  const Simulation::Content::Use use(*simulation.content_);
  if (simulation.content_->simulation->steps() > 0)
    throw Error(ErrorKind::input, "a run folder holds a whole run: make it before the first step");
  content_ = library::translated([&] { return std::make_unique<Content>(*simulation.content_, folder, force); });
}
RunWriter::RunWriter(RunWriter&&) noexcept = default;
RunWriter::~RunWriter() = default;

void RunWriter::record() {
  Content& out = *content_;
  const Simulation::Content::Use use(out.run);
  library::translated([&] {
    const sim::Simulation& simulation = *out.run.simulation;
    if (out.is_finished) throw Error(ErrorKind::input, "the run folder is finished");
    if (simulation.steps() != out.recorded + 1)
      throw Error(ErrorKind::input, "record() must be called once after each step: the folder has " +
                                        std::to_string(out.recorded) + " steps, and the simulation " +
                                        std::to_string(simulation.steps()));
    ++out.recorded;
    out.folder.store(out.run.last, simulation.last_problem());
    out.folder.record(
        out.run.last, simulation.solved_substeps(), simulation.bodies(),
        [&](std::int64_t floe) { return simulation.of_body(bodies::k_damage, floe); },
        [&] { return simulation.drawn(); });
  });
}

/// Why a run that is done ends before the scene does; empty where it does not.
static std::string early_end(const sim::Simulation& simulation, const scene::Scene& scene) {
  if (simulation.steps() >= scene::number_of_steps(scene.time)) return "";
  const std::string course = simulation.end_of_course();
  return course.empty() ? "the program that ran it asked for no more steps" : course;
}

void RunWriter::finish(const std::string& status, const std::string& message) {
  Content& out = *content_;
  const Simulation::Content::Use use(out.run);
  if (status != "done" && status != "interrupted" && status != "failed")
    throw Error(ErrorKind::input, "a run does not end as '" + status + "'; allowed: done, interrupted, failed");
  library::translated([&] {
    if (std::exchange(out.is_finished, true)) throw Error(ErrorKind::input, "the run folder is finished already");
    const auto log = make_logger("off", out.folder.log_file().string());
    for (const auto& [kind, count] : out.run.warning_counts.counts()) log->warn("{}: {} times in all", kind, count);
    if (!message.empty()) log->error("{}", message);
    if (status == "failed") out.folder.store_last(out.run.simulation->last_problem());
    output::SummaryInput input;
    input.status = status;
    input.exit_code = status == "done" ? exit_done : status == "interrupted" ? exit_interrupted : exit_numerics;
    input.wall_s = std::chrono::duration<double>(WallClock::now() - out.begin).count();
    input.processor_s = processor_seconds() - out.processor_before;
    input.seed = out.scene.seed;
    input.threads = out.run.settings.threads;
    input.machine = system_text();
    input.versions = output::program_versions();
    if (status == "done") input.ended_early = early_end(*out.run.simulation, out.scene);
    output::add_totals(*out.run.simulation, input);
    input.ice_load = out.folder.statistics().ice_load(nullptr);
    out.folder.finish(std::move(input), out.run.simulation->bodies());
  });
}

}  // namespace nilas
