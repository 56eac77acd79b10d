#pragma once
/// The plan of a comparison: its runs, and what it leaves out.
#include <string>
#include <utility>
#include <vector>

#include "apps/compare/scenes/plan/setting.h"

namespace nilas::compare {

/// The time of a budget that is kept for reading and drawing at its end [s].
constexpr double k_closing_s = 3;
/// The least number of the coarsest steps over which a mean load is meaningful.
constexpr int k_least_mean_steps = 20;
/// The share of a step that counts as rounding of a time.
constexpr double k_step_rounding = 1e-6;

enum class RunKind { grid, twin, reference, check };
const char* name_of(RunKind kind);

struct PlannedRun {
  std::string id;  ///< name of its folder and files
  RunKind kind = RunKind::grid;
  std::size_t setting = 0;  ///< index in Plan::settings, for a grid run or a perturbed run
  int realisation = 0;      ///< number that raises the seed and the number of the perturbed start
  double estimate_s = 0;    ///< processor time [s]
};

/// Something that was asked for and is not run, and the reason.
struct Omission {
  std::string what, why;
};

/// The simplifications that have nothing to change in a scene, and why.
std::vector<Omission> absent_simplifications(const scene::Scene& scene);

/// The omissions as lines "reason: this; that", one for each reason.
std::vector<std::string> by_reason(const std::vector<Omission>& omissions);

struct Plan {
  std::vector<CompareSetting>
      settings;  ///< the settings that run; the first is the scene's own or that without simplifications
  CompareSetting reference, check;
  std::vector<PlannedRun> runs;  ///< the runs in the order in which they start
  std::vector<Omission> omissions;
  double start = 0, end = 0;  ///< simulated times [s]
  double scene_end = 0;       ///< end time of the scene [s]
  double sample_every = 0;    ///< simulated time between stored states [s]
  int realisations = 0;
  double estimate_s = 0;  ///< estimated wall time [s]
  double setup_s = 0;     ///< part of each run's estimate that does not grow with the simulated time [s]
  double whole_s = 0;     ///< budget that would leave nothing out [s]
  bool vary_seed = true;  ///< realisations differ in the seed, not only in the perturbed start

  const CompareSetting& setting_of(const PlannedRun& run) const;
  /// The last end of a coarsest step up to a simulated time [s].
  double coarsest_end(double t) const;
};

/// A wall time [s] rounded up to two digits, or to whole seconds if it is short.
double rounded_budget(double seconds);

/// Adds realisations until there are `realisations`. Their runs are in the order of the first's, without a check.
void extend_realisations(Plan& plan, int realisations);

/// The overrides of a realisation: the seed and the number of the perturbed start.
scene::Overrides realisation_overrides(std::uint64_t seed, const PlannedRun& run, bool vary_seed);

}  // namespace nilas::compare
