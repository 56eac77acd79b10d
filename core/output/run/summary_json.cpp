#include "core/output/run/summary_json.h"

#include <cmath>

#include "core/output/file/output_file.h"
#include "core/output/loads/ice_load_json.h"
#include "core/output/loads/load_error_json.h"
#include "core/output/loads/load_statistics.h"
#include "core/output/loads/step_load.h"

namespace nilas::output {

namespace {

using Json = nlohmann::ordered_json;

Json vessel_json(const geometry::MassProperties& mass) {
  const Mat3& I = mass.inertia;
  return {{"mass_kg", mass.mass},
          {"cog_m", {mass.com.x(), mass.com.y(), mass.com.z()}},
          {"inertia_kg_m2", {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}}};
}

Json worst_json(const RunStatistics& statistics) {
  Json worst = Json::object();
  for (const Worst& w : statistics.worst()) worst[w.name] = {{"value", w.value}, {"time_s", w.time}};
  worst["imbalance_J"]["relative_to_energy_put_in"] = statistics.relative_imbalance();
  return worst;
}

Json shortfalls_json(const RunStatistics& statistics) {
  return {{"unconverged_steps", statistics.shortfalls().unconverged_steps},
          {"uncorrected_steps", statistics.shortfalls().uncorrected_steps},
          {"detection_fallbacks", statistics.detection().fallbacks}};
}

Json detection_json(const detect::DetectorCounts& counts) {
  return {{"pairs", counts.candidate_pairs},         {"kept_separating_axis", counts.cached_separations},
          {"kept_contact_axis", counts.kept_axes},   {"settled_by_fcl", counts.by_fcl},
          {"corrected_after_fcl", counts.corrected}, {"exact_search_alone", counts.searched},
          {"closed_form", counts.closed_forms},      {"asked_fcl", counts.fcl_queries},
          {"fcl_without_answer", counts.fallbacks}};
}

Json joint_balance_json(const JointBalance& joint, double relative) {
  return {{"force_N", joint.force},
          {"force_time_s", joint.force_time},
          {"torque_Nm", joint.torque},
          {"torque_time_s", joint.torque_time},
          {"largest_force_N", joint.largest_force},
          {"largest_torque_Nm", joint.largest_torque},
          {"relative", relative},
          {"limit", ReactionBalance::k_limit}};
}

/// Adds carriage_balance and joint_balance, where there are a carriage and parts.
void add_reactions(const ReactionBalance& reactions, Json& summary) {
  Json parts = Json::object();
  for (const JointBalance& joint : reactions.joints()) {
    const Json json = joint_balance_json(joint, reactions.relative(joint));
    (joint.name.empty() ? summary["carriage_balance"] : parts[joint.name]) = json;
  }
  if (!parts.empty()) summary["joint_balance"] = parts;
}

Json loads_json(const RunStatistics& statistics) {
  Json loads = Json::object();
  const LoadWindow window = statistics.window();
  for (std::size_t c = 0; c < statistics.load_names().size(); ++c) {
    const ComponentLoad load =
        component_load(statistics.load_series(c, window), window.from, statistics.step(), statistics.peak_filter());
    const LoadStatistics& s = load.statistics;
    loads[statistics.load_names()[c]] = {{"mean", s.mean},
                                         {"std", s.std},
                                         {"max", s.max},
                                         {"p99", s.p99},
                                         {"max_filtered", std::abs(load.peak.filtered)}};
  }
  return loads;
}

/// The tare, with the names of the readings in vessel.csv.
Json tare_json(const vessel::CarriageLoads& tare, bool has_cells) {
  const Wrench& joint = tare.about_joint;
  Json json{{"carriage_fx_N", joint.force.x()},   {"carriage_fy_N", joint.force.y()},
            {"carriage_fz_N", joint.force.z()},   {"carriage_mx_Nm", joint.torque.x()},
            {"carriage_my_Nm", joint.torque.y()}, {"carriage_mz_Nm", joint.torque.z()}};
  for (std::size_t k = 0; has_cells && k < tare.cells.size(); ++k)
    json["cell" + std::to_string(k + 1) + "_N"] = tare.cells[k];
  return json;
}

Json modules_json(const sim::RunInfo& info, const RunStatistics& statistics) {
  Json built = Json::array(), ms = Json::object();
  for (const auto& [name, reason] : info.modules) built.push_back({{"name", name}, {"reason", reason}});
  for (int p = 0; p < sim::k_num_phases; ++p)
    ms[sim::to_string(static_cast<sim::Phase>(p))] = statistics.mean_ms(static_cast<sim::Phase>(p));
  return {{"built", built}, {"ms_per_step", ms}};
}

}  // namespace

/// The warnings, with their elements but without file and line: scene.xml of the folder has other lines.
static Json warnings_json(const sim::RunInfo& info) {
  Json warnings = Json::array();
  for (const Fault& warning : info.warnings) warnings.push_back(warning.where + ": " + warning.message);
  return warnings;
}

Json summary_json(const sim::RunInfo& info, const RunStatistics& statistics, const SummaryInput& input) {
  Json summary;
  summary["scene"] = info.scene_name;
  summary["status"] = input.status;
  if (!input.ended_early.empty()) summary["ended_early"] = input.ended_early;
  summary["exit_code"] = input.exit_code;
  summary["time_end_s"] = statistics.end_time();
  summary["steps"] = statistics.steps();
  summary["wall_s"] = input.wall_s;
  summary["processor_s"] = input.processor_s;
  if (input.resuming_s > 0) summary["resuming_s"] = input.resuming_s;
  summary["real_time_factor"] = input.wall_s > 0 ? (statistics.end_time() - statistics.start_time()) / input.wall_s : 0;
  if (info.has_vessel) summary["vessel"] = vessel_json(info.vessel_mass);
  if (info.tare) summary["tare"] = tare_json(*info.tare, info.has_cells);
  summary["ice"] = {{"floes", info.floes},
                    {"floes_end", input.floes_end},
                    {"mass_kg", info.ice_mass},
                    {"mass_end_kg", input.ice_mass_end},
                    {"brash_kg", input.brash_mass},
                    {"crushed_kg", input.crushed_mass},
                    {"extruded_kg", input.extruded_mass},
                    {"concentration", info.concentration}};
  summary["worst"] = worst_json(statistics);
  summary["shortfalls"] = shortfalls_json(statistics);
  summary["detection"] = detection_json(statistics.detection());
  add_reactions(statistics.reactions(), summary);
  const TwinStatistics* const twins = input.twins ? &*input.twins : nullptr;
  if (info.has_vessel) summary["window"] = window_json(statistics.window());
  if (input.ice_load) {
    summary["ice_load"] = ice_load_json(*input.ice_load, info.course);
    if (input.ice_load->tow) summary["tow_force"] = tow_force_json(*input.ice_load->tow);
  }
  summary["loads"] = loads_json(statistics);
  for (const auto& [module, figures] : input.figures)
    for (const bodies::RunFigure& figure : figures) summary["figures"][module][figure.name] = figure.value;
  if (!info.structures.empty()) summary["structures"] = structures_json(statistics.structure_loads());
  if (const auto error = statistics.load_error(twins)) summary["load_error"] = load_error_json(*error, twins);
  if (info.check_every > 0) summary["step_load_error"] = step_load_json(statistics.step_load_error());
  if (twins != nullptr) summary["twins"] = twins_json(*twins);
  summary["warnings"] = warnings_json(info);
  if (const std::string slower = statistics.slowdown(); !slower.empty()) summary["slowdown"] = slower;
  summary["modules"] = modules_json(info, statistics);
  summary["not_built"] = info.not_built;
  summary["versions"] = input.versions;
  summary["seed"] = input.seed;
  summary["threads"] = input.threads;
  summary["machine"] = input.machine;
  return summary;
}

void write_summary_json(const std::filesystem::path& path, const Json& summary) {
  constexpr int k_indent = 2;
  write_whole(path, summary.dump(k_indent, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace nilas::output
