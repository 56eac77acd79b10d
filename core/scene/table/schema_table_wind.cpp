#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

static ElementSpec wind() {
  const WindScene values;
  return {
      .name = "wind",
      .parent = "scene",
      .doc =
          "It lets the wind blow, on floes and on a vessel with <wind_area>. Other bodies feel none. If it is absent, "
          "the air has no effect.",
      .attributes = {
          {.name = "speed",
           .unit = "m/s",
           .range = at_least(0),
           .required = true,
           .doc = "It is the mean speed at 10 m above still water; with gusts or profile `log` the mean over an hour."},
          {.name = "direction_deg",
           .unit = "deg",
           .default_value = written(values.direction_deg),
           .doc = "The wind blows towards this direction, from X towards Y. A northerly wind of the weather forecast "
                  "blows towards the south."},
          {.name = "density",
           .unit = "kg/m^3",
           .range = above(0),
           .default_value = written(values.density),
           .doc = "It is the density of the air. At -20 degrees Celsius it is 1.39."},
          choice(
              "profile", values.profile,
              "It sets how the mean speed grows with height. The vessel takes the speed at the height of its lateral "
              "centroid; floes take that at 10 m, to which their drag coefficient refers."),
          {.name = "exponent",
           .range = at_least(0),
           .default_value = written(values.exponent),
           .applies = when("profile", WindProfileKind::power),
           .doc = "It is the exponent of the power law."},
          choice("gusts", values.gusts,
                 "It sets the gusts. They are the same at every place and height, and <seed> decides them."),
          {.name = "floe_drag",
           .range = at_least(0),
           .default_value = written(values.floe_drag),
           .doc = "It is the drag coefficient C of floes: each takes the force `density * C * area * w^2`, where w is "
                  "the wind at 10 m past the floe. With 0 the wind does not act on floes."}}};
}

static ElementSpec wind_area() {
  const WindAreaScene values;
  return {
      .name = "wind_area",
      .parent = "vessel",
      .doc =
          "It describes the vessel above the water, so that <wind> acts on it. The columns wind_* of vessel.csv hold "
          "the load.",
      .attributes = {
          choice("model", values.model, "It sets where the coefficients of the load come from."),
          [] {
            AttributeSpec type = choice<BlendermannShip>(
                "ship_type", "It is the kind of ship in Blendermann's table. The model `blendermann` needs it.");
            type.applies = when("model", WindAreaModel::blendermann);
            return type;
          }(),
          {.name = "file",
           .type = ValueType::path,
           .applies = when("model", WindAreaModel::coefficients),
           .scaled_file = true,
           .doc = "This CSV file has the columns angle_deg,cx,cy,cn. The angle of the relative wind goes from 0, wind "
                  "from ahead, to 180. cx refers to the frontal area and is positive forward; cy refers to the lateral "
                  "area and cn to that area times the length, both positive to the side to which the wind blows. The "
                  "model `coefficients` needs it."},
          {.name = "frontal",
           .unit = "m^2",
           .range = above(0),
           .required = true,
           .doc = "It is the area above the water as seen from ahead."},
          {.name = "lateral",
           .unit = "m^2",
           .range = above(0),
           .required = true,
           .doc = "It is the area above the water as seen from the side."},
          {.name = "length",
           .unit = "m",
           .range = above(0),
           .default_note = "the length of the hull",
           .doc = "It is the length over all, to which the yaw moment refers."},
          {.name = "midship",
           .unit = "m",
           .default_note = "the middle of the hull",
           .doc = "It is x of the midship section in V. The yaw moment of the coefficients is about this section."},
          {.name = "lateral_centroid",
           .unit = "m",
           .default_value = written(values.lateral_centroid),
           .doc = "The centroid of the lateral area lies this far ahead of the midship section."},
          {.name = "height",
           .unit = "m",
           .range = above(0),
           .default_note = "half of the lateral area over the length",
           .doc = "It is the height of that centroid above still water. Loads act there, and it decides the speed of "
                  "the wind and the heeling moment."}}};
}

static ElementSpec propeller_wash() {
  return {
      .name = "propeller_wash",
      .parent = "hydro",
      .doc =
          "Its child elements are the jets of water behind propellers and thrusters of the vessel. Floes and bodies "
          "feel them by <drag>; the vessel does not."};
}

static ElementSpec jet() {
  return {
      .name = "jet",
      .parent = "propeller_wash",
      .count = Count::many,
      .doc = "It is the jet of one propeller or thruster.",
      .attributes = {
          {.name = "thruster",
           .type = ValueType::name,
           .doc = "It names the propeller or thruster whose present thrust drives the jet. Without it the thrust is "
                  "constant."},
          {.name = "thrust",
           .unit = "N",
           .doc = "It is the constant thrust of a propeller that the scene does not model otherwise. Below 0 the jet "
                  "leaves to the other side. It excludes `thruster`."},
          {.name = "diameter",
           .unit = "m",
           .range = above(0),
           .required = true,
           .doc = "It is the diameter of the propeller."},
          {.name = "position",
           .min_count = 3,
           .max_count = 3,
           .unit = "m",
           .required = true,
           .doc = "It is the centre of the propeller, in V."},
          {.name = "direction",
           .min_count = 3,
           .max_count = 3,
           .default_note = "-1 0 0, and for a tunnel thruster 0 -1 0, against its thrust",
           .doc = "The jet leaves along this vector of V with positive thrust. Its length has no effect. An azimuth "
                  "sends its jet against its thrust instead, and a propeller with rudder against the force of both."}}};
}

std::vector<ElementSpec> wind_elements() { return {wind(), wind_area(), propeller_wash(), jet()}; }

}  // namespace nilas::scene::schema_table
