#include "apps/nilas/twin_runs.h"

#include <exception>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/base/parallel.h"

namespace nilas {

struct TwinRuns::Twin {
  Twin(Scene twin_of, std::uint64_t number) : scene(std::move(twin_of)) { scene.twin = number; }

  Scene scene;
  WarningCounts warnings{make_logger("off", "")};
  std::unique_ptr<Simulation> simulation;
  std::vector<double> loads;
  std::optional<FailedTwin> failed;
};

TwinRuns::TwinRuns(const Scene& scene, const Simulation& itself, int count, int threads)
    : channels_(itself.info()), threads_(threads), horizon_(itself.bodies()) {
  if (itself.info().has_vessel) loads_.resize(static_cast<std::size_t>(channels_.num_loads()));
  for (int k = 1; k <= count; ++k)
    twins_.push_back(std::make_unique<Twin>(scene, scene.twin + static_cast<std::uint64_t>(k)));
  parallel_pieces(count, threads_, [&](std::ptrdiff_t k) {
    Twin& twin = *twins_[static_cast<std::size_t>(k)];
    twin.simulation = std::make_unique<Simulation>(twin.scene, 1, twin.warnings);
    twin.loads.resize(loads_.size());
  });
}

TwinRuns::~TwinRuns() = default;

void TwinRuns::note_loads(const StepRecord& record, std::vector<double>& sums) const {
  if (sums.empty()) return;
  std::vector<double> values;
  channels_.read(record.vessel.value(), values);
  for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += values[c];
}

StepRecord TwinRuns::step(Simulation& itself) {
  StepRecord record;
  const auto step_twin = [&](Twin& twin) {
    if (twin.failed) return;
    try {
      note_loads(twin.simulation->step(), twin.loads);
    } catch (const SimulationError& error) {
      twin.failed = FailedTwin{twin.scene.twin, twin.simulation->time(), error.what()};
    }
  };
  parallel_pieces(static_cast<std::ptrdiff_t>(twins_.size()) + 1, threads_, [&](std::ptrdiff_t k) {
    if (k == 0)
      record = itself.step();
    else
      step_twin(*twins_[static_cast<std::size_t>(k - 1)]);
  });
  ++steps_;
  note_loads(record, loads_);
  std::vector<const Bodies*> runs{&itself.bodies()};
  for (const auto& twin : twins_)
    if (!twin->failed) runs.push_back(&twin->simulation->bodies());
  horizon_.compare(itself.time(), runs);
  return record;
}

TwinStatistics TwinRuns::statistics() const {
  TwinStatistics out;
  out.count = static_cast<int>(twins_.size());
  out.threshold = horizon_.threshold();
  out.horizon = horizon_.horizon();
  out.e_folding = horizon_.e_folding();
  if (!loads_.empty())
    out.load_names.assign(channels_.names().begin(), channels_.names().begin() + channels_.num_loads());
  const auto add = [&](const std::vector<double>& sums) {
    for (std::size_t c = 0; c < sums.size(); ++c) out.mean_loads[c].push_back(sums[c] / static_cast<double>(steps_));
  };
  out.mean_loads.resize(loads_.size());
  if (steps_ > 0) add(loads_);
  for (const auto& twin : twins_) {
    if (twin->failed)
      out.failed.push_back(*twin->failed);
    else if (steps_ > 0)
      add(twin->loads);
  }
  return out;
}

}  // namespace nilas
