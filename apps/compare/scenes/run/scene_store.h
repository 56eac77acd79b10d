#pragma once
/// The folder of a comparison of one scene: what was asked, what was planned, and what each run gave.
///
///   study.json          what was asked, the plan; its version alone until there is a plan
///   results/<id>.json   of a run that ended, written whole
///   runs/<id>/          its folder
#include <filesystem>
#include <map>
#include <string>

#include "apps/compare/scenes/run/run_result.h"
#include "apps/compare/scenes/run/scene_study.h"
#include "apps/compare/workshop/study_folder.h"

namespace nilas {

class SceneStore {
 public:
  /// Takes a folder for a new comparison. Throws as StudyFolder::claim.
  SceneStore(const std::filesystem::path& path, bool force);
  /// Opens that of an earlier one. Throws as StudyFolder::open.
  explicit SceneStore(const std::filesystem::path& path);

  /// For a comparison that could not begin.
  void abandon() { folder_.abandon(); }
  const std::filesystem::path& path() const { return folder_.path(); }
  std::filesystem::path run_folder(const std::string& id) const { return path() / "runs" / id; }

  void write(const SceneStudy& study) const;
  /// Throws InputError where the folder holds no study of this version.
  SceneStudy read() const;
  void write_result(const std::string& id, const RunResult& result) const;
  /// The run is made again when the comparison goes on.
  void forget(const std::string& id) const;
  /// Of all runs that ended.
  std::map<std::string, RunResult> results(const Plan& plan) const;

 private:
  std::filesystem::path result_file(const std::string& id) const { return path() / "results" / (id + ".json"); }
  StudyFolder folder_;
};

}  // namespace nilas
