#pragma once
/// The statistics of a run: worst values, load series, time per phase. Source of summary.json and of the closing
/// account.
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/state.h"
#include "core/output/loads/ice_load.h"
#include "core/output/loads/load_error.h"
#include "core/output/loads/reaction_balance.h"
#include "core/output/loads/step_load.h"
#include "core/output/loads/step_series.h"
#include "core/output/tables/vessel_channels.h"
#include "core/output/text/slowdown.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

/// The largest absolute value of a column of steps.csv, and its time. A NaN counts as largest.
struct Worst {
  std::string name;
  double value = 0;
  double time = 0;  ///< [s]
};

/// Counts of steps in which a numerical method missed its goal; all are 0 in a healthy run.
struct Shortfalls {
  long unconverged_steps = 0;  ///< the solver ended above its tolerance
  long uncorrected_steps = 0;  ///< the position correction ended above its tolerance
};

/// Worst values, sums and means follow each step. Loads and residuals of all steps stand in a table, of which figures
/// over a window are made when they are asked for: one column at a time is then in memory.
class RunStatistics {
 public:
  /// `file`: of the table, which stays in memory without one; `keep`: as in OutputFile, after which restore() must be
  /// called. Functions that read or add to the table throw FileError.
  explicit RunStatistics(const sim::RunInfo& info, const std::filesystem::path& file = {},
                         std::optional<std::int64_t> keep = {});
  /// The numbers of the table in each step. A run without any has no file.
  static std::size_t numbers_per_step(const sim::RunInfo& info) { return Columns(info).count; }

  /// Notes the state before the first step.
  void start(double t, const sim::Ledger& ledger);
  /// Adds a step. `vessel_values`: as read from the channels, empty without a vessel.
  void add(const sim::StepRecord& record, const std::vector<double>& vessel_values);

  double start_time() const { return t_start_; }  ///< [s]
  double end_time() const { return t_end_; }      ///< [s]
  long steps() const { return steps_; }
  /// The worst values of each residual, penetration_max_m, penetration_mean_m, imbalance_J, momentum_imbalance_Ns,
  /// angular_momentum_imbalance_Nms and both momentum imbalances relative to their scales.
  const std::vector<Worst>& worst() const { return worst_; }
  const Worst& worst(const std::string& name) const;
  /// Kinetic energy at the start plus the absolute works of all steps: the scale of imbalance_J [J].
  double energy_put_in() const { return energy_put_in_; }
  /// Largest |imbalance_J| over energy_put_in(); 0 when both are 0.
  double relative_imbalance() const;
  const std::array<double, sim::k_num_phases>& total_ms() const { return total_ms_; }
  double mean_ms(sim::Phase phase) const;
  const Shortfalls& shortfalls() const { return shortfalls_; }
  /// Counts of contact detection over all steps.
  const detect::DetectorCounts& detection() const { return detection_; }
  /// Balance of joint reactions of carriage and parts, over all steps.
  const ReactionBalance& reactions() const { return reactions_; }

  const std::vector<std::string>& load_names() const { return load_names_; }
  /// The values of a channel in the steps of a window.
  std::vector<double> load_series(std::size_t channel, const LoadWindow& window) const;
  /// The window over which the vessel's loads are averaged.
  LoadWindow window() const;
  /// Averaging time of the vessel's filtered peaks [s].
  double peak_filter() const;
  /// Errors of the mean loads over the window; empty without a vessel. `twins`: the perturbed runs, or null.
  std::optional<LoadError> load_error(const TwinStatistics* twins) const;
  /// Ice load over the window; empty without a vessel. `twins`: as above.
  std::optional<IceLoad> ice_load(const TwinStatistics* twins) const;
  /// Error of the ice load of one step: with a vessel over its window, else over the run.
  StepLoadError step_load_error() const;
  /// Loads on the structures, each over its own window.
  std::vector<StructureLoad> structure_loads() const;
  /// Mean of the carriage's force along the course over a window [N]; empty without a moving carriage.
  std::optional<double> mean_tow(const LoadWindow& window) const;
  /// Whole sentences why the last steps took longer than the first with ice; or empty.
  std::string slowdown() const;
  double step() const { return h_; }  ///< [s]
  /// The file of the table, if it has one.
  const OutputFile* file() const { return series_.file(); }

  void save(StateWriter out) const;
  /// Restores a state. Throws InputError when it belongs to a run with other columns or the table's file has changed.
  void restore(const StateReader& in);

 private:
  /// The first column of each group, and their number. The first columns are the load channels.
  struct Columns {
    explicit Columns(const sim::RunInfo& info);

    bool has_tow = false;
    std::size_t residuals = 0;
    std::size_t tow = 0;         ///< on a carriage: those of TowColumn, then a resistance per entry of vessel_loads [N]
    std::size_t structures = 0;  ///< one column per structure and load
    std::size_t count = 0;
  };
  /// Columns of the tow: forces of carriage, water and others, and the speed [N, m/s].
  enum TowColumn : std::size_t { k_tow, k_water, k_others, k_speed, k_tow_columns };

  void note(std::size_t column, double value, double t);
  void add_vessel(const sim::StepRecord& record, const std::vector<double>& vessel_values);
  void add_structures(const sim::StepRecord& record);
  std::vector<double> load_named(const std::string& name, const LoadWindow& window) const;
  double mean_of_tow(std::size_t column, const LoadWindow& window) const;
  TowForce tow_force(const LoadWindow& window) const;
  StructureLoad structure_load(std::size_t structure) const;
  LoadWindow window_from(std::optional<double> first_ice, std::optional<double> ramp_end) const;

  sim::RunInfo info_;
  std::vector<Worst> worst_;
  std::vector<std::string> load_names_;
  Columns columns_;
  StepSeries series_;
  std::vector<double> row_;  ///< of the step that is added
  StepLoads step_loads_;
  double first_ice_ = k_never;               ///< start of the first step in which ice pressed on the vessel [s]
  double first_break_ = k_never;             ///< end of the first step in which a floe broke [s]
  std::vector<double> structure_first_ice_;  ///< start of the first step with ice, one per structure [s]
  StepCosts costs_;
  double processor_s_;  ///< processor time of the process at the end of the last step [s]
  double h_ = 0;        ///< [s]
  static constexpr double k_never = 1e300;
  std::vector<double> works_;  ///< works after the previous step [J]
  double energy_put_in_ = 0;
  double t_start_ = 0, t_end_ = 0;
  long steps_ = 0;
  std::array<double, sim::k_num_phases> total_ms_{};
  Shortfalls shortfalls_;
  detect::DetectorCounts detection_;
  ReactionBalance reactions_;
};

}  // namespace nilas::output
