#include "apps/compare/scenes/run/scene_store.h"

#include <algorithm>
#include <array>
#include <regex>
#include <set>

#include "apps/compare/workshop/json_store.h"
#include "core/base/error.h"

namespace nilas {

namespace {

using Json = nlohmann::ordered_json;

constexpr int k_version = 4;

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
  plan.whole_s = json.at("whole_s").is_number() ? json.at("whole_s").get<double>()
                                                : 0;  // without a limit it is infinite and stored as null
  return plan;
}

constexpr const char* k_study = "study.json";

/// The names of the entries that a comparison writes.
StudyFiles own_files() {
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
    : folder_(StudyFolder::claim(path, own_files(), force)) {
  write_json(path / k_study, {{"version", k_version}});
  make_folder(path / "runs");
  make_folder(path / "results");
}

SceneStore::SceneStore(const std::filesystem::path& path) : folder_(StudyFolder::open(path, own_files())) {}

void SceneStore::write(const SceneStudy& study) const {
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
  write_json(path() / k_study, json);
}

SceneStudy SceneStore::read() const {
  const Json json = read_json(path() / k_study);
  if (!json.is_discarded() && json.contains("version") && !json.contains("plan"))
    throw InputError("--resume: the comparison in " + path().string() +
                     " ended before it had a plan; begin it again with --force");
  try {
    if (json.is_discarded() || json.at("version") != k_version) throw InputError("");
    SceneStudy study;
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

}  // namespace nilas
