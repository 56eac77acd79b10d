#pragma once
/// Which runs a comparison makes within its budget, and what it leaves out.
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "apps/compare/scenes/plan/setting.h"

namespace nilas {

/// What the first setting costs, measured on a short run of its own, and what is known of others.
struct CostModel {
  /// Processor time per simulated second from the stretch before it until a time.
  struct Stretch {
    double until = 0;   ///< since the start [s]
    double other = 0;   ///< beside the solver [s/s]
    double solver = 0;  ///< [s/s]
  };
  double setup_s = 0;  ///< reading, packing ice, writing [s]
  std::vector<Stretch> rate;
  double window_from = std::numeric_limits<double>::quiet_NaN();  ///< of the mean load; NaN: not known [s]
  /// A tolerance of the reference [m/s], and the time of a step's solve to it over the first setting's.
  struct Tightness {
    double tolerance = 0, weight = 1;
  };
  std::vector<Tightness> reference;  ///< as measured, the tightest first

  /// Of the steps of a run of the first setting over `length` simulated seconds, with a solver that takes `weight`
  /// times as long; beyond what was measured the last stretch goes on.
  double steps_seconds(double length, double weight = 1) const;
  /// Between what was measured by powers of the tolerance, beyond it as its nearest end; 1 of nothing.
  double reference_weight(double tolerance) const;
};

/// Kept of a budget for reading and drawing at its end [s].
constexpr double k_closing_s = 3;

/// The loosest that judges settings whose tightest tolerance is `tolerance` [m/s]: a tenth.
double loosest_reference(double tolerance);

/// Tolerances of the reference whose cost is measured: `asked`, and the loosest that a plan may come to, where it is
/// not `fixed`. `own`: the scene's own setting.
std::vector<double> measured_tolerances(double asked, bool fixed, const CompareSetting& own);

/// What a solve of one setting takes over one of the first, by what solvers are known to take.
double solver_weight(const CompareSetting& setting, const CompareSetting& first);

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

struct PlanRequest {
  double budget_s = 1200;  ///< wall time of what is planned; 0: no limit
  int jobs = 2;            ///< at a time
  int realisations = 3;
  bool fixed_realisations = false;  ///< the user's own number
  bool fixed_length = false;        ///< the simulated time is not cut
  double stated_budget_s = 0;       ///< as the user gave it, for what is said
  bool reference = true;            ///< runs of a reference setting are needed
  bool check = true;                ///< one with double its step tells how far it still moves
  bool fixed_tolerances = false;    ///< no setting that solves tighter than the first is given up for that alone
  bool fixed_reference = false;     ///< its tolerance is not loosened
  double start = 0, end = 10;       ///< of the scene [s]
};

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

/// What a plan is made of.
struct PlanInput {
  std::vector<CompareSetting> settings;
  std::size_t core = 0;  ///< settings that come before all others
  CompareSetting reference;
  CostModel cost;
  PlanRequest request;
};

/// The longest simulated time, most realisations and most settings that fit. Settings beyond `core` (those that differ
/// from the first on one axis) go first, the last first; then the reference is loosened to a tenth of the tightest
/// tolerance that is compared, and where it still takes three tenths of the time those that solve tighter than the
/// first go and it is loosened on; then the third realisation goes, the simulated time is cut, and in the end whole
/// settings. Where the first setting judges, settings go before less than a quarter of the load's window is left.
Plan make_plan(const PlanInput& input);

/// Adds realisations up to `realisations`, the runs of each in the order of the first's, without a check.
void extend_realisations(Plan& plan, int realisations);

/// What the runs of one setting share beside it: seed and twin number.
Overrides realisation_overrides(std::uint64_t seed, const PlannedRun& run, bool vary_seed);

}  // namespace nilas
