#include <chrono>
#include <utility>

#include "core/base/machine.h"
#include "core/output/run/program_versions.h"
#include "core/output/run/run_folder.h"
#include "core/output/run/simulated_totals.h"
#include "nilas/scene_content.h"
#include "nilas/simulation_content.h"
#include "nilas/translate.h"

namespace nilas {

using WallClock = std::chrono::steady_clock;

struct RunWriter::Content {
  Content(Simulation::Content& of, const std::filesystem::path& path, bool force)
      : run(of), scene(of.scene.content().scene), folder(path, force, scene.inputs) {
    folder.open(scene, run.simulation.info(), run.warning_counts);
    folder.start(scene.time.start, run.simulation.initial_ledger(), run.simulation.bodies(),
                 [this] { return run.simulation.drawn(); });
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
  if (simulation.steps() > 0)
    throw Error(ErrorKind::input, "a run folder holds a whole run: make it before the first step");
  content_ = library::translated([&] { return std::make_unique<Content>(*simulation.content_, folder, force); });
}
RunWriter::RunWriter(RunWriter&&) noexcept = default;
RunWriter::~RunWriter() = default;

void RunWriter::record() {
  Content& out = *content_;
  library::translated([&] {
    const sim::Simulation& simulation = out.run.simulation;
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

void RunWriter::finish(const std::string& status) {
  Content& out = *content_;
  library::translated([&] {
    if (std::exchange(out.is_finished, true)) throw Error(ErrorKind::input, "the run folder is finished already");
    output::SummaryInput input;
    input.status = status;
    input.exit_code = status == "done" ? exit_done : status == "interrupted" ? exit_interrupted : exit_numerics;
    input.wall_s = std::chrono::duration<double>(WallClock::now() - out.begin).count();
    input.processor_s = processor_seconds() - out.processor_before;
    input.seed = out.scene.seed;
    input.threads = out.run.settings.threads;
    input.machine = system_text();
    input.versions = output::program_versions();
    input.ended_early = status == "done" ? out.run.simulation.end_of_course() : "";
    output::add_totals(out.run.simulation, input);
    input.ice_load = out.folder.statistics().ice_load(nullptr);
    out.folder.finish(std::move(input), out.run.simulation.bodies());
  });
}

}  // namespace nilas
