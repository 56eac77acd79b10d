#include "core/sim/build/module/flow_modules.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/sim/build/module/thruster_modules.h"
#include "hydro/flow/current_tables.h"
#include "hydro/flow/propeller_wash.h"
#include "hydro/wind/wind.h"

namespace nilas::sim {

namespace {

Vec3 level_vector(const Vec2& u) { return {u.x(), u.y(), 0}; }

/// Adds the tables of the current, and returns the velocity for which the current counts as one: at the surface and the
/// start of the run, or the greatest of the tables where that is zero, as it is at slack water.
Vec3 add_current(const scene::Scene& scene, hydro::Water& water) {
  const scene::CurrentScene& current = *scene.water->current;
  water.current = current.velocity;
  Vec3 at_start = current.velocity, greatest = Vec3::Zero();
  const auto note = [&](const hydro::VelocityTable& table, double x) {
    at_start += level_vector(table.at(x));
    if (table.greatest().norm() > greatest.norm()) greatest = level_vector(table.greatest());
  };
  if (!current.profile.empty()) {
    const hydro::VelocityTable table = hydro::read_current_profile(current.profile, scene.scale);
    note(table, 0);
    water.flows.push_back(std::make_shared<hydro::CurrentProfile>(table, water.level));
  }
  if (!current.series.empty()) {
    const hydro::VelocityTable table = hydro::read_current_series(current.series, scene.scale);
    note(table, scene.time.start);
    water.flows.push_back(std::make_shared<hydro::CurrentSeries>(table));
  }
  return at_start.isZero(0) ? greatest : at_start;
}

/// The hull's least and greatest x, from its centre of mass [m].
std::pair<double, double> ends_of(const geometry::Shape& hull) {
  const auto& vertices = hull.surface.vertices;
  const auto [aft, fore] =
      std::minmax_element(vertices.begin(), vertices.end(), [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
  return {aft->x(), fore->x()};
}

hydro::WindOnVessel wind_on_vessel(const scene::WindAreaScene& given, const WorldParts& parts) {
  hydro::WindOnVessel vessel;
  vessel.hull = parts.vessel_index;
  const auto [aft, fore] = ends_of(*parts.bodies.shape[static_cast<std::size_t>(parts.vessel_index)]);
  const double com = parts.vessel_model->mass.com.x();
  vessel.midship = {given.midship ? *given.midship - com : 0.5 * (aft + fore), 0, 0};
  hydro::WindArea& area = vessel.area;
  area.model = given.model;
  if (given.ship_type) area.ship = *given.ship_type;
  if (given.model == WindAreaModel::coefficients)
    area.table = std::make_shared<const hydro::WindCoefficientTable>(given.file);
  area.frontal = given.frontal;
  area.lateral = given.lateral;
  area.length = given.length.value_or(fore - aft);
  area.centroid = given.lateral_centroid;
  area.height = given.height.value_or(0.5 * area.lateral / area.length);
  return vessel;
}

/// The names of all actuators that publish a thrust.
std::string publishers(const Channels& channels) {
  const std::string ending = hydro::thrust_channel_name("");
  std::string names;
  for (int k = 0; k < channels.size(); ++k)
    if (channels.name(k).ends_with(ending))
      names += (names.empty() ? "" : ", ") + channels.name(k).substr(0, channels.name(k).size() - ending.size());
  return names.empty() ? "none, since the scene has no thruster or propeller" : names;
}

/// Lets the jet of a thruster carry away the momentum of its thrust.
void send_against_thrust(const vessel::Thruster& thruster, const scene::JetScene& given, const ModuleSources& from,
                         hydro::WashSource& source) {
  const auto push = [thruster](double angle, bool ahead) { return thruster.direction(angle, ahead); };
  if (thruster.turns()) {
    source.angle_channel = from.parts.commands->find(hydro::angle_channel_name(thruster.name));
    source.push = push;
  } else if (!given.direction) {
    const Vec2 force = push(0, true);
    source.direction = {-force.x(), -force.y(), 0};
  }
}

hydro::WashSource wash_source(const scene::JetScene& given, std::size_t k, const ModuleSources& from) {
  const WorldParts& parts = from.parts;
  hydro::WashSource source;
  source.jet = parts.jets.at(k);
  source.position = given.position - parts.vessel_model->mass.com;
  source.direction = given.direction.value_or(-Vec3::UnitX()).normalized();
  source.thrust = given.thrust.value_or(0);
  if (given.thruster.empty()) return source;
  source.thrust_channel = parts.commands->find(hydro::thrust_channel_name(given.thruster));
  if (source.thrust_channel < 0)
    throw InputError(
        fmt::format("{}:{}: <hydro><propeller_wash><jet thruster>: found '{}', which publishes no thrust; "
                    "allowed: {}; or a constant thrust",
                    from.scene.file.string(), given.line, given.thruster, publishers(*parts.commands)));
  for (const scene::ThrusterScene& thruster : from.scene.vessel->thrusters)
    if (thruster.name == given.thruster) send_against_thrust(thruster_of(thruster, from), given, from, source);
  return source;
}

}  // namespace

void add_flows(const scene::Scene& scene, hydro::Water& water, WorldParts& parts) {
  if (scene.water->current) parts.current = add_current(scene, water);
  if (!scene.hydro) return;
  for (const scene::JetScene& jet : scene.hydro->jets) {
    parts.jets.push_back(std::make_shared<hydro::PropellerJet>(jet.diameter, water.density));
    water.flows.push_back(parts.jets.back());
  }
}

BuiltModule wind(const ModuleSources& from) {
  if (!from.scene.wind) return {};
  const scene::WindScene& given = *from.scene.wind;
  hydro::WindSettings settings;
  settings.speed = given.speed;
  settings.direction = given.direction_deg * k_deg;
  settings.density = given.density;
  settings.exponent = given.exponent;
  settings.floe_drag = given.floe_drag;
  settings.profile = given.profile;
  settings.gusts = given.gusts;
  settings.scale = from.scene.scale;
  std::optional<hydro::WindOnVessel> vessel;
  if (from.scene.vessel && from.scene.vessel->wind_area)
    vessel = wind_on_vessel(*from.scene.vessel->wind_area, from.parts);
  const double level = from.parts.water ? from.parts.water->level : 0;
  return {hydro::make_wind(settings, level, from.scene.seed, vessel), vessel ? "<wind>, <wind_area>" : "<wind>"};
}

BuiltModule propeller_wash(const ModuleSources& from) {
  if (!from.scene.hydro || from.parts.jets.empty()) return {};
  const auto& given = from.scene.hydro->jets;
  std::vector<hydro::WashSource> sources;
  for (std::size_t k = 0; k < given.size(); ++k) sources.push_back(wash_source(given[k], k, from));
  return {
      hydro::make_propeller_wash(std::move(sources), from.parts.vessel_index, from.parts.commands, from.parts.bodies),
      "<hydro><propeller_wash>"};
}

}  // namespace nilas::sim
