/// The mean load that single runs state in ice that breaks, against the mean of accurately solved runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/output/loads/mean_error.h"
#include "core/output/loads/run_statistics.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/support/program.h"

namespace load_coverage_test {

using namespace nilas;

constexpr double k_until = 3.9;  // [s]; ice meets the ship at 2.77 s and breaks from 2.87 s on

struct Said {
  output::ChannelError error;
  bool at_least = false;
  double fast = 0;  ///< Half width of the interval if the load's memory is short [N].
};

Said run(const scene::Overrides& settings, std::uint64_t twin) {
  scene::Scene scene = scene::read_scene(nilas_test::shipped_scene("level-ice.xml"), settings);
  scene.twin = twin;
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(scene, 1, warnings);
  output::RunStatistics statistics(simulation.info());
  const output::VesselChannels channels(simulation.info());
  statistics.start(scene.time.start, simulation.initial_ledger());
  std::vector<double> values;
  while (simulation.time() < k_until - 0.5 * scene.time.step) {
    const sim::StepRecord record = simulation.step();
    channels.read(record.vessel.value(), values);
    statistics.add(record, values);
  }
  const output::LoadError error = statistics.load_error(nullptr).value();
  EXPECT_TRUE(error.ice_broke);
  const auto& names = statistics.load_names();
  const auto channel = std::find(names.begin(), names.end(), "ice_resistance_N") - names.begin();
  const auto series = statistics.load_series(static_cast<std::size_t>(channel), statistics.window());
  return {error.channels[error.headline], error.solver_at_least, output::mean_error(series).half_width()};
}

std::vector<Said> twins(const scene::Overrides& settings, int count) {
  std::vector<Said> all;
  for (int k = 0; k < count; ++k) all.push_back(run(settings, static_cast<std::uint64_t>(k)));
  return all;
}

double mean_of(const std::vector<Said>& runs) {
  double sum = 0;
  for (const Said& said : runs) sum += said.error.mean;
  return sum / static_cast<double>(runs.size());
}

TEST(LoadCoverage, OfLevelIceHoldsAndWidensWhereTheSolverStopsShort) {
  const auto sweeps = [](const char* most) {
    return scene::Overrides{
        {"contact/@solver", "nsgs"}, {"contact/@tolerance", "1e-3"}, {"contact/@max_iterations", most}};
  };
  const auto tight = twins({{"contact/@tolerance", "1e-5"}}, 2), swept = twins(sweeps("200"), 4),
             few = twins(sweeps("20"), 2);
  const double truth = mean_of(tight);
  EXPECT_GT(truth, 1);
  int held = 0, held_fast = 0;
  for (const Said& said : swept) {
    held += std::abs(said.error.mean - truth) <= said.error.total;
    held_fast += std::abs(said.error.mean - truth) <= said.fast;
    EXPECT_LT(said.error.total, truth) << "an interval that holds whatever the run gives tells nothing";
  }
  EXPECT_GE(held, 3) << "of 4";
  EXPECT_LT(held_fast, held) << "or the memory of the ice would not matter";
  // With a tenth of the sweeps the load is a third lower. No run can detect that, but each states that it is uncertain.
  EXPECT_LT(mean_of(few), 0.75 * truth);
  for (const auto& runs : {swept, few})
    for (const Said& said : runs) EXPECT_TRUE(said.at_least);
  const auto solver = [](const std::vector<Said>& runs) {
    double sum = 0;
    for (const Said& said : runs) sum += said.error.solver;
    return sum / static_cast<double>(runs.size());
  };
  EXPECT_GT(solver(swept), 1.5 * solver(tight));
  EXPECT_GT(solver(few), 1.5 * solver(swept));
}

}  // namespace load_coverage_test
