#include "apps/compare/scenes/run/study_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <vector>

#include "core/base/error.h"
#include "core/output/file/output_file.h"

namespace nilas {

namespace {

using Json = nlohmann::ordered_json;

constexpr int k_version = 4;
constexpr int k_indent = 1;

Json json_of(const Overrides& overrides) {
  Json list = Json::array();
  for (const auto& [path, value] : overrides) list.push_back({path, value});
  return list;
}

Overrides overrides_of(const Json& json) {
  Overrides overrides;
  for (const auto& pair : json) overrides.emplace_back(pair.at(0).get<std::string>(), pair.at(1).get<std::string>());
  return overrides;
}

Json json_of(const CompareSetting& s) {
  Json simplifications = Json::array();
  for (const Simplification which : s.simplifications) simplifications.push_back(name_of(which));
  return {{"solver", s.solver},
          {"law", s.law},
          {"integrator", s.integrator},
          {"stabilisation", s.stabilisation},
          {"step_s", s.step},
          {"tolerance_m_s", s.tolerance},
          {"simplifications", simplifications},
          {"more", json_of(s.more)}};
}

CompareSetting setting_of(const Json& json) {
  CompareSetting s{json.at("solver"),        json.at("law"),    json.at("integrator"),
                   json.at("stabilisation"), json.at("step_s"), json.at("tolerance_m_s")};
  for (const auto& name : json.at("simplifications"))
    for (const Simplification which : all_simplifications())
      if (name.get<std::string>() == name_of(which)) s.simplifications.push_back(which);
  s.more = overrides_of(json.at("more"));
  return s;
}

Json json_of(const std::vector<Omission>& omissions) {
  Json list = Json::array();
  for (const auto& omission : omissions) list.push_back({{"what", omission.what}, {"why", omission.why}});
  return list;
}

std::vector<Omission> omissions_of(const Json& json) {
  std::vector<Omission> omissions;
  for (const auto& one : json) omissions.push_back({one.at("what"), one.at("why")});
  return omissions;
}

Json json_of(const Plan& plan) {
  Json settings = Json::array(), runs = Json::array();
  for (const auto& setting : plan.settings) settings.push_back(json_of(setting));
  for (const auto& run : plan.runs)
    runs.push_back({{"id", run.id},
                    {"kind", name_of(run.kind)},
                    {"setting", run.setting},
                    {"realisation", run.realisation},
                    {"estimate_s", run.estimate_s}});
  return {{"settings", settings},
          {"reference", json_of(plan.reference)},
          {"check", json_of(plan.check)},
          {"runs", runs},
          {"omissions", json_of(plan.omissions)},
          {"start_s", plan.start},
          {"end_s", plan.end},
          {"scene_end_s", plan.scene_end},
          {"sample_every_s", plan.sample_every},
          {"realisations", plan.realisations},
          {"vary_seed", plan.vary_seed},
          {"estimate_s", plan.estimate_s},
          {"whole_s", plan.whole_s}};
}

Plan plan_of(const Json& json) {
  constexpr std::array k_kinds{RunKind::grid, RunKind::twin, RunKind::reference, RunKind::check};
  Plan plan;
  for (const auto& setting : json.at("settings")) plan.settings.push_back(setting_of(setting));
  plan.reference = setting_of(json.at("reference"));
  plan.check = setting_of(json.at("check"));
  for (const auto& run : json.at("runs")) {
    const auto kind =
        std::find_if(k_kinds.begin(), k_kinds.end(), [&](RunKind k) { return run.at("kind") == name_of(k); });
    plan.runs.push_back({run.at("id"), kind == k_kinds.end() ? RunKind::grid : *kind, run.at("setting"),
                         run.at("realisation"), run.at("estimate_s")});
  }
  plan.omissions = omissions_of(json.at("omissions"));
  plan.start = json.at("start_s");
  plan.end = json.at("end_s");
  plan.scene_end = json.at("scene_end_s");
  plan.sample_every = json.at("sample_every_s");
  plan.realisations = json.at("realisations");
  plan.vary_seed = json.at("vary_seed");
  plan.estimate_s = json.at("estimate_s");
  plan.whole_s = json.at("whole_s").is_number() ? json.at("whole_s").get<double>() : 0;  // no limit: not known
  return plan;
}

constexpr const char* k_study = "study.json";

/// Removes what a comparison writes, and nothing else.
void remove_own(const std::filesystem::path& folder) {
  std::vector<std::string> parts{k_study,        "compare.json", "compare.html", "compare.csv",
                                 "settings.csv", "loads.csv",    "runs",         "results"};
  for (const char* picture : {"differences", "front", "motion", "steps", "ablation"})
    for (const char* kind : {".svg", ".png"}) parts.push_back(std::string(picture) + kind);
  std::error_code ignored;
  for (const auto& part : parts) std::filesystem::remove_all(folder / part, ignored);
}

}  // namespace

StudyFolder::StudyFolder(std::filesystem::path path, bool force) : path_(std::move(path)) {
  std::error_code error;
  const bool empty = !std::filesystem::exists(path_) || std::filesystem::is_empty(path_, error);
  if (error) throw FileError(path_.string() + ": " + error.message());
  if (!empty && !force)
    throw InputError(path_.string() + " is not empty; name another folder, or --force to write there");
  // only what a comparison wrote is taken away: runs/ may as well hold someone's runs
  const bool earlier = std::filesystem::exists(path_ / k_study);
  for (const char* part : {"runs", "results"})
    if (!earlier && std::filesystem::exists(path_ / part))
      throw InputError(
          fmt::format("{} holds a folder {} that no comparison wrote; name another folder", path_.string(), part));
  std::filesystem::create_directories(path_, error);
  if (error) throw FileError(path_.string() + ": " + error.message());
  lock_.emplace(path_);
  if (earlier) remove_own(path_);
  write_whole(path_ / k_study, Json{{"version", k_version}}.dump() + "\n");
  for (const char* part : {"runs", "results"}) {
    std::filesystem::create_directories(path_ / part, error);
    if (error) throw FileError((path_ / part).string() + ": " + error.message());
  }
}

void StudyFolder::abandon() const {
  remove_own(path_);
  std::error_code ignored;
  std::filesystem::remove(path_ / "nilas.log", ignored);
  std::filesystem::remove(path_, ignored);  // where nothing else is in it
}

StudyFolder::StudyFolder(std::filesystem::path path) : path_(std::move(path)) {
  if (!std::filesystem::is_directory(path_)) throw FileError("--resume: there is no folder " + path_.string());
  if (!std::filesystem::exists(path_ / k_study))
    throw InputError("--resume: " + path_.string() + " holds no comparison (there is no study.json)");
  lock_.emplace(path_);
}

void StudyFolder::write(const Study& study) const {
  const Json json{{"version", k_version},
                  {"scene", study.scene.string()},
                  {"fingerprint", study.fingerprint},
                  {"seed", study.seed},
                  {"overrides", json_of(study.overrides)},
                  {"ablation", study.ablation},
                  {"reference", study.reference},
                  {"event_driven", study.event_driven},
                  {"probe_steps", study.probe_steps},
                  {"probe_ms", study.probe_ms},
                  {"budget_s", study.budget_s},
                  {"jobs", study.jobs},
                  {"keep_runs", study.keep_runs},
                  {"refused", json_of(study.refused)},
                  {"absent", json_of(study.absent)},
                  {"plan", json_of(study.plan)}};
  write_whole(path_ / k_study, json.dump(k_indent, ' ', false, Json::error_handler_t::replace) + "\n");
}

Study StudyFolder::read() const {
  std::ifstream in(path_ / k_study);
  const Json json = Json::parse(in, nullptr, false);
  if (!json.is_discarded() && json.contains("version") && !json.contains("plan"))
    throw InputError("--resume: the comparison in " + path_.string() +
                     " was ended before it had a plan; begin it again with --force");
  try {
    if (json.is_discarded() || json.at("version") != k_version) throw InputError("");
    Study study;
    study.scene = json.at("scene").get<std::string>();
    study.fingerprint = json.at("fingerprint");
    study.seed = json.at("seed");
    study.overrides = overrides_of(json.at("overrides"));
    study.ablation = json.at("ablation");
    study.reference = json.at("reference");
    study.event_driven = json.at("event_driven");
    study.probe_steps = json.at("probe_steps");
    study.probe_ms = json.at("probe_ms");
    study.budget_s = json.at("budget_s");
    study.jobs = json.at("jobs");
    study.keep_runs = json.at("keep_runs");
    study.refused = omissions_of(json.at("refused"));
    study.absent = omissions_of(json.at("absent"));
    study.plan = plan_of(json.at("plan"));
    return study;
  } catch (const std::exception&) {
    throw InputError((path_ / k_study).string() + ": not a comparison that this version can go on with");
  }
}

void StudyFolder::forget(const std::string& id) const {
  std::error_code ignored;
  std::filesystem::remove(path_ / "results" / (id + ".json"), ignored);
}

void StudyFolder::write_result(const std::string& id, const RunResult& result) const {
  write_whole(path_ / "results" / (id + ".json"),
              to_json(result).dump(k_indent, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::map<std::string, RunResult> StudyFolder::results(const Plan& plan) const {
  std::map<std::string, RunResult> all;
  for (const auto& run : plan.runs) {
    std::ifstream in(path_ / "results" / (run.id + ".json"));
    if (!in) continue;
    const Json json = Json::parse(in, nullptr, false);
    try {
      if (!json.is_discarded()) all[run.id] = run_result_from(json);
    } catch (const nlohmann::json::exception&) {
      continue;  // not ours, or of another version: the run is made again
    }
  }
  return all;
}

}  // namespace nilas
