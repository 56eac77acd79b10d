#include "apps/nilas/run/twin_runs.h"

#include <exception>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/base/parallel.h"
#include "core/output/loads/load_statistics.h"

namespace nilas::commands {

struct TwinRuns::Twin {
  Twin(scene::Scene twin_of, std::uint64_t number) : scene(std::move(twin_of)) { scene.twin = number; }

  scene::Scene scene;
  WarningCounts warnings{make_logger("off", "")};
  std::unique_ptr<sim::Simulation> simulation;
  LoadSeries loads;
  std::optional<output::FailedTwin> failed;
};

TwinRuns::TwinRuns(const scene::Scene& scene, const sim::Simulation& itself, int count, int threads)
    : channels_(itself.info()), threads_(threads), horizon_(itself.bodies()) {
  if (itself.info().has_vessel) loads_.resize(channels_.load_names().size());
  for (int k = 1; k <= count; ++k)
    twins_.push_back(std::make_unique<Twin>(scene, scene.twin + static_cast<std::uint64_t>(k)));
  parallel_pieces(count, threads_, [&](std::ptrdiff_t k) {
    Twin& twin = *twins_[k];
    twin.simulation = std::make_unique<sim::Simulation>(twin.scene, 1, twin.warnings);
    twin.loads.resize(loads_.size());
  });
}

TwinRuns::~TwinRuns() = default;

void TwinRuns::note_loads(const sim::StepRecord& record, LoadSeries& series) const {
  if (series.empty()) return;
  std::vector<double> values;
  channels_.read(record.vessel.value(), values);
  const std::vector<double> loads = channels_.loads(values);
  for (std::size_t c = 0; c < series.size(); ++c) series[c].push_back(loads[c]);
}

sim::StepRecord TwinRuns::step(sim::Simulation& itself) {
  sim::StepRecord record;
  const auto step_twin = [&](Twin& twin) {
    if (twin.failed) return;
    try {
      note_loads(twin.simulation->step(), twin.loads);
    } catch (const SimulationError& error) {
      twin.failed = output::FailedTwin{twin.scene.twin, twin.simulation->time(), error.what()};
    }
  };
  parallel_pieces(static_cast<std::ptrdiff_t>(twins_.size()) + 1, threads_, [&](std::ptrdiff_t k) {
    if (k == 0)
      record = itself.step();
    else
      step_twin(*twins_[k - 1]);
  });
  note_loads(record, loads_);
  std::vector<const bodies::Bodies*> runs{&itself.bodies()};
  for (const auto& twin : twins_)
    if (!twin->failed) runs.push_back(&twin->simulation->bodies());
  horizon_.compare(itself.time(), runs);
  return record;
}

output::TwinStatistics TwinRuns::statistics(const output::LoadWindow& window) const {
  output::TwinStatistics out;
  out.count = static_cast<int>(twins_.size());
  out.threshold = horizon_.threshold();
  out.horizon = horizon_.horizon();
  out.e_folding = horizon_.e_folding();
  if (!loads_.empty()) out.load_names = channels_.load_names();
  out.mean_loads.resize(loads_.size());
  const auto add = [&](const LoadSeries& series) {
    if (window.steps() == 0) return;
    for (std::size_t c = 0; c < series.size(); ++c)
      out.mean_loads[c].push_back(output::load_statistics(window.of(series[c])).mean);
  };
  add(loads_);
  for (const auto& twin : twins_) {
    if (twin->failed)
      out.failed.push_back(*twin->failed);
    else
      add(twin->loads);
  }
  return out;
}

}  // namespace nilas::commands
