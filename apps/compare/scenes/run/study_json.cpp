#include "apps/compare/scenes/run/study_json.h"

#include <algorithm>
#include <array>

#include "apps/compare/workshop/json_store.h"

namespace nilas::compare {

namespace {

/// Writes the fields that it visits into a JSON object.
struct FieldWriter {
  Json& json;
  template <class Value>
  void operator()(const char* name, const Value& value) const {
    json[name] = value;
  }
};

/// Reads the fields that it visits from a JSON object. Throws nlohmann::json::exception.
struct FieldReader {
  const Json& json;
  template <class Value>
  void operator()(const char* name, Value& value) const {
    json.at(name).get_to(value);
  }
};

/// Calls visit(name, field) for the fields of a setting that JSON holds as they are.
template <class Setting, class Visit>
void visit_fields_of_setting(Setting& setting, const Visit& visit) {
  visit("solver", setting.solver);
  visit("law", setting.law);
  visit("integrator", setting.integrator);
  visit("stabilisation", setting.stabilisation);
  visit("step_s", setting.step);
  visit("tolerance_m_s", setting.tolerance);
}

/// The same for a plan.
template <class AnyPlan, class Visit>
void visit_fields_of_plan(AnyPlan& plan, const Visit& visit) {
  visit("start_s", plan.start);
  visit("end_s", plan.end);
  visit("scene_end_s", plan.scene_end);
  visit("sample_every_s", plan.sample_every);
  visit("realisations", plan.realisations);
  visit("vary_seed", plan.vary_seed);
  visit("estimate_s", plan.estimate_s);
}

/// The same for a study.
template <class Study, class Visit>
void visit_fields_of_study(Study& study, const Visit& visit) {
  visit("ablation", study.ablation);
  visit("reference", study.reference);
  visit("event_driven", study.event_driven);
  visit("probe_steps", study.probe_steps);
  visit("probe_ms", study.probe_ms);
  visit("budget_s", study.budget_s);
  visit("jobs", study.jobs);
  visit("keep_runs", study.keep_runs);
}

Json overrides_json(const scene::Overrides& overrides) {
  Json list = Json::array();
  for (const auto& [path, value] : overrides) list.push_back({path, value});
  return list;
}

scene::Overrides overrides_from(const Json& json) {
  scene::Overrides overrides;
  for (const auto& pair : json) overrides.emplace_back(pair.at(0).get<std::string>(), pair.at(1).get<std::string>());
  return overrides;
}

Json compared_setting_json(const CompareSetting& setting) {
  Json simplifications = Json::array(), json = Json::object();
  for (const Simplification which : setting.simplifications) simplifications.push_back(name_of(which));
  visit_fields_of_setting(setting, FieldWriter{json});
  json["simplifications"] = simplifications;
  json["more"] = overrides_json(setting.more);
  return json;
}

CompareSetting compared_setting_from(const Json& json) {
  CompareSetting setting;
  visit_fields_of_setting(setting, FieldReader{json});
  for (const auto& name : json.at("simplifications"))
    for (const Simplification which : all_simplifications())
      if (name.get<std::string>() == name_of(which)) setting.simplifications.push_back(which);
  setting.more = overrides_from(json.at("more"));
  return setting;
}

std::vector<Omission> omissions_from(const Json& json) {
  std::vector<Omission> omissions;
  for (const auto& one : json) omissions.push_back({one.at("what"), one.at("why")});
  return omissions;
}

Json plan_json(const Plan& plan) {
  Json settings = Json::array(), runs = Json::array(), json = Json::object();
  for (const auto& setting : plan.settings) settings.push_back(compared_setting_json(setting));
  for (const auto& run : plan.runs)
    runs.push_back({{"id", run.id},
                    {"kind", name_of(run.kind)},
                    {"setting", run.setting},
                    {"realisation", run.realisation},
                    {"estimate_s", run.estimate_s}});
  json["settings"] = settings;
  json["reference"] = compared_setting_json(plan.reference);
  json["check"] = compared_setting_json(plan.check);
  json["runs"] = runs;
  json["omissions"] = to_json(plan.omissions);
  visit_fields_of_plan(plan, FieldWriter{json});
  json["setup_s"] = plan.setup_s;
  json["whole_s"] = plan.whole_s;
  return json;
}

Plan plan_from(const Json& json) {
  constexpr std::array k_kinds{RunKind::grid, RunKind::twin, RunKind::reference, RunKind::check};
  Plan plan;
  for (const auto& setting : json.at("settings")) plan.settings.push_back(compared_setting_from(setting));
  plan.reference = compared_setting_from(json.at("reference"));
  plan.check = compared_setting_from(json.at("check"));
  for (const auto& run : json.at("runs")) {
    const auto kind =
        std::find_if(k_kinds.begin(), k_kinds.end(), [&](RunKind k) { return run.at("kind") == name_of(k); });
    plan.runs.push_back({run.at("id"), kind == k_kinds.end() ? RunKind::grid : *kind, run.at("setting"),
                         run.at("realisation"), run.at("estimate_s")});
  }
  plan.omissions = omissions_from(json.at("omissions"));
  visit_fields_of_plan(plan, FieldReader{json});
  plan.setup_s = json.value("setup_s", 0.0);  // plans of earlier versions lack it
  plan.whole_s = json.at("whole_s").is_number() ? json.at("whole_s").get<double>()
                                                : 0;  // without a limit it is infinite and stored as null
  return plan;
}

}  // namespace

Json to_json(const std::vector<Omission>& omissions) {
  Json list = Json::array();
  for (const auto& omission : omissions) list.push_back({{"what", omission.what}, {"why", omission.why}});
  return list;
}

Json to_json(const SceneStudy& study) {
  Json json = Json::object();
  json["scene"] = study.scene.string();
  json["fingerprint"] = study.fingerprint;
  json["seed"] = study.seed;
  json["overrides"] = overrides_json(study.overrides);
  visit_fields_of_study(study, FieldWriter{json});
  json["refused"] = to_json(study.refused);
  json["absent"] = to_json(study.absent);
  json["plan"] = plan_json(study.plan);
  return json;
}

SceneStudy scene_study_from(const Json& json) {
  SceneStudy study;
  study.scene = json.at("scene").get<std::string>();
  study.fingerprint = json.at("fingerprint");
  study.seed = json.at("seed");
  study.overrides = overrides_from(json.at("overrides"));
  visit_fields_of_study(study, FieldReader{json});
  study.refused = omissions_from(json.at("refused"));
  study.absent = omissions_from(json.at("absent"));
  study.plan = plan_from(json.at("plan"));
  return study;
}

}  // namespace nilas::compare
