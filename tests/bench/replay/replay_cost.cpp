/// What the replay of a run costs: bytes, and processor time beside the steps of the same run.
/// usage: bench_replay_cost SCENE.xml UNTIL FOLDER [PATH=VALUE ...]   writes FOLDER/replay.bin and prints one line:
/// floes, frames, contacts a frame, bytes a body and frame, ms a step, ms a frame, share of the run
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "core/output/replay/replay_file.h"
#include "core/output/tables/vessel_channels.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"

namespace {

using namespace nilas;

/// Processor time of all threads [s].
double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Adds up the processor time of calls.
class Clock {
 public:
  template <class Call>
  auto operator()(const Call& call) {
    struct Stop {
      double& sum;
      double begin = processor_seconds();
      ~Stop() { sum += processor_seconds() - begin; }
    } stop{seconds};
    return call();
  }
  double seconds = 0;
};

void run(const scene::Scene& scene, const std::filesystem::path& folder) {
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(scene, 1, warnings);
  const sim::RunInfo& info = simulation.info();
  const output::VesselChannels channels(info);
  Clock steps, writing;
  std::filesystem::create_directories(folder);
  output::replay::ReplayFile replay(folder / "replay.bin", scene, info, channels.names(), true);
  const long count = std::lround((scene.time.end - scene.time.start) / scene.time.step);
  const long every = std::max(1L, std::lround(scene.output.trajectory_every / scene.time.step));
  double bodies = 0, contacts = 0;
  long frames = 0;
  std::vector<double> values;
  for (long k = 1; k <= count; ++k) {
    const sim::StepRecord record = steps([&] { return simulation.step(); });
    writing([&] {
      values.clear();
      if (record.vessel) channels.read(*record.vessel, values);
      replay.note(record, values);
      if (k % every != 0) return;
      replay.frame({.t = record.t,
                    .h = record.h,
                    .step = record.step,
                    .bodies = simulation.bodies(),
                    .substeps = simulation.solved_substeps(),
                    .damage = {},
                    .lines = simulation.drawn()});
    });
    if (k % every != 0) continue;
    ++frames;
    bodies += simulation.bodies().size();
    contacts += record.contacts;
  }
  const auto bytes = static_cast<double>(replay.file().bytes());
  replay.finish("The run reached its end.");
  std::printf("| %d | %ld | %.0f | %.1f | %.2f | %.2f | %.2f | %.2f %% |\n", info.floes, frames,
              contacts / static_cast<double>(frames), bytes / 1e6, bytes / bodies,
              1e3 * steps.seconds / static_cast<double>(count), 1e3 * writing.seconds / static_cast<double>(frames),
              100 * writing.seconds / steps.seconds);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: bench_replay_cost SCENE.xml UNTIL FOLDER [PATH=VALUE ...]\n");
    return 2;
  }
  scene::Overrides changes;
  for (int k = 4; k < argc; ++k) {
    const std::string word = argv[k];
    const auto cut = word.find('=');
    changes.emplace_back(word.substr(0, cut), word.substr(cut + 1));
  }
  scene::Scene scene = scene::read_scene(argv[1], changes);
  scene.time.end = std::atof(argv[2]);
  run(scene, argv[3]);
}
