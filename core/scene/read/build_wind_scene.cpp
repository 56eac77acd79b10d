#include "core/scene/read/build_scene.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

CurrentScene build_current(const SceneElement& element) {
  CurrentScene current;
  assign(current.velocity, element, "velocity");
  assign(current.profile, element, "profile");
  assign(current.series, element, "series");
  return current;
}

WindScene build_wind(const SceneElement& element) {
  WindScene wind;
  assign(wind.speed, element, "speed");
  assign(wind.direction_deg, element, "direction_deg");
  assign(wind.density, element, "density");
  assign(wind.profile, element, "profile");
  assign(wind.exponent, element, "exponent");
  assign(wind.gusts, element, "gusts");
  assign(wind.floe_drag, element, "floe_drag");
  return wind;
}

WindAreaScene build_wind_area(const SceneElement& element) {
  WindAreaScene area;
  assign(area.model, element, "model");
  assign(area.ship_type, element, "ship_type");
  assign(area.file, element, "file");
  assign(area.frontal, element, "frontal");
  assign(area.lateral, element, "lateral");
  assign(area.length, element, "length");
  assign(area.midship, element, "midship");
  assign(area.lateral_centroid, element, "lateral_centroid");
  assign(area.height, element, "height");
  return area;
}

JetScene build_jet(const SceneElement& element) {
  JetScene jet;
  jet.line = element.place.line;
  assign(jet.thruster, element, "thruster");
  assign(jet.thrust, element, "thrust");
  assign(jet.diameter, element, "diameter");
  assign(jet.position, element, "position");
  assign(jet.direction, element, "direction");
  return jet;
}

}  // namespace nilas::scene
