#pragma once
/// The runs of a comparison, and what it leaves out.
#include <string>
#include <utility>
#include <vector>

#include "apps/compare/scenes/plan/setting.h"

namespace nilas {

/// Kept of a budget for reading and drawing at its end [s].
constexpr double k_closing_s = 3;

enum class RunKind { grid, twin, reference, check };
const char* name_of(RunKind kind);

struct PlannedRun {
  std::string id;  ///< folder and file name
  RunKind kind = RunKind::grid;
  std::size_t setting = 0;  ///< in Plan::settings, of a grid or twin run
  int realisation = 0;      ///< seed and twin number go up with it
  double estimate_s = 0;    ///< processor time
};

/// What was asked for and is not run.
struct Omission {
  std::string what, why;
};

/// Simplifications that have nothing to change in a scene, and why.
std::vector<Omission> absent_simplifications(const Scene& scene);

/// "reason: this; that", one line for each reason.
std::vector<std::string> by_reason(const std::vector<Omission>& omissions);

struct Plan {
  std::vector<CompareSetting> settings;  ///< those that run, the first first
  CompareSetting reference, check;
  std::vector<PlannedRun> runs;  ///< in the order they start
  std::vector<Omission> omissions;
  double start = 0, end = 0;  ///< simulated [s]
  double scene_end = 0;       ///< [s]
  double sample_every = 0;    ///< between stored states [s]
  int realisations = 0;
  double estimate_s = 0;  ///< wall time
  double whole_s = 0;     ///< budget that would leave nothing out
  bool vary_seed = true;  ///< realisations differ in the seed, not only as twins do

  const CompareSetting& setting_of(const PlannedRun& run) const;
};

/// Adds realisations up to `realisations`, the runs of each in the order of the first's, without a check.
void extend_realisations(Plan& plan, int realisations);

/// What the runs of one setting share beside it: seed and twin number.
Overrides realisation_overrides(std::uint64_t seed, const PlannedRun& run, bool vary_seed);

}  // namespace nilas
