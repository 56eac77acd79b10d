#include "core/sim/build/module/thruster_modules.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/vessel/control/dp_module.h"
#include "core/vessel/thrusters/thruster_module.h"

namespace nilas::sim {

namespace {

std::vector<vessel::Thruster> thrusters_of(const ModuleSources& from) {
  std::vector<vessel::Thruster> thrusters;
  for (const scene::ThrusterScene& given : from.scene.vessel->thrusters) thrusters.push_back(thruster_of(given, from));
  return thrusters;
}

double hull_length(const WorldParts& parts) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3& vertex : parts.bodies.shape[parts.vessel_index]->surface.vertices) {
    low = std::min(low, vertex.x());
    high = std::max(high, vertex.x());
  }
  return high - low;
}

/// Added mass of the hull in surge, sway and yaw that the scene's modules give.
Vec3 added_mass_of_hull(const WorldParts& parts) {
  Vec3 added = Vec3::Zero();
  constexpr int k_yaw = 5;
  for (const bodies::Module* module : parts.forces)
    if (const std::optional<Mat6> own = module->vessel_added_mass())
      added += Vec3((*own)(0, 0), (*own)(1, 1), (*own)(k_yaw, k_yaw));
  return added;
}

/// The undisturbed water at the thrusters, without the jets of the vessel itself.
std::function<Vec3(const Vec3&, double)> water_velocity(const hydro::Water& water) {
  hydro::Flows flows;
  for (const auto& flow : water.flows)
    if (flow->acts_on_vessel()) flows.push_back(flow);
  return [flows, current = water.current](const Vec3& point, double t) {
    Vec3 velocity = current;
    for (const auto& flow : flows) velocity += flow->velocity(point, t);
    return velocity;
  };
}

/// The load of the module `wind` on the hull; empty where there is none.
vessel::KnownLoad wind_on_hull(const WorldParts& parts) {
  for (bodies::Module* module : parts.forces)
    if (module->name() == "wind")
      return [module, hull = static_cast<std::size_t>(parts.vessel_index)](const bodies::Bodies& bodies, double t) {
        bodies::Wrenches loads(static_cast<std::size_t>(bodies.size()));
        module->add_forces(bodies, t, loads);
        return loads[hull];
      };
  return {};
}

vessel::PositioningPlan plan_of(const scene::ControlScene& control, const Vec3& now, double file_scale) {
  if (!control.path.empty()) return vessel::PositioningPlan::path(control.path, now.z(), file_scale);
  Vec3 goal = now;
  if (control.setpoint) goal.head<2>() = *control.setpoint;
  if (control.heading_deg) goal.z() = *control.heading_deg * k_deg;
  return vessel::PositioningPlan::hold(goal, now.z());
}

vessel::DpSettings dp_settings(const ModuleSources& from) {
  const scene::ControlScene& control = *from.scene.vessel->control;
  const WorldParts& parts = from.parts;
  vessel::DpSettings dp;
  dp.hull = parts.vessel_index;
  dp.start = from.scene.time.start;
  dp.position = vessel::plane_position(parts.bodies, dp.hull);
  dp.velocity = vessel::plane_velocity(parts.bodies, dp.hull);
  dp.plan = plan_of(control, dp.position, from.scene.scale);
  dp.sensors = {control.sensor_period.value_or(from.scene.time.step), control.sensor_delay, control.position_noise,
                control.heading_noise_deg * k_deg, from.scene.seed};
  Vec3 added = added_mass_of_hull(parts);
  if (control.added_mass) added.head<2>() = *control.added_mass;
  if (control.added_inertia) added.z() = *control.added_inertia;
  const Vec3 damping(control.damping.x(), control.damping.y(), control.yaw_damping);
  const double mass = parts.vessel_model->mass.mass, turning = parts.vessel_model->mass.inertia(2, 2);
  dp.controller = {Vec3(mass, mass, turning) + added, damping, control.bandwidth, control.damping_ratio};
  dp.observer = {dp.controller.mass, damping,
                 control.observer_bandwidth.value_or(scene::ControlScene::k_observer_ratio * control.bandwidth),
                 control.wave_period};
  dp.filter_bandwidth = control.filter_bandwidth.value_or(control.bandwidth);
  dp.watch_circle = control.watch_circle;
  dp.most_offset = control.most_offset.value_or(hull_length(parts));
  dp.window = from.scene.output.statistics.value_or(std::array{dp.start, from.scene.time.end});
  if (control.wind_feed_forward) dp.known_load = wind_on_hull(parts);
  return dp;
}

}  // namespace

vessel::Thruster thruster_of(const scene::ThrusterScene& given, const ModuleSources& from) {
  vessel::Thruster thruster;
  thruster.name = given.name;
  thruster.kind = given.kind;
  thruster.at_V = given.at;
  thruster.most_ahead = given.max_thrust;
  thruster.most_astern = given.max_astern.value_or(given.max_thrust);
  thruster.lag = given.lag;
  if (given.rate) thruster.rate = *given.rate;
  thruster.turn_rate = given.turn_rate_deg * k_deg;
  for (std::size_t k = 0; k + 1 < given.forbidden_deg.size(); k += 2)
    thruster.forbidden.emplace_back(given.forbidden_deg[k] * k_deg, given.forbidden_deg[k + 1] * k_deg);
  thruster.power = given.power;
  thruster.loss = given.loss;
  thruster.free_speed = given.free_speed;
  if (!given.loss_table.empty())
    thruster.loss_over_speed = vessel::ThrustLoss::read(given.loss_table, from.scene.scale);
  thruster.fails_at = given.fails_at;
  thruster.rudder = {given.rudder_area,
                     given.rudder_span,
                     given.rudder_distance,
                     given.diameter,
                     given.rudder_limit_deg * k_deg,
                     from.parts.water ? from.parts.water->density : defaults::k_water_density};
  return thruster;
}

BuiltModule build_thrusters(const ModuleSources& from) {
  if (!from.scene.vessel || from.scene.vessel->thrusters.empty()) return {};
  vessel::ThrusterSettings settings;
  settings.thrusters = thrusters_of(from);
  for (const scene::ThrusterScene& given : from.scene.vessel->thrusters)
    settings.commands.push_back({given.thrust, given.angle_deg * k_deg});
  settings.com_V = from.parts.vessel_model->mass.com;
  settings.hull = from.parts.vessel_index;
  settings.start = from.scene.time.start;
  if (from.parts.water) settings.water_velocity = water_velocity(*from.parts.water);
  return {vessel::make_thrusters(settings, from.parts.commands),
          fmt::format("<vessel><thrusters>, {} of them", settings.thrusters.size())};
}

BuiltModule build_control(const ModuleSources& from) {
  if (!from.scene.vessel || !from.scene.vessel->control) return {};
  if (from.scene.vessel->control->mode == ControlMode::none) return {};
  const vessel::DpSettings settings = dp_settings(from);
  const Vec3& w = settings.controller.bandwidth;
  return {vessel::make_dp(settings, {thrusters_of(from), from.parts.vessel_model->mass.com}, from.parts.commands),
          fmt::format("<vessel><control mode=\"dp\">, bandwidth {:.3g} {:.3g} {:.3g} rad/s, samples every {:g} s{}",
                      w.x(), w.y(), w.z(), settings.sensors.period, settings.known_load ? ", wind cancelled" : "")};
}

}  // namespace nilas::sim
