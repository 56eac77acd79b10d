#include "core/scene/elements/thruster_scene.h"
#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

/// An attribute of a propeller with rudder.
static AttributeSpec of_rudder(const std::string& name, const std::string& unit, const std::string& doc) {
  return {.name = name,
          .unit = unit,
          .range = above(0),
          .applies = when("kind", ThrusterKind::propeller_rudder),
          .doc = doc + " A propeller with rudder needs it."};
}

static std::string by_froude(const std::string& value, const std::string& power) {
  return value + " for a hull of " + written(ControlScene::k_length) + " m; other hulls scale it by (length / " +
         written(ControlScene::k_length) + " m)^" + power;
}

static std::vector<AttributeSpec> strength(const ThrusterScene& values) {
  return {{.name = "max_thrust",
           .unit = "N",
           .range = above(0),
           .required = true,
           .doc = "It is the largest thrust in the positive direction, at zero speed."},
          {.name = "max_astern",
           .unit = "N",
           .range = at_least(0),
           .default_note = "max_thrust",
           .doc = "It is the largest thrust in the opposite direction, as a positive number."},
          {.name = "power",
           .unit = "W",
           .range = above(0),
           .required = true,
           .doc = "It is the power at max_thrust. Other thrusts take power (T / max_thrust)^1.5. The allocation "
                  "prefers thrusters that need less power."},
          {.name = "lag",
           .unit = "s",
           .range = at_least(0),
           .default_note = by_froude(written(values.lag), "0.5"),
           .doc = "It is the time constant with which the thrust follows its command."},
          {.name = "rate",
           .unit = "N/s",
           .range = above(0),
           .default_note = "no limit",
           .doc = "It is the largest rate of the thrust."},
          {.name = "loss",
           .range = {.min = 0, .max = 1, .max_inclusive = false},
           .default_value = written(values.loss),
           .doc = "It is the share of the thrust that is lost to ventilation or ice. The control does not know it."},
          {.name = "free_speed",
           .unit = "m/s",
           .range = above(0),
           .default_note = "no loss with speed",
           .doc = "At this speed of advance through the water nothing is left of max_thrust, by the law of Juva and "
                  "Riska. It excludes loss_table."},
          {.name = "loss_table",
           .type = ValueType::path,
           .scaled_file = true,
           .doc = "This CSV file has the columns speed_m_s,thrust_share. They give the share of the thrust that "
                  "remains over the speed of advance. Speeds must rise, and shares must not."},
          {.name = "fails_at",
           .unit = "s",
           .default_note = "never",
           .doc = "From this time on the thruster gives nothing: a blackout. Control is told so at once."}};
}

static ElementSpec thruster() {
  const ThrusterScene values;
  AttributeSpec kind = choice<ThrusterKind>("kind", "It sets the kind of thruster.");
  kind.required = true;
  AttributeSpec at = three("at", "m", "It is the point where the thrust acts, in V.");
  at.required = true;
  at.default_value.clear();
  std::vector<AttributeSpec> attributes{
      {.name = "name", .type = ValueType::name, .required = true, .doc = "Columns and commands use this name."},
      kind,
      at};
  for (AttributeSpec& attribute : strength(values)) attributes.push_back(std::move(attribute));
  const Condition turns = when("kind", ThrusterKind::azimuth, ThrusterKind::propeller_rudder);
  attributes.insert(
      attributes.end(),
      {{.name = "thrust",
        .unit = "N",
        .default_value = written(values.thrust),
        .doc = "It is the command at the start, which stays where nothing controls the thruster."},
       {.name = "angle_deg",
        .unit = "deg",
        .default_value = written(values.angle_deg),
        .applies = turns,
        .doc = "It is the angle at the start, of the thrust or of the rudder."},
       {.name = "turn_rate_deg",
        .unit = "deg/s",
        .range = above(0),
        .default_note = by_froude(written(values.turn_rate_deg), "-0.5"),
        .applies = turns,
        .doc = "It is the largest rate of the angle."},
       {.name = "forbidden_deg",
        .min_count = 2,
        .max_count = k_any_count,
        .unit = "deg",
        .applies = when("kind", ThrusterKind::azimuth),
        .doc = "These are sectors, each from one angle to another with the angle rising, into which control lets no "
               "force on the vessel point. They must not overlap."},
       of_rudder("rudder_area", "m^2", "It is the lateral area of the rudder."),
       of_rudder("rudder_span", "m", "It is the height of the rudder."),
       of_rudder("rudder_distance", "m", "It is the distance from the propeller's plane to the rudder."),
       of_rudder("diameter", "m", "It is the diameter of the propeller."),
       {.name = "rudder_limit_deg",
        .unit = "deg",
        .range = {.min = 0, .max = 45, .min_inclusive = false},
        .default_value = written(values.rudder_limit_deg),
        .applies = when("kind", ThrusterKind::propeller_rudder),
        .doc = "It is the largest angle of the rudder. Stall is not modelled."}});
  return {.name = "thruster",
          .parent = "thrusters",
          .count = Count::many,
          .doc = "This is one thruster.",
          .attributes = std::move(attributes)};
}

/// An attribute of dynamic positioning with one number for each of surge, sway and yaw.
static AttributeSpec per_axis(const std::string& name, const std::string& unit, const Range& range,
                              const std::string& note, const std::string& doc) {
  return {.name = name,
          .min_count = 3,
          .max_count = 3,
          .unit = unit,
          .range = range,
          .default_note = note,
          .applies = when("mode", ControlMode::dp),
          .doc = doc};
}

static AttributeSpec of_dp(const std::string& name, const std::string& unit, const Range& range,
                           const std::string& note, const std::string& doc) {
  return {.name = name,
          .unit = unit,
          .range = range,
          .default_note = note,
          .applies = when("mode", ControlMode::dp),
          .doc = doc};
}

static AttributeSpec two(AttributeSpec attribute) {
  attribute.min_count = attribute.max_count = 2;
  return attribute;
}

static AttributeSpec with_default(AttributeSpec attribute, const std::string& value) {
  attribute.default_value = value;
  attribute.default_note.clear();
  return attribute;
}

static std::vector<AttributeSpec> goal() {
  const Condition dp = when("mode", ControlMode::dp);
  return {{.name = "setpoint",
           .min_count = 2,
           .max_count = 2,
           .unit = "m",
           .default_note = "the position at the start",
           .applies = dp,
           .doc = "It is the wanted position of the hull's centre of mass, in the ground frame."},
          {.name = "heading_deg",
           .unit = "deg",
           .default_note = "the heading at the start",
           .applies = dp,
           .doc = "It is the wanted heading, from X towards Y."},
          {.name = "path",
           .type = ValueType::path,
           .applies = dp,
           .scaled_file = true,
           .doc = "This CSV file has the columns t_s,x_m,y_m,heading_deg and replaces setpoint and heading_deg. "
                  "Between its rows the set-point moves along straight lines."}};
}

static ElementSpec control() {
  const ControlScene values;
  const Range any_positive = above(0);
  std::vector<AttributeSpec> attributes{choice("mode", values.mode, "It selects the control.")};
  for (AttributeSpec& attribute : goal()) attributes.push_back(std::move(attribute));
  AttributeSpec feed_forward = of_dp("wind_feed_forward", "", {}, "",
                                     "It says whether the load of <wind> is cancelled before it moves the vessel.");
  feed_forward.type = ValueType::boolean;
  attributes.insert(
      attributes.end(),
      {per_axis("bandwidth", "rad/s", any_positive, by_froude("0.1 0.1 0.2", "-0.5"),
                "It is the natural frequency of the closed loop in surge, sway and yaw, by which its poles are placed. "
                "Higher values hold closer and take more thrust. In ice they are chosen higher than in open water."),
       with_default(of_dp("damping_ratio", "", any_positive, "", "It is the damping ratio of the closed loop."),
                    written(values.damping_ratio)),
       per_axis("filter_bandwidth", "rad/s", any_positive, "bandwidth",
                "It is the frequency of the reference filter: lower values move more gently to a new set-point."),
       per_axis("observer_bandwidth", "rad/s", any_positive,
                written(ControlScene::k_observer_ratio) + " times bandwidth",
                "It is the frequency of the observer: higher values follow the ice load sooner and pass more noise."),
       of_dp("wave_period", "s", any_positive, "no wave filter",
             "The observer leaves motions of about this period to the waves. It slows the estimate down, so it is left "
             "out in ice."),
       two(of_dp("added_mass", "kg", at_least(0), "that of <added_mass> for the vessel, else 0",
                 "It is the added mass in surge and sway that the control counts with.")),
       of_dp("added_inertia", "kg m^2", at_least(0), "that of <added_mass> for the vessel, else 0",
             "It is the added mass in yaw that the control counts with."),
       with_default(two(of_dp("damping", "N s/m", at_least(0), "",
                              "It is the linear damping in surge and sway that the control counts with.")),
                    written(values.damping.x()) + " " + written(values.damping.y())),
       with_default(of_dp("yaw_damping", "N m s", at_least(0), "",
                          "It is the linear damping in yaw that the control counts with."),
                    written(values.yaw_damping)),
       with_default(feed_forward, written(values.wind_feed_forward)),
       of_dp("sensor_period", "s", any_positive, "the time step",
             "It is the time between samples, and between commands, at least the time step."),
       with_default(of_dp("sensor_delay", "s", at_least(0), "", "It is the age of a sample when it arrives."),
                    written(values.sensor_delay)),
       with_default(
           of_dp("position_noise", "m", at_least(0), "", "It is the standard deviation of the measured x and y."),
           written(values.position_noise)),
       with_default(
           of_dp("heading_noise_deg", "deg", at_least(0), "", "It is the standard deviation of the measured heading."),
           written(values.heading_noise_deg)),
       of_dp("watch_circle", "m", any_positive, "none",
             "The outputs count the time outside of a circle of this radius around the set-point."),
       of_dp("most_offset", "m", any_positive, "the length of the hull",
             "The run ends with an error where the vessel is further than this from its reference.")});
  return {.name = "control",
          .parent = "vessel",
          .doc = "This is automatic control of the thrusters of a free vessel.",
          .attributes = std::move(attributes)};
}

std::vector<ElementSpec> thruster_elements() {
  return {{.name = "thrusters", .parent = "vessel", .doc = "Its child elements are the thrusters of a free vessel."},
          thruster(),
          control()};
}

ElementSpec remote_control_element() {
  const RemoteControlScene values;
  return {
      .name = "remote_control",
      .parent = "vessel",
      .doc =
          "Another program controls the free vessel: once per step it reads the motion and sets rudders, propellers "
          "and thrusters, over a local socket (docs/howto/control-from-outside.md).",
      .attributes = {
          {.name = "socket",
           .type = ValueType::text,
           .required = true,
           .doc = "It is the path of the socket's file, of at most 107 bytes, relative to the working directory. "
                  "The run makes the file and removes it at its end."},
          {.name = "timeout",
           .unit = "s",
           .range = {.min = 0, .max = 86400, .min_inclusive = false},
           .default_value = written(values.timeout),
           .scaled = false,
           .doc = "The run waits this long for the other program to connect, and for each of its answers. Then it "
                  "ends with an error. It is wall time."},
          {.name = "force",
           .type = ValueType::boolean,
           .default_value = written(values.force),
           .doc = "It adds the commands force_x, force_y and moment_z, which act on the vessel at its centre of "
                  "mass in its own axes."}}};
}

}  // namespace nilas::scene::schema_table
