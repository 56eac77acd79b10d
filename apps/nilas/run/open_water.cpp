#include "apps/nilas/run/open_water.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/nilas/commands/scene_flags.h"
#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/base/json_text.h"
#include "core/base/log.h"
#include "core/sim/simulation.h"

namespace nilas::commands {

using nlohmann::literals::operator""_json_pointer;

void OpenWater::demand_towed(const scene::Scene& scene) {
  if (!scene.vessel || !scene.vessel->carriage)
    throw InputError("--open-water: the scene tows no vessel; allowed: scenes with <vessel><carriage>");
}

OpenWater OpenWater::towed(const scene::Scene& scene, int threads) {
  demand_towed(scene);
  scene::Scene without_ice = scene;
  without_ice.ice.reset();
  without_ice.fracture.reset();
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(without_ice, threads, warnings);
  const output::VesselChannels channels(simulation.info());
  OpenWater water;
  water.source_ = "towed without ice";
  water.run_.emplace(simulation.info());
  water.run_->start(scene.time.start, simulation.initial_ledger());
  std::vector<double> values;
  const long steps = scene::number_of_steps(scene.time);
  for (long k = 0; k < steps && simulation.end_of_course().empty(); ++k) {
    const sim::StepRecord record = simulation.step();
    channels.read(record.vessel.value(), values);
    water.run_->add(record, values);
  }
  return water;
}

OpenWater OpenWater::stored(const std::filesystem::path& run) {
  const auto file = run / "summary.json";
  demand_there(run, "run folder");
  const auto summary = nlohmann::json::parse(json_file_text(file), nullptr, false);
  const auto mean = nlohmann::json::json_pointer("/tow_force/mean_N");
  if (summary.is_discarded() || !summary.contains(mean))
    throw InputError("--open-water-run: " + file.string() + " holds no tow force; allowed: runs of a towed vessel");
  if (summary.at("/ice/floes"_json_pointer).get<long>() > 0)
    throw InputError("--open-water-run: the run in " + run.string() + " has ice; allowed: runs without <ice>");
  OpenWater water;
  water.mean_ = summary.at(mean).get<double>();
  water.speed_ = summary.at("/tow_force/speed_m_s"_json_pointer).get<double>();
  water.vessel_ = {summary.at("/vessel/mass_kg"_json_pointer).get<double>(),
                   summary.at("/vessel/inertia_kg_m2/1"_json_pointer).get<double>()};
  water.source_ = "from " + run.string();
  return water;
}

std::string OpenWater::deduct_from(output::IceLoad& load, const geometry::MassProperties& vessel) const {
  constexpr double k_same_vessel = 1e-6;
  const auto differ = [](double a, double b) { return std::abs(a - b) > k_same_vessel * std::abs(b); };
  if (!run_ && (differ(vessel_.mass, vessel.mass) || differ(vessel_.pitch_inertia, vessel.inertia(1, 1))))
    return fmt::format(
        "nothing is deducted: the open-water run is of another vessel, of {:.6g} kg and {:.6g} kg m^2 in "
        "pitch, this one has {:.6g} kg and {:.6g} kg m^2",
        vessel_.mass, vessel_.pitch_inertia, vessel.mass, vessel.inertia(1, 1));
  if (!load.tow) return "nothing is deducted: the carriage does not move";
  constexpr double k_same_speed = 0.01;
  if (!run_ && std::abs(speed_ - load.tow->speed) > k_same_speed * std::abs(load.tow->speed))
    return fmt::format("nothing is deducted: the open-water run was towed at {:.4g} m/s, this one at {:.4g} m/s",
                       speed_, load.tow->speed);
  load.tow->open_water = run_ ? run_->mean_tow(load.window) : mean_;
  load.tow->open_water_source = source_;
  return "";
}

}  // namespace nilas::commands
