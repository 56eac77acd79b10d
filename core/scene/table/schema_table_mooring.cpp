#include "core/scene/elements/mooring_scene.h"
#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

static AttributeSpec needed_point(const std::string& name, const std::string& doc) {
  return {.name = name, .min_count = 3, .max_count = 3, .unit = "m", .required = true, .doc = doc};
}

static ElementSpec mooring() {
  const MooringScene values;
  AttributeSpec start = choice("start", values.start, "It sets how the vessel starts.");
  start.applies = when("model", MooringKind::quasi_static);
  return {.name = "mooring",
          .parent = "vessel",
          .doc = "Mooring lines hold the vessel, which must be free: without <carriage> and <fixed>.",
          .attributes = {
              choice("model", values.model, "It sets the model of the lines."),
              start,
              {.name = "depth",
               .unit = "m",
               .range = above(0),
               .default_note = "the depth of a <tank> with a floor; otherwise the lines meet no bed",
               .applies = when("model", MooringKind::quasi_static),
               .doc = "It is the depth of the level sea bed below still water. No anchor may lie below the bed."},
              {.name = "file",
               .type = ValueType::path,
               .doc = "Quasi-static: this XML file has <mooring> as its root. Its attributes and children are read as "
                      "if they stood here; what the scene gives here goes first. Paths in it are relative to its own "
                      "folder. MoorDyn: this is its input file. Coupled points are fairleads in V, fixed points are in "
                      "the ground frame with heights from still water."}}};
}

/// Attributes before and behind those that only one kind of line has.
static std::vector<AttributeSpec> places_of_line() {
  return {{.name = "name",
           .type = ValueType::name,
           .required = true,
           .doc = "The name must differ from that of the other lines. The column line_<name>_tension_N has it."},
          needed_point("fairlead", "It is the line's end on the vessel, in V."),
          needed_point("anchor", "It is the line's fixed end, in the ground frame."),
          {.name = "length",
           .unit = "m",
           .range = above(0),
           .required = true,
           .doc = "It is the length of the line without tension."}};
}
static std::vector<AttributeSpec> loads_of_line() {
  const MooringLineScene values;
  return {{.name = "damping",
           .unit = "N s/m",
           .range = at_least(0),
           .default_value = written(values.damping),
           .doc = "The tension grows by this times the speed at which the fairlead draws the line out, and falls as "
                  "much the other way. It does not fall below zero."},
          {.name = "break_load",
           .unit = "N",
           .range = above(0),
           .default_note = "the line does not break",
           .doc = "The line breaks where its tension reaches this."},
          {.name = "break_time",
           .unit = "s",
           .default_note = "the line does not break",
           .doc = "The line breaks at this time, as in a test of redundancy."},
          {.name = "turret",
           .type = ValueType::boolean,
           .default_value = written(values.turret),
           .doc = "With `true` the fairlead is on the <turret>. Its place is that before the turret turns."}};
}

static ElementSpec line() {
  const CatenaryScene values;
  ElementSpec element{.name = "line",
                      .parent = "mooring",
                      .count = Count::many,
                      .doc =
                          "This is a uniform elastic line that hangs as a catenary and may lie on the sea bed, such as "
                          "a chain or a wire.",
                      .attributes = places_of_line()};
  element.attributes.push_back({.name = "weight",
                                .unit = "N/m",
                                .required = true,
                                .doc = "It is the weight in water per length; a buoyant line has a negative one."});
  element.attributes.push_back({.name = "stiffness",
                                .unit = "N",
                                .range = above(0),
                                .required = true,
                                .doc = "It is the axial stiffness EA: the tension divided by the strain."});
  element.attributes.push_back({.name = "bed_friction",
                                .range = at_least(0),
                                .default_value = written(values.bed_friction),
                                .doc = "It is the Coulomb coefficient between line and bed. It lowers the tension at "
                                       "the anchor. A line whose anchor is above the bed takes none."});
  element.attributes.push_back({.name = "diameter",
                                .unit = "m",
                                .range = at_least(0),
                                .default_value = written(values.diameter),
                                .doc = "On the bed the axis of the line lies half of it above the bed, and so does the "
                                       "line's end at an anchor that is lower. It has no other effect."});
  for (AttributeSpec& load : loads_of_line()) element.attributes.push_back(std::move(load));
  return element;
}

static ElementSpec spring_line() {
  ElementSpec element{.name = "spring_line",
                      .parent = "mooring",
                      .count = Count::many,
                      .doc =
                          "This is a weightless line, straight between its ends. Its tension follows from its stretch, "
                          "the distance of its ends minus its length. It needs a stiffness or a table.",
                      .attributes = places_of_line()};
  element.attributes.push_back({.name = "stiffness",
                                .unit = "N/m",
                                .range = above(0),
                                .doc = "It is the tension per stretch. A slack line has no tension."});
  element.attributes.push_back({.name = "knee",
                                .unit = "m",
                                .range = above(0),
                                .default_note = "none",
                                .doc = "Beyond this stretch `second_stiffness` holds."});
  element.attributes.push_back({.name = "second_stiffness",
                                .unit = "N/m",
                                .range = at_least(0),
                                .default_note = "none",
                                .doc = "It is the tension per stretch beyond the knee."});
  element.attributes.push_back({.name = "table",
                                .type = ValueType::path,
                                .scaled_file = true,
                                .doc = "This CSV file has the columns stretch_m,tension_N. The tension is linear "
                                       "between its rows, zero before the first, and goes on behind the last."});
  for (AttributeSpec& load : loads_of_line()) element.attributes.push_back(std::move(load));
  return element;
}

static ElementSpec turret() {
  const TurretScene values;
  return {.name = "turret",
          .parent = "mooring",
          .doc =
              "The turret turns about the vessel's z axis and has no inertia. Lines with turret=\"true\" end on it, so "
              "that the vessel can turn to wind and ice while the lines keep their places.",
          .attributes = {needed_point("at", "It is the centre of the turret, in V."),
                         {.name = "friction",
                          .unit = "N m",
                          .range = at_least(0),
                          .default_value = written(values.friction),
                          .doc = "The turret turns only where the moment of its lines is greater."}}};
}

std::vector<ElementSpec> mooring_elements() { return {mooring(), line(), spring_line(), turret()}; }

}  // namespace nilas::scene::schema_table
