#include "core/sim/build/module/wave_modules.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "hydro/radiation/radiation.h"
#include "hydro/waves/wave_field.h"
#include "hydro/waves/wave_loads.h"

namespace nilas::sim {

namespace {

hydro::WaveTrain train_of(const scene::Scene& scene, const scene::WaveScene& given) {
  hydro::WaveTrain train;
  train.kind = given.kind;
  train.height = given.height;
  train.period = given.period;
  train.heading = given.heading_deg * k_deg;
  train.phase = given.phase_deg * k_deg;
  train.gamma = given.gamma;
  train.components = given.components;
  train.shortest_period = given.shortest();
  train.spreading = given.spreading;
  train.ramp = given.ramp;
  if (given.depth) {
    train.depth = *given.depth;
  } else if (scene.tank) {
    train.depth = scene.tank->depth;
  }
  train.ice.model = given.attenuation;
  train.ice.rate = given.attenuation_rate;
  train.ice.edge = given.ice_edge.value_or(Vec2::Zero());
  train.ice.inward = hydro::wave_direction(given.ice_edge_deg.value_or(given.heading_deg) * k_deg);
  train.ice.scale = scene.scale;
  return train;
}

std::string description(const hydro::WaveTrain& train) {
  std::string text = fmt::format("{}, height {:g} m, period {:g} s, heading {:g} deg, ", name_of(train.kind),
                                 train.height, train.period, train.heading / k_deg);
  if (train.kind != WaveKind::regular) text += fmt::format("{} components, ", train.components);
  if (train.spreading) text += fmt::format("spreading {:g}, ", *train.spreading);
  text += train.depth == hydro::k_deep_water ? "deep water, " : fmt::format("depth {:g} m, ", train.depth);
  text += "attenuation " + name_of(train.ice.model);
  if (train.ice.model == WaveAttenuation::exponential) text += fmt::format(" {:g} 1/m", train.ice.rate);
  return text;
}

hydro::WaveField draw_waves(const scene::Scene& scene, const hydro::Water& water,
                            std::vector<hydro::WaveTrain> trains) {
  try {
    return {std::move(trains), water.gravity, water.level, scene.time.start, scene.seed};
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}:{}: <water><waves>: {}", scene.file.string(), scene.water->waves.front().line, error.what()));
  }
}

/// What viewers draw of the waves.
std::vector<bodies::DrawnSea> drawn_seas(const hydro::WaveField& field, double start) {
  std::vector<bodies::DrawnSea> seas;
  for (const hydro::WaveTrain& train : field.trains())
    seas.push_back({start, train.ramp, train.ice.edge, train.ice.inward, {}});
  for (const hydro::WaveComponent& wave : field.components())
    seas[wave.train].waves.push_back(
        {wave.amplitude, wave.frequency, wave.number * wave.direction, wave.phase, wave.decay});
  return seas;
}

/// The angle by which a frame is turned about the vertical.
double yaw_of(const Mat3& R) { return std::atan2(R(1, 0), R(0, 0)); }

hydro::DatabaseWaveLoads loads_from_database(const WorldParts& parts, WaveDrift drift) {
  return {parts.database->values, parts.database->in_V.p - parts.vessel_model->mass.com,
          yaw_of(parts.database->in_V.q.toRotationMatrix()), drift};
}

/// The hull as it starts, with the frame of the database on it.
hydro::RadiatingBody radiating_hull(const scene::Scene& scene, const WorldParts& parts) {
  const auto b = static_cast<std::size_t>(parts.vessel_index);
  hydro::RadiatingBody hull;
  hull.body = parts.vessel_index;
  hull.origin_B = parts.database->in_V.p - parts.vessel_model->mass.com;
  hull.rotation = yaw_of(parts.database->in_V.q.toRotationMatrix());
  hull.mass_B.topLeftCorner<3, 3>() = parts.bodies.mass[b] * Mat3::Identity();
  hull.mass_B.bottomRightCorner<3, 3>() = parts.bodies.inertia_B[b];
  hull.velocity = parts.bodies.v_GB[b];
  hull.angular_velocity = parts.bodies.w_GB[b];
  hull.attitude = parts.bodies.R_GB[b];
  hull.current = parts.water->current;
  hull.start = scene.time.start;
  hull.step = scene.time.step;
  return hull;
}

hydro::WaveLoadSettings settings_of(const scene::WaveLoadsScene& loads, const WorldParts& parts) {
  hydro::WaveLoadSettings settings;
  settings.hull_pressure = loads.vessel == VesselWaveLoads::froude_krylov;
  settings.floe_pressure = loads.floes == FloeWaveLoads::froude_krylov;
  if (loads.vessel == VesselWaveLoads::database)
    settings.database = loads_from_database(parts, loads.drift);
  else if (settings.hull_pressure && loads.diffraction == VesselDiffraction::database)
    settings.database = loads_from_database(parts, WaveDrift::none);
  return settings;
}

std::string description(const scene::WaveLoadsScene& loads) {
  return "<hydro><wave_loads>: vessel " + name_of(loads.vessel) + ", diffraction " + name_of(loads.diffraction) +
         ", floes " + name_of(loads.floes) + ", drift " + name_of(loads.drift);
}

}  // namespace

void add_waves(const scene::Scene& scene, hydro::Water& water, WorldParts& parts) {
  if (scene.water->waves.empty()) return;
  std::vector<hydro::WaveTrain> trains;
  for (const scene::WaveScene& given : scene.water->waves) {
    trains.push_back(train_of(scene, given));
    parts.info.modules.emplace_back("waves", description(trains.back()));
  }
  parts.waves = std::make_shared<const hydro::WaveField>(draw_waves(scene, water, std::move(trains)));
  parts.info.seas = drawn_seas(*parts.waves, scene.time.start);
  // Waves without height leave the water as it is, to the last bit.
  if (!parts.waves->components().empty()) water.flows.push_back(parts.waves);
}

BuiltModule radiation(const ModuleSources& from) {
  if (!from.scene.hydro || !from.scene.hydro->radiation) return {};
  const scene::RadiationScene& given = *from.scene.hydro->radiation;
  const hydro::RadiationSettings settings{given.model, given.error, given.order, given.memory, given.highest_frequency};
  try {
    hydro::BuiltRadiation built =
        hydro::make_radiation(*from.parts.database->values, settings, radiating_hull(from.scene, from.parts));
    for (const std::string& note : built.notes) from.warnings.warn("radiation: " + note, note);
    return {std::move(built.module), "<hydro><radiation>, " + built.description};
  } catch (const InputError& error) {
    throw InputError(from.scene.file.string() + ": <hydro><radiation>: " + error.what());
  }
}

BuiltModule wave_loads(const ModuleSources& from) {
  if (!from.scene.hydro || !from.scene.hydro->wave_loads || !from.parts.waves) return {};
  const scene::WaveLoadsScene& loads = *from.scene.hydro->wave_loads;
  try {
    return {hydro::make_wave_loads(*from.parts.water, from.parts.waves, settings_of(loads, from.parts),
                                   from.parts.bodies, from.threads),
            description(loads)};
  } catch (const InputError& error) {
    throw InputError(from.scene.file.string() + ": <hydro><wave_loads>: " + error.what());
  }
}

}  // namespace nilas::sim
