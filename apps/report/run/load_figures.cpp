#include "apps/report/run/load_figures.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/output/loads/ice_load_text.h"

namespace nilas::report {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char *k_along = "ice_resistance_N", *k_across_column = "ice_side_N";

output::ComponentLoad component_from(const Json& json) {
  output::ComponentLoad load;
  load.statistics.mean = json.at("mean_N");
  load.statistics.std = json.at("std_N");
  load.statistics.p99 = json.at("p99_N");
  load.statistics.max = std::abs(json.at("raw_peak_N").get<double>());
  if (!json.at("estimate_N").is_null()) load.half_width = json.at("estimate_N").get<double>();
  if (json.contains("halves") && !json.at("halves").is_null()) {
    const Json &mean = json.at("halves").at("mean_N"), &error = json.at("halves").at("estimate_N");
    load.halves = output::HalfMeans{{mean.at(0), error.at(0)}, {mean.at(1), error.at(1)}};
  }
  load.peak.filtered = json.at("filtered_peak_N");
  load.peak.filtered_time = json.at("filtered_peak_time_s");
  load.peak.raw = json.at("raw_peak_N");
  load.peak.raw_time = json.at("raw_peak_time_s");
  load.peak.event_impulse = json.at("event_impulse_Ns");
  load.peak.event_from = json.at("event_from_s");
  load.peak.event_to = json.at("event_to_s");
  return load;
}

/// The steps of a run that end after `from` and not after `to`.
output::LoadWindow window_from(const Json& json, const RunData& run) {
  output::LoadWindow window = output::load_window(
      {run.start(), run.step(), run.steps_done(),
       std::array{json.at("from_s").get<double>(), json.at("to_s").get<double>()}, std::nullopt, std::nullopt});
  window.reason = json.at("reason");
  return window;
}

void take_summary(const Json& ice, const Json& window, const RunData& run, BodyLoad& load) {
  load.told = true;
  load.touched = ice.contains("touched") ? ice.at("touched").get<bool>() : ice.at("touched_by_ice").get<bool>();
  const Json& along = ice.contains("along") ? ice.at("along") : ice.at("loads").at(k_along);
  const Json& across = ice.contains("across") ? ice.at("across") : ice.at("loads").at(k_across_column);
  load.along = component_from(along);
  load.across = component_from(across);
  load.along.peak.filter = load.across.peak.filter = ice.at("peaks").at("filter_s");
  load.peak_depends = ice.at("peaks").at("raw_depends_on");
  if (ice.at("peaks").contains("paired_steps")) {
    const Json& falls = ice.at("peaks").at("paired_steps");
    load.on_step =
        output::StepDependence{falls.at("p99_falls_by_1"), falls.at("filtered_peak_falls_by_1"),
                               falls.at("raw_peak_falls_by_1"), falls.at("rigid"), falls.value("doubted", false)};
  }
  load.window = window_from(window, run);
}

/// The same figures from the series of the loads along and across the course.
void compute(const RunData& run, std::optional<double> ramp_end, const std::vector<double>& across, double length,
             BodyLoad& load) {
  load.told = false;
  const double start = run.start(), h = run.step();
  std::optional<double> first_ice;
  for (std::size_t k = 0; k < load.series.size() && !first_ice; ++k)
    if (load.series[k] != 0 || across[k] != 0) first_ice = start + static_cast<double>(k) * h;
  load.touched = first_ice.has_value();
  const auto asked = run.scene ? run.scene->output.statistics : std::nullopt;
  load.window = output::load_window({start, h, load.series.size(), asked, ramp_end, first_ice});
  const double filter =
      run.scene && run.scene->output.peak_filter ? *run.scene->output.peak_filter : output::default_peak_filter(length);
  const bool broke = run.broke_before(load.window.to);
  const std::vector<double> along = load.window.of(load.series);
  load.along = output::component_load(along, load.window.from, h, filter, broke);
  load.across = output::component_load(load.window.of(across), load.window.from, h, filter, broke);
  load.on_step = output::step_dependence(along, h, filter, true);
  load.chance_alone = true;
}

/// The length of a body that sets the filter of its peaks [m]; that of the vessel has no name.
double length_of(const RunShapes* shapes, const std::string& name) {
  constexpr double k_not_known = 1;
  if (shapes == nullptr) return k_not_known;
  if (name.empty()) return shapes->info.vessel_length;
  for (const sim::StructureInfo& structure : shapes->info.structures)
    if (structure.name == name) return structure.length;
  return k_not_known;
}

BodyLoad vessel_load(RunData& run, const RunShapes* shapes) {
  BodyLoad load;
  load.series = run.vessel[k_along];
  const bool told = run.summary.contains("ice_load") && run.attempt("The load of the summary", [&] {
    take_summary(run.summary.at("ice_load"), run.summary.at("window"), run, load);
    const Json& error = run.summary.at("load_error");
    load.error_at_least = error.at("solver_at_least").get<bool>() || error.value("law_at_least", false);
  });
  const auto ramp_end = shapes != nullptr ? shapes->info.ramp_end : std::nullopt;
  if (!told) compute(run, ramp_end, run.vessel[k_across_column], length_of(shapes, ""), load);
  return load;
}

const Json* structure_json(const RunData& run, const std::string& name) {
  if (!run.summary.contains("structures")) return nullptr;
  for (const Json& structure : run.summary.at("structures"))
    if (structure.at("name") == name) return &structure;
  return nullptr;
}

}  // namespace

std::vector<BodyLoad> body_loads(RunData& run, const RunShapes* shapes) {
  std::vector<BodyLoad> loads;
  if (run.has_vessel()) loads.push_back(vessel_load(run, shapes));
  const std::string end = std::string("_") + k_along;
  for (const std::string& column : run.structures.names()) {
    if (!column.ends_with(end)) continue;
    BodyLoad load;
    load.name = column.substr(0, column.size() - end.size());
    load.series = run.structures[column];
    const Json* json = structure_json(run, load.name);
    const bool told = json != nullptr && run.attempt("The load on " + load.name,
                                                     [&] { take_summary(*json, json->at("window"), run, load); });
    load.chance_alone = true;  // the run estimates the effects of solver and law for a vessel only
    if (!told)
      compute(run, std::nullopt, run.structures[load.name + "_" + k_across_column], length_of(shapes, load.name), load);
    loads.push_back(std::move(load));
  }
  return loads;
}

const BodyLoad* subject_of(const std::vector<BodyLoad>& loads, const std::string& name, const std::string& vessel) {
  const auto size = [](const BodyLoad& load) {
    return std::hypot(load.along.statistics.mean, load.across.statistics.mean);
  };
  const BodyLoad* best = nullptr;
  std::string names;
  for (const BodyLoad& load : loads) {
    const std::string& own = load.is_vessel() ? vessel : load.name;
    names += (names.empty() ? "" : ", ") + own;
    if (!name.empty() ? own == name : best == nullptr || (!best->is_vessel() && size(load) > size(*best))) best = &load;
  }
  if (!name.empty() && best == nullptr) throw InputError("--body: found '" + name + "'; allowed: " + names);
  return best;
}

}  // namespace nilas::report
