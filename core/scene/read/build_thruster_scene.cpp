#include "core/scene/read/build_scene.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

/// Sets the target to an attribute of two numbers.
static void assign_two(Vec2& target, const SceneElement& element, const std::string& attribute) {
  if (const auto numbers = numbers_of(element, attribute)) target = {numbers->at(0), numbers->at(1)};
}
static void assign_two(std::optional<Vec2>& target, const SceneElement& element, const std::string& attribute) {
  if (numbers_of(element, attribute)) assign_two(target.emplace(), element, attribute);
}

static ThrusterScene build_thruster(const SceneElement& element) {
  ThrusterScene thruster;
  thruster.line = element.place.line;
  assign(thruster.name, element, "name");
  assign(thruster.kind, element, "kind");
  assign(thruster.at, element, "at");
  assign(thruster.max_thrust, element, "max_thrust");
  assign(thruster.max_astern, element, "max_astern");
  assign(thruster.power, element, "power");
  assign(thruster.lag, element, "lag");
  assign(thruster.rate, element, "rate");
  assign(thruster.turn_rate_deg, element, "turn_rate_deg");
  thruster.forbidden_deg = numbers_of(element, "forbidden_deg").value_or(std::vector<double>{});
  assign(thruster.loss, element, "loss");
  assign(thruster.free_speed, element, "free_speed");
  assign(thruster.loss_table, element, "loss_table");
  assign(thruster.fails_at, element, "fails_at");
  assign(thruster.thrust, element, "thrust");
  assign(thruster.angle_deg, element, "angle_deg");
  assign(thruster.rudder_area, element, "rudder_area");
  assign(thruster.rudder_span, element, "rudder_span");
  assign(thruster.rudder_distance, element, "rudder_distance");
  assign(thruster.diameter, element, "diameter");
  assign(thruster.rudder_limit_deg, element, "rudder_limit_deg");
  return thruster;
}

static ControlScene build_control(const SceneElement& element) {
  ControlScene control;
  assign(control.mode, element, "mode");
  assign_two(control.setpoint, element, "setpoint");
  assign(control.heading_deg, element, "heading_deg");
  assign(control.path, element, "path");
  assign(control.bandwidth, element, "bandwidth");
  assign(control.damping_ratio, element, "damping_ratio");
  assign(control.filter_bandwidth, element, "filter_bandwidth");
  assign(control.observer_bandwidth, element, "observer_bandwidth");
  assign(control.wave_period, element, "wave_period");
  assign_two(control.added_mass, element, "added_mass");
  assign(control.added_inertia, element, "added_inertia");
  assign_two(control.damping, element, "damping");
  assign(control.yaw_damping, element, "yaw_damping");
  assign(control.wind_feed_forward, element, "wind_feed_forward");
  assign(control.sensor_period, element, "sensor_period");
  assign(control.sensor_delay, element, "sensor_delay");
  assign(control.position_noise, element, "position_noise");
  assign(control.heading_noise_deg, element, "heading_noise_deg");
  assign(control.watch_circle, element, "watch_circle");
  assign(control.most_offset, element, "most_offset");
  return control;
}

void build_thrusters_scene(VesselScene& scene, const SceneElement& vessel) {
  if (const SceneElement* thrusters = child_of(vessel, "thrusters"))
    for (const auto& child : thrusters->children) scene.thrusters.push_back(build_thruster(child));
  if (const SceneElement* control = child_of(vessel, "control")) scene.control = build_control(*control);
}

}  // namespace nilas::scene
