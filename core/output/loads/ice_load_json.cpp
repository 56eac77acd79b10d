#include "core/output/loads/ice_load_json.h"

#include "core/output/loads/ice_load_text.h"
#include "core/output/loads/or_null.h"

namespace nilas::output {

namespace {

using Json = nlohmann::ordered_json;

/// The means over the halves of the window; null where their errors are not known.
Json halves_json(const std::optional<HalfMeans>& halves, const std::string& unit) {
  if (!halves) return nullptr;
  return {{"mean_" + unit, {halves->first.mean, halves->second.mean}},
          {"estimate_" + unit, {halves->first.half_width, halves->second.half_width}},
          {"differ", halves->differ()}};
}

/// One component. `unit`: N or Nm, the end of the keys.
Json component_json(const ComponentLoad& load, const std::string& unit) {
  const Peak& peak = load.peak;
  return {{"mean_" + unit, load.statistics.mean},
          {"estimate_" + unit, or_null(load.half_width)},
          {"halves", halves_json(load.halves, unit)},
          {"std_" + unit, load.statistics.std},
          {"p99_" + unit, load.statistics.p99},
          {"filtered_peak_" + unit, peak.filtered},
          {"filtered_peak_time_s", peak.filtered_time},
          {"raw_peak_" + unit, peak.raw},
          {"raw_peak_time_s", peak.raw_time},
          {"event_impulse_" + unit + "s", peak.event_impulse},
          {"event_from_s", peak.event_from},
          {"event_to_s", peak.event_to}};
}

const char* course_text(sim::CourseKind course) {
  switch (course) {
    case sim::CourseKind::carriage:
      return "the direction in which the carriage moves";
    case sim::CourseKind::drift:
      return "against the drift of ice or water, since the vessel is fixed";
    case sim::CourseKind::heading:
      break;
  }
  return "the vessel's heading";
}

Json peaks_json(const IceLoad& load) {
  return {{"filter_s", load.filter},
          {"raw_depends_on", raw_peak_depends_on(load)},
          {"raw_is_impulse_over_step", load.peak_is_impulse_over_step()},
          {"part_of_impulse_in_largest_percent", load.in_largest},
          {"impacts_dominate", load.impacts_dominate()},
          {"paired_steps",
           {{"p99_falls_by_1", load.on_step.p99},
            {"filtered_peak_falls_by_1", load.on_step.filtered},
            {"raw_peak_falls_by_1", load.on_step.raw},
            {"rigid", load.on_step.rigid},
            {"doubted", load.on_step.doubted}}}};
}

}  // namespace

Json window_json(const LoadWindow& window) {
  return {{"from_s", window.from}, {"to_s", window.to}, {"steps", window.steps()}, {"reason", window.reason}};
}

Json ice_load_json(const IceLoad& load, sim::CourseKind course) {
  return {{"course", course_text(course)},
          {"axes", "along: positive astern; across: positive to port of the course"},
          {"touched", load.touched},
          {"along", component_json(load.along, "N")},
          {"across", component_json(load.across, "N")},
          {"peaks", peaks_json(load)}};
}

Json tow_force_json(const TowForce& tow) {
  Json json{{"mean_N", tow.mean},    {"std_N", tow.std},
            {"ice_N", tow.ice},      {"other_contacts_N", tow.others},
            {"water_N", tow.water},  {tow.on_rods ? "inertia_and_rods_N" : "inertia_N", tow.inertia},
            {"speed_m_s", tow.speed}};
  for (const auto& [name, newton] : tow.modules) json["modules_N"][name] = newton;
  if (tow.open_water) {
    json["open_water_N"] = *tow.open_water;
    json["open_water_source"] = tow.open_water_source;
    json["net_N"] = tow.net();
  }
  return json;
}

Json structures_json(const std::vector<StructureLoad>& structures) {
  Json all = Json::array();
  for (const StructureLoad& structure : structures) {
    Json loads = Json::object();
    for (const auto& [name, load] : structure.loads)
      loads[name] = component_json(load, name.ends_with("_Nm") ? "Nm" : "N");
    all.push_back({{"name", structure.name},
                   {"window", window_json(structure.ice.window)},
                   {"touched_by_ice", structure.ice.touched},
                   {"peaks", peaks_json(structure.ice)},
                   {"loads", loads}});
  }
  return all;
}

}  // namespace nilas::output
