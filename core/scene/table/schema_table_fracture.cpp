#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

static AttributeSpec of_ice(const std::string& name, const std::string& unit, const Range& range,
                            const std::string& doc) {
  return {.name = name, .unit = unit, .range = range, .default_note = "that of the ice's preset", .doc = doc};
}

static ElementSpec fracture() {
  const FractureScene values;
  return {.name = "fracture",
          .parent = "scene",
          .doc =
              "It lets breakable floes break. Its attributes are their strengths and its child elements the modes of "
              "failure. If it is absent, ice cannot break.",
          .attributes = {
              of_ice("flexural_strength", "Pa", above(0),
                     "It is the flexural strength. It has no effect without <bending> or <splitting>."),
              of_ice("compressive_strength", "Pa", above(0), "It is the compressive strength, used by <crushing>."),
              of_ice("fracture_toughness", "Pa sqrt(m)", above(0),
                     "It is the fracture toughness. It has no effect without <splitting>."),
              of_ice("min_area", "m^2", at_least(0),
                     "It is the smallest area of a piece that breaking, or removing crushed ice, may leave. It has no "
                     "effect without <bending>, <splitting> or <crushing clear_volume>."),
              choice("small_pieces", values.small_pieces,
                     "It sets what becomes of smaller pieces. It has no effect without <bending>, <splitting> or "
                     "<crushing clear_volume>."),
              {.name = "max_aspect",
               .range = at_least(1),
               .default_value = written(values.max_aspect),
               .doc = "It is the largest aspect ratio of a piece that splitting of model geometric may leave. It is "
                      "taken from the smallest box around the piece. It has no effect without <splitting>."}}};
}

static ElementSpec crushing() {
  const CrushingScene values;
  return {
      .name = "crushing",
      .parent = "fracture",
      .doc =
          "Breakable floes crush where the vessel or a body presses on them. If it is absent, they are rigid "
          "there.",
      .attributes = {
          choice("model", values.model, "It sets the pressure of crushing ice."),
          {.name = "coefficient",
           .unit = "Pa m^(-2 exponent)",
           .range = above(0),
           .default_note = "that of the ice's preset",
           .applies = when("model", CrushingModel::pressure_area),
           .doc = "It is the pressure on an area of 1 m^2."},
          {.name = "exponent",
           .range = within(-0.95, 1),
           .default_value = written(values.exponent),
           .applies = when("model", CrushingModel::pressure_area),
           .doc = "It is the exponent of the contact area in the pressure. The force grows with the area to the "
                  "power 1 + exponent."},
          {.name = "between_floes",
           .type = ValueType::boolean,
           .default_value = written(values.between_floes),
           .doc = "Breakable floes crush each other too, and the weaker ice yields. Otherwise they are rigid "
                  "against each other."},
          {.name = "clear_volume",
           .unit = "m^3",
           .range = above(0),
           .doc = "Crushed ice is removed from a floe once more than this volume lies inside hulls through the "
                  "floe's whole thickness. The outputs give its mass (extruded_kg). A strip along the hull stays: a "
                  "quarter of the thickness wide, for narrow hulls an eighth of their width. If it is absent, "
                  "outlines stay as they are."}}};
}

static ElementSpec bending() {
  const BendingScene values;
  return {.name = "bending",
          .parent = "fracture",
          .doc =
              "Breakable floes fail in bending where the vessel or a body presses on their edge. It needs "
              "<hydro><buoyancy>. If it is absent, they do not.",
          .attributes = {
              choice("model", values.model, "It sets the model of failure."),
              {.name = "wedge_angle_deg",
               .unit = "deg",
               .range = within(5, 60),
               .default_value = written(values.wedge_angle_deg),
               .doc = "It is the wanted angle of the wedges between radial cracks. The number of wedges is chosen so "
                      "that they span the ice at the nearest angle."},
              {.name = "speed_slope",
               .unit = "s/m",
               .range = within(-10, 10),
               .default_value = written(values.speed_slope),
               .doc = "It is the relative change of the breaking length per speed at which the ice is pushed down. "
                      "Negative values shorten the pieces. The length keeps at least a quarter of its value."}}};
}

static ElementSpec splitting() {
  const SplittingScene values;
  return {.name = "splitting",
          .parent = "fracture",
          .doc =
              "Breakable floes split under the vessel or a body that presses on their edge. It needs "
              "<hydro><buoyancy>. If it is absent, they do not.",
          .attributes = {choice("model", values.model, "It sets the criterion of splitting."),
                         {.name = "multiplier",
                          .range = above(1),
                          .default_value = written(values.multiplier),
                          .applies = when("model", SplittingModel::geometric),
                          .doc = "It is the longest chord that splits, in breaking lengths."}}};
}

static ElementSpec cracks() {
  const CracksScene values;
  return {.name = "cracks",
          .parent = "fracture",
          .doc = "It sets the paths of the cracks of <bending> and <splitting>. If it is absent, they are straight.",
          .attributes = {choice("path", values.path, "It sets the kind of path."),
                         {.name = "segment_thicknesses",
                          .range = within(0.1, 1000),
                          .default_value = written(values.segment_thicknesses),
                          .applies = when("path", CrackPathKind::curved),
                          .doc = "It is the longest segment of a curved splitting crack, in ice thicknesses. The crack "
                                 "sees the toughness this far ahead."}}};
}

static ElementSpec damage() {
  const DamageScene values;
  return {.name = "damage",
          .parent = "fracture",
          .doc =
              "Loads that the ice bears weaken it where they act, for <bending> and <splitting>. Ice of damage D has "
              "1 - D of its strength. If it is absent, the strength stays.",
          .attributes = {{.name = "exponent",
                          .range = within(1, 100),
                          .default_value = written(values.exponent),
                          .doc = "With exponent m, a load of a share S of the strength adds S^m to the damage of its "
                                 "place."},
                         {.name = "endurance",
                          .range = within(0.01, 1),
                          .default_value = written(values.endurance),
                          .doc = "Loads below this share of the strength do no damage. A load counts once, from where "
                                 "it exceeds the share until it falls below."}}};
}

std::vector<ElementSpec> fracture_elements() {
  return {fracture(), crushing(), bending(), splitting(), cracks(), damage()};
}

}  // namespace nilas::scene::schema_table
