#pragma once
/// The folder of a comparison: what was asked, what was planned, and what each run gave, so that it can go on.
///
///   study.json          what was asked, the plan; its version alone until there is a plan
///   results/<id>.json   of a run that ended, written whole
///   runs/<id>/          its folder
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "apps/compare/scenes/plan/plan.h"
#include "apps/compare/scenes/run/run_result.h"
#include "core/output/run/run_lock.h"

namespace nilas {

/// What a comparison needs to go on.
struct Study {
  std::filesystem::path scene;  ///< absolute
  std::string fingerprint;      ///< of the scene as asked
  Overrides overrides;          ///< the user's own
  Plan plan;
  bool ablation = false;
  std::string reference = "auto";  ///< or the run folder that errors are judged by
  bool event_driven = false;       ///< the reference integrates between events
  std::size_t probe_steps = 0;     ///< of the first setting, alone on the machine
  double probe_ms = 0;             ///< that they took
  double budget_s = 0;
  int jobs = 1;
  bool keep_runs = false;
  std::vector<Omission> refused;  ///< settings that the scene does not take
  std::vector<Omission> absent;   ///< simplifications that an ablation has nothing to turn on for

  std::uint64_t seed = 0;  ///< of the scene as asked
};

class StudyFolder {
 public:
  /// Takes a folder for a new comparison; one that holds anything is refused (InputError) unless `force`, which removes
  /// what an earlier comparison wrote there and nothing else. Throws FileError, also where another program is at work
  /// in it.
  StudyFolder(std::filesystem::path path, bool force);
  /// One that is there. Throws InputError where it holds none, FileError where it is not there.
  explicit StudyFolder(std::filesystem::path path);

  /// For a comparison that could not begin: removes what was made, and the folder when nothing else is in it.
  void abandon() const;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path run_folder(const std::string& id) const { return path_ / "runs" / id; }

  void write(const Study& study) const;
  /// Throws InputError where what is there is not a study of this version.
  Study read() const;
  void write_result(const std::string& id, const RunResult& result) const;
  /// The run is made again when the comparison goes on.
  void forget(const std::string& id) const;
  /// Of all runs that ended.
  std::map<std::string, RunResult> results(const Plan& plan) const;

 private:
  std::filesystem::path path_;
  std::optional<RunLock> lock_;  ///< keeps a second comparison out
};

}  // namespace nilas
