#include "core/scene/read/build_remote_scene.h"
#include "core/scene/read/build_scene.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

static HullGenerateScene build_generate(const SceneElement& element) {
  HullGenerateScene generate;
  assign(generate.kind, element, "generate");
  for (const auto& attribute : element.attributes)
    if (attribute.name != "generate")
      if (const auto value = number_of(element, attribute.name)) generate.parameters[attribute.name] = *value;
  return generate;
}

static MassScene build_mass(const SceneElement& element) {
  MassScene mass;
  assign(mass.value, element, "value");
  assign(mass.draught, element, "draught");
  assign(mass.cog, element, "cog");
  assign(mass.inertia, element, "inertia");
  return mass;
}

static ForceBalanceScene build_balance(const SceneElement& element) {
  ForceBalanceScene balance;
  assign(balance.kind, element, "kind");
  assign(balance.stiffness, element, "stiffness");
  assign(balance.damping, element, "damping");
  assign(balance.layout, element, "layout");
  return balance;
}

static CarriageScene build_carriage(const SceneElement& element) {
  CarriageScene carriage;
  assign(carriage.speed, element, "speed");
  assign(carriage.heading_deg, element, "heading_deg");
  assign(carriage.ramp, element, "ramp");
  assign(carriage.ramp_shape, element, "ramp_shape");
  assign(carriage.joint, element, "joint");
  for (const auto& axis : words_of(element, "free"))
    carriage.free.at(static_cast<std::size_t>(choice_named<JointAxis>(axis))) = true;
  assign(carriage.start, element, "start");
  if (const auto* path = child_of(element, "path")) assign(carriage.path, *path, "file");
  if (const auto* balance = child_of(element, "force_balance")) carriage.balance = build_balance(*balance);
  return carriage;
}

static PartScene build_part(const SceneElement& element) {
  PartScene part;
  assign_solid(part, element);
  assign(part.joint, element, "joint");
  assign(part.to, element, "to");
  assign(part.at, element, "at");
  assign(part.axis, element, "axis");
  assign(part.stiffness, element, "stiffness");
  assign(part.damping, element, "damping");
  assign(part.rest_angle_deg, element, "rest_angle_deg");
  assign(part.angle_deg, element, "angle_deg");
  assign(part.rate_deg, element, "rate_deg");
  assign(part.rest_travel, element, "rest_travel");
  assign(part.travel, element, "travel");
  assign(part.speed, element, "speed");
  return part;
}

static RodScene build_rod(const SceneElement& element) {
  RodScene rod;
  rod.line = element.place.line;
  assign(rod.name, element, "name");
  assign(rod.on, element, "on");
  assign(rod.at, element, "at");
  assign(rod.to, element, "to");
  assign(rod.length, element, "length");
  return rod;
}

VesselScene build_vessel_scene(const SceneElement& element) {
  VesselScene vessel;
  assign(vessel.name, element, "name");
  assign(vessel.hull, element, "hull");
  if (const auto position = numbers_of(element, "position")) {
    vessel.position_has_z = position->size() == 3;
    vessel.position.head(static_cast<Eigen::Index>(position->size())) =
        VecX::Map(position->data(), static_cast<Eigen::Index>(position->size()));
  }
  assign(vessel.heading_deg, element, "heading_deg");
  assign(vessel.velocity, element, "velocity");
  assign(vessel.angular_velocity, element, "angular_velocity");
  vessel.fixed = child_of(element, "fixed") != nullptr;
  if (const auto* hull = child_of(element, "hull")) vessel.generate = build_generate(*hull);
  if (const auto* mass = child_of(element, "mass")) vessel.mass = build_mass(*mass);
  if (const auto* carriage = child_of(element, "carriage")) vessel.carriage = build_carriage(*carriage);
  if (const auto* area = child_of(element, "wind_area")) vessel.wind_area = build_wind_area(*area);
  if (const auto* manoeuvring = child_of(element, "manoeuvring"))
    vessel.manoeuvring = build_manoeuvring_scene(*manoeuvring);
  if (const auto* manoeuvre = child_of(element, "manoeuvre")) vessel.manoeuvre = build_manoeuvre_scene(*manoeuvre);
  if (const auto* mooring = child_of(element, "mooring")) vessel.mooring = build_mooring_scene(*mooring);
  if (const auto* remote = child_of(element, "remote_control"))
    vessel.remote_control = build_remote_control_scene(*remote);
  for (const auto& child : element.children) {
    if (child.name == "part") vessel.parts.push_back(build_part(child));
    if (child.name == "rod") vessel.rods.push_back(build_rod(child));
  }
  build_thrusters_scene(vessel, element);
  return vessel;
}

}  // namespace nilas::scene
