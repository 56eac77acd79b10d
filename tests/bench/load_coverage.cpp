/// Checks the stated uncertainty of the mean ice load of single runs: the interval of each run against the mean over
/// many runs of the same scene that start 1e-12 m apart, with the scene's own settings and with others.
/// usage: bench_load_coverage SCENE.xml UNTIL RUNS [-- PATH=VALUE ...]...   every -- is one more row of settings; the
/// last row is also the reference of the others
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/output/loads/run_statistics.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/bench/twins.h"

namespace {

using namespace nilas;
using namespace nilas::bench;

/// The mean load that one run states, with its uncertainties.
struct Said {
  double mean = 0, solver = 0, chaos = 0, estimate = 0;  // [N]
  bool at_least = false;
};
struct Course {
  Said along, across;
  double share_short = 0;  // Share of the steps whose solution missed the tolerance.
};

Said said(const output::LoadError& error, const std::string& channel) {
  for (const output::ChannelError& c : error.channels)
    if (c.channel == channel) return {c.mean, c.solver, c.chaos.value_or(0), c.total, error.at_least()};
  return {};
}

Course run(const std::string& file, double until, const scene::Overrides& settings, std::uint64_t twin) {
  scene::Scene scene = scene::read_scene(file, settings);
  scene.twin = twin;
  scene.time.end = until;
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(scene, 1, warnings);
  output::RunStatistics statistics(simulation.info());
  const output::VesselChannels channels(simulation.info());
  statistics.start(scene.time.start, simulation.initial_ledger());
  const long steps = std::lround((until - scene.time.start) / scene.time.step);
  std::vector<double> values;
  for (long k = 0; k < steps; ++k) {
    const sim::StepRecord record = simulation.step();
    values.clear();
    channels.read(record.vessel.value(), values);
    statistics.add(record, values);
  }
  const output::LoadError error = statistics.load_error(nullptr).value();
  return {said(error, "ice_resistance_N"), said(error, "ice_side_N"),
          static_cast<double>(statistics.shortfalls().unconverged_steps) / static_cast<double>(steps)};
}

struct Row {
  std::string name;
  std::vector<Course> runs;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void print_row(const Row& row, const Row& last, const char* axis, Said Course::*which) {
  const auto mean_load = [&](const Row& r) {
    return mean_of(r.runs, [&](const Course& c) { return (c.*which).mean; });
  };
  const auto count = static_cast<double>(row.runs.size());
  const auto median_of = [&](double Said::*part) {
    std::vector<double> values;
    for (const Course& c : row.runs) values.push_back(c.*which.*part);
    return median(values);
  };
  const auto covers = [&](double truth) {
    return std::count_if(row.runs.begin(), row.runs.end(),
                         [&](const Course& c) { return std::abs((c.*which).mean - truth) <= (c.*which).estimate; });
  };
  const auto at_least =
      std::count_if(row.runs.begin(), row.runs.end(), [&](const Course& c) { return (c.*which).at_least; });
  const Mean mean = mean_load(row), truth = mean_load(last);
  std::printf("| %s, %s | %.1f +- %.1f | %.1f | %.0f %% | %.2f | %.2f | %.2f | %ld | %ld | %ld of %.0f |\n",
              row.name.c_str(), axis, mean.value, mean.error, mean.error * std::sqrt(count),
              100 * mean_of(row.runs, [](const Course& c) { return c.share_short; }).value, median_of(&Said::solver),
              median_of(&Said::chaos), median_of(&Said::estimate), static_cast<long>(at_least),
              static_cast<long>(covers(mean.value)), static_cast<long>(covers(truth.value)), count);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: bench_load_coverage SCENE.xml UNTIL RUNS [-- PATH=VALUE ...]...\n");
    return 2;
  }
  const std::string file = argv[1];
  const double until = std::atof(argv[2]);
  const int count = std::atoi(argv[3]);
  std::vector<std::pair<std::string, scene::Overrides>> settings{{"as shipped", {}}};
  for (int k = 4; k < argc; ++k) {
    const std::string word = argv[k];
    const auto cut = word.find('=');
    if (word == "--") {
      settings.push_back({"", {}});
    } else if (cut != std::string::npos) {
      auto& [name, changes] = settings.back();
      name += (name.empty() ? "" : " ") + word;
      changes.emplace_back(word.substr(0, cut), word.substr(cut + 1));
    }
  }
  std::vector<Row> rows;
  for (const auto& setting : settings)
    rows.push_back({setting.first, with_twins(count - 1, 1, [&](std::uint64_t twin) {
                      return run(file, until, setting.second, twin);
                    })});
  std::printf(
      "| settings, load | mean of the runs [N] | they scatter by [N] | steps short | stated: solver [N] | chance [N] | "
      "+- [N] | said \"at least\" | hold the mean | hold that of the last row "
      "|\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Row& row : rows) {
    print_row(row, rows.back(), "along", &Course::along);
    print_row(row, rows.back(), "across", &Course::across);
  }
}
