#pragma once
/// The folder of a comparison of one scene, with its request, its plan and the result of each run.
///
///   study.json          the request and the plan; its version alone until there is a plan
///   results/<id>.json   the result of a run that ended, written whole
///   runs/<id>/          the folder of the run
#include <filesystem>
#include <map>
#include <string>

#include "apps/compare/scenes/run/run_result.h"
#include "apps/compare/scenes/run/scene_study.h"
#include "apps/compare/workshop/study_folder.h"

namespace nilas::compare {

class SceneStore {
 public:
  /// Takes a folder for a new comparison. Throws as StudyFolder::claim.
  SceneStore(const std::filesystem::path& path, bool force);
  /// Opens the folder of an earlier comparison. Throws as StudyFolder::open.
  explicit SceneStore(const std::filesystem::path& path);

  /// Removes all that the comparison wrote; for one that could not begin.
  void abandon() { folder_.abandon(); }
  const std::filesystem::path& path() const { return folder_.path(); }
  std::filesystem::path run_folder(const std::string& id) const { return path() / "runs" / id; }

  void write(const SceneStudy& study) const;
  /// Reads the study. Throws InputError if the folder holds no study of this version.
  SceneStudy read() const;
  void write_result(const std::string& id, const RunResult& result) const;
  /// Removes the result of a run, which is then made again when the comparison is resumed.
  void forget(const std::string& id) const;
  /// The stored results by run. Those that cannot be read are left out.
  std::map<std::string, RunResult> results(const Plan& plan) const;

 private:
  std::filesystem::path result_file(const std::string& id) const { return path() / "results" / (id + ".json"); }
  StudyFolder folder_;
};

}  // namespace nilas::compare
