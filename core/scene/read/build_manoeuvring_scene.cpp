#include "core/scene/read/build_scene.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

ManoeuvringScene build_manoeuvring_scene(const SceneElement& element) {
  ManoeuvringScene manoeuvring;
  assign(manoeuvring.model, element, "model");
  manoeuvring.preset = choice_of<ManoeuvringPreset>(element, "preset");
  assign(manoeuvring.length, element, "length");
  assign(manoeuvring.file, element, "file");
  assign(manoeuvring.propulsion, element, "propulsion");
  assign(manoeuvring.midship, element, "midship");
  assign(manoeuvring.rudder_rate_deg_s, element, "rudder_rate_deg_s");
  assign(manoeuvring.max_rudder_deg, element, "max_rudder_deg");
  assign(manoeuvring.propeller, element, "propeller");
  assign(manoeuvring.propeller_rate, element, "propeller_rate");
  return manoeuvring;
}

ManoeuvreScene build_manoeuvre_scene(const SceneElement& element) {
  ManoeuvreScene manoeuvre;
  assign(manoeuvre.kind, element, "kind");
  assign(manoeuvre.start, element, "start");
  assign(manoeuvre.angle_deg, element, "angle_deg");
  assign(manoeuvre.heading_deg, element, "heading_deg");
  assign(manoeuvre.speed, element, "speed");
  assign(manoeuvre.file, element, "file");
  assign(manoeuvre.heading_gain, element, "heading_gain");
  assign(manoeuvre.yaw_rate_gain, element, "yaw_rate_gain");
  assign(manoeuvre.heading_time, element, "heading_time");
  assign(manoeuvre.speed_gain, element, "speed_gain");
  assign(manoeuvre.speed_time, element, "speed_time");
  return manoeuvre;
}

}  // namespace nilas::scene
