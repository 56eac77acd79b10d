#include "core/scene/elements/manoeuvring_scene.h"
#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

/// It has no default value: in the scene of a run folder, that would stand beside a preset, which does not take it.
static AttributeSpec propulsion() {
  AttributeSpec attribute = choice<PropulsionKind>("propulsion", "It selects what drives a ship from a file.");
  attribute.default_note = "open-water";
  return attribute;
}

static ElementSpec manoeuvring() {
  const ManoeuvringScene values;
  return {
      .name = "manoeuvring",
      .parent = "vessel",
      .doc =
          "A free vessel takes the forces of hull, propeller and rudder in surge, sway and yaw, by its motion through "
          "the water, with the added mass that belongs to them. <drag> then only damps heave, roll and pitch of the "
          "vessel. It needs a preset or a file.",
      .attributes = {
          choice("model", values.model, "It selects the model of the hull."),
          choice<ManoeuvringPreset>("preset", "It names a ship whose coefficients are built in."),
          {.name = "length",
           .unit = "m",
           .range = above(0),
           .default_note = "as published",
           .doc = "It scales the preset to this length between perpendiculars, by Froude's law."},
          {.name = "file",
           .type = ValueType::path,
           .scaled_file = true,
           .doc = "This CSV file with the columns name,value has the coefficients of a ship. The page on manoeuvring "
                  "lists the names."},
          propulsion(),
          {.name = "midship",
           .unit = "m",
           .default_note = "the middle of the hull's length",
           .doc = "It is x of the point amidships in V, to which the coefficients refer."},
          {.name = "rudder_rate_deg_s",
           .unit = "deg/s",
           .range = above(0),
           .default_value = written(values.rudder_rate_deg_s),
           .doc = "The rudder turns at this rate. The default suits full scale: a model of scale 1:N turns sqrt(N) "
                  "times as fast."},
          {.name = "max_rudder_deg",
           .unit = "deg",
           .range = {.min = 0, .max = 90, .min_inclusive = false},
           .default_value = written(values.max_rudder_deg),
           .doc = "It is the largest rudder angle."},
          {.name = "propeller",
           .unit = "1/s",
           .range = at_least(0),
           .default_note = "the rate that holds the vessel's initial speed",
           .doc = "It is the rate of revolutions of the propeller at the start."},
          {.name = "propeller_rate",
           .unit = "1/s^2",
           .range = above(0),
           .default_note = "the largest rate of revolutions within 2 sqrt(L/g)",
           .doc = "The rate of revolutions changes at most this fast."}}};
}

static std::vector<AttributeSpec> autopilot_gains() {
  const ManoeuvreScene values;
  const Condition applies = when("kind", ManoeuvreKind::course);
  return {{.name = "heading_gain",
           .range = at_least(0),
           .default_value = written(values.heading_gain),
           .applies = applies,
           .doc = "It is the rudder angle per angle of heading error."},
          {.name = "yaw_rate_gain",
           .unit = "s",
           .range = at_least(0),
           .default_note = "3 L/V",
           .applies = applies,
           .doc = "It is the rudder angle per yaw rate. V is the largest wanted speed."},
          {.name = "heading_time",
           .unit = "s",
           .range = above(0),
           .default_note = "50 L/V",
           .applies = applies,
           .doc = "In this time the integral of a steady heading error asks for as much rudder as the error itself."},
          {.name = "speed_gain",
           .range = at_least(0),
           .default_value = written(values.speed_gain),
           .applies = applies,
           .doc = "The propeller is driven as for the wanted speed plus this gain times the missing speed."},
          {.name = "speed_time",
           .unit = "s",
           .range = above(0),
           .default_note = "3 L/V",
           .applies = applies,
           .doc = "In this time the integral of a steady speed error asks for as much as the error itself."}};
}

static ElementSpec manoeuvre() {
  const ManoeuvreScene values;
  ElementSpec element{
      .name = "manoeuvre",
      .parent = "vessel",
      .doc =
          "It steers a vessel with <manoeuvring>, and measures what the manoeuvre is made for. The figures stand at "
          "the "
          "end of the run and in summary.json, beside the limits of IMO MSC.137(76).",
      .attributes = {
          choice("kind", values.kind, "It selects the manoeuvre."),
          {.name = "start",
           .unit = "s",
           .default_note = "the start of the scene",
           .doc = "The manoeuvre begins at this time. Until then the rudder is amidships."},
          {.name = "angle_deg",
           .unit = "deg",
           .range = within(-90, 90),
           .default_note =
               written(k_circle_rudder_deg) + " in a turning circle, " + written(k_zigzag_rudder_deg) + " in a zigzag",
           .applies = when("kind", ManoeuvreKind::turning_circle, ManoeuvreKind::zigzag),
           .doc = "It is the rudder angle, positive with the trailing edge to starboard, which turns the bow to "
                  "starboard."},
          {.name = "heading_deg",
           .unit = "deg",
           .default_note = "the size of the rudder angle in a zigzag, the vessel's own heading on a course",
           .applies = when("kind", ManoeuvreKind::zigzag, ManoeuvreKind::course),
           .doc = "In a zigzag it is the change of heading at which the rudder goes over. On a course it is the wanted "
                  "heading, from X towards Y."},
          {.name = "speed",
           .unit = "m/s",
           .range = at_least(0),
           .default_note = "the vessel's initial speed",
           .applies = when("kind", ManoeuvreKind::course),
           .doc = "It is the wanted speed ahead through the water."},
          {.name = "file",
           .type = ValueType::path,
           .applies = when("kind", ManoeuvreKind::course),
           .scaled_file = true,
           .doc = "This CSV file has the columns t_s,heading_deg,speed_m_s. Each row holds from its time on. It "
                  "replaces heading_deg and speed."}}};
  for (AttributeSpec& gain : autopilot_gains()) element.attributes.push_back(std::move(gain));
  return element;
}

std::vector<ElementSpec> manoeuvring_elements() { return {manoeuvring(), manoeuvre()}; }

}  // namespace nilas::scene::schema_table
