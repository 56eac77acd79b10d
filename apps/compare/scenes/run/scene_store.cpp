#include "apps/compare/scenes/run/scene_store.h"

#include <regex>
#include <set>

#include "apps/compare/scenes/run/study_json.h"
#include "apps/compare/workshop/json_store.h"
#include "core/base/error.h"

namespace nilas::compare {

namespace {

constexpr int k_version = 4;

constexpr const char* k_study = "study.json";

/// The names of the entries that a comparison writes.
StudyFiles scene_study_files() {
  static const std::set<std::string> names{k_study,        "compare.json", "compare.html", "compare.csv",
                                           "settings.csv", "loads.csv",    "runs",         "results"};
  static const std::regex pictures(R"((differences|front|motion|steps|ablation)\.(svg|png))");
  return {{k_study}, [](const std::string& name) { return names.count(name) > 0 || std::regex_match(name, pictures); }};
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder.string() + ": " + error.message());
}

}  // namespace

SceneStore::SceneStore(const std::filesystem::path& path, bool force)
    : folder_(StudyFolder::claim(path, scene_study_files(), force)) {
  write_json(path / k_study, {{"version", k_version}});
  make_folder(path / "runs");
  make_folder(path / "results");
}

SceneStore::SceneStore(const std::filesystem::path& path) : folder_(StudyFolder::open(path, scene_study_files())) {}

void SceneStore::write(const SceneStudy& study) const {
  Json json;
  json["version"] = k_version;
  json.update(to_json(study));
  write_json(path() / k_study, json);
}

SceneStudy SceneStore::read() const {
  const Json json = read_json(path() / k_study);
  if (!json.is_discarded() && json.contains("version") && !json.contains("plan"))
    throw InputError("--resume: the comparison in " + path().string() +
                     " ended before it had a plan; begin it again with --force");
  try {
    if (json.is_discarded() || json.at("version") != k_version) throw InputError("");
    return scene_study_from(json);
  } catch (const std::exception&) {
    throw InputError((path() / k_study).string() + ": this version cannot continue the comparison");
  }
}

void SceneStore::forget(const std::string& id) const {
  std::error_code ignored;
  std::filesystem::remove(result_file(id), ignored);
}

void SceneStore::write_result(const std::string& id, const RunResult& result) const {
  write_json(result_file(id), to_json(result));
}

std::map<std::string, RunResult> SceneStore::results(const Plan& plan) const {
  std::map<std::string, RunResult> all;
  for (const auto& run : plan.runs) {
    if (!std::filesystem::exists(result_file(run.id))) continue;
    const Json json = read_json(result_file(run.id));
    try {
      if (!json.is_discarded()) all[run.id] = run_result_from(json);
    } catch (const nlohmann::json::exception&) {
      continue;  // the run is made again
    }
  }
  return all;
}

}  // namespace nilas::compare
