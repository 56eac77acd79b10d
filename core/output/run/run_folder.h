#pragma once
/// The folder of one run and the outputs in it.
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/log.h"
#include "core/bodies/bodies.h"
#include "core/output/loads/run_statistics.h"
#include "core/output/run/run_lock.h"
#include "core/output/run/summary_json.h"
#include "core/output/tables/bodies_csv.h"
#include "core/output/tables/steps_csv.h"
#include "core/output/tables/vessel_csv.h"
#include "core/output/vtk/trajectory.h"
#include "core/scene/scene.h"
#include "core/sim/account/step_record.h"
#include "core/sim/checkpoint.h"

namespace nilas::output {

/// Asked for what the modules draw, where a frame is due.
using DrawnLines = std::function<std::vector<bodies::DrawnLine>()>;

/// The outputs of one run. Order of calls: constructor, open() and start(), or resume(); record() per step; finish().
/// Every complete step is readable at any time.
class RunFolder {
 public:
  /// Creates the folder. Throws InputError when it is not empty, unless `force`: then the files that an earlier run of
  /// Nilas wrote there are removed, except for copies among `inputs`. Throws FileError when the folder cannot be
  /// created or written, or another program writes into it.
  RunFolder(const std::filesystem::path& path, bool force, const std::vector<scene::InputFile>& inputs = {});
  /// Opens the folder of a run that continues.
  RunFolder(std::filesystem::path path, RunLock lock);
  ~RunFolder();

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path log_file() const { return path_ / "nilas.log"; }
  std::filesystem::path scene_file() const { return scene_file(path_); }
  std::filesystem::path summary_file() const { return summary_file(path_); }
  std::filesystem::path checkpoint_file() const { return checkpoint_file(path_); }
  std::filesystem::path replay_file() const { return replay_file(path_); }
  /// The same files of a folder that is not claimed.
  static std::filesystem::path scene_file(const std::filesystem::path& folder) { return folder / "scene.xml"; }
  static std::filesystem::path summary_file(const std::filesystem::path& folder) { return folder / "summary.json"; }
  static std::filesystem::path checkpoint_file(const std::filesystem::path& folder) { return folder / "checkpoint.h5"; }
  static std::filesystem::path replay_file(const std::filesystem::path& folder) { return folder / "replay.bin"; }

  /// Removes the log, and the folder if it is then empty, after a run that could not begin.
  void abandon() const;

  /// Copies the scene's input files, writes scene.xml and opens the outputs that the scene asks for. `warnings` must
  /// outlive the folder. Throws FileError, and InputError where an input file has changed since the scene was read.
  void open(const scene::Scene& scene, const sim::RunInfo& info, WarningCounts& warnings);
  /// Writes the state at time t [s] before the first step. `lines`: as in record(). Throws FileError.
  void start(double t, const sim::Ledger& ledger, const bodies::Bodies& bodies, const DrawnLines& lines = {});
  /// Replaces open() and start() for a continued run. Continues the outputs from the time when `in` was written to
  /// checkpoint.h5; rows and frames of later steps are removed. Throws FileError, and InputError where an output is too
  /// short.
  void resume(const scene::Scene& scene, const sim::RunInfo& info, WarningCounts& warnings, const StateReader& in);
  /// Writes one step. `parts`: its contact problems; `bodies`: at its end; `damage`: that of the floes;
  /// `lines`: what the modules draw. The time spent
  /// here counts as Phase::output. Throws FileError.
  void record(sim::StepRecord record, const std::vector<contact::SolvedProblem>& parts, const bodies::Bodies& bodies,
              const FloeDamage& damage = {}, const DrawnLines& lines = {});
  /// Stores the step's contact problem, where the scene asks for it. Throws FileError.
  void store(const sim::StepRecord& record, const contact::SolvedProblem& solved);
  /// Stores the problem at which the numerics failed. Throws FileError.
  void store_last(const contact::SolvedProblem& solved);
  /// Writes checkpoint.h5: `state` and the lengths of the outputs. Throws FileError.
  void write_checkpoint(const sim::CheckpointOrigin& origin, State state);
  /// Closes the outputs and writes summary.json, including the mass of the free ice in `bodies`. Throws FileError.
  nlohmann::ordered_json finish(SummaryInput input, const bodies::Bodies& bodies);
  const RunStatistics& statistics() const;
  /// Number of bytes of whole pieces in the replay file; 0 where the run stores no frames.
  std::int64_t replay_bytes() const;

 private:
  struct Outputs;
  void write_snapshot(double t, long step, const bodies::Bodies& bodies, const ShownStep& shown);

  std::filesystem::path path_;
  RunLock lock_;
  std::unique_ptr<Outputs> outputs_;
};

/// Mass of the free floes [kg].
double free_ice_mass(const bodies::Bodies& bodies);

}  // namespace nilas::output
