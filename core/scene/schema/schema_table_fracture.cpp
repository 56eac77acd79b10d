#include "core/scene/schema/schema_table.h"

namespace nilas::schema_table {

static AttributeSpec strength(const std::string& name, const std::string& doc) {
  return {.name = name, .unit = "Pa", .range = above(0), .default_note = "that of the ice's preset", .doc = doc};
}

static AttributeSpec model(const std::string& name, std::vector<std::string> choices, const std::string& doc) {
  const std::string first = choices.front();
  return {.name = name, .type = ValueType::choice, .choices = std::move(choices), .default_value = first, .doc = doc};
}

std::vector<ElementSpec> fracture_elements() {
  return {
      {.name = "fracture",
       .parent = "scene",
       .doc = "Ice that breaks: strengths of the floes that are breakable, and as its children the ways in which they "
              "fail. Absent: ice cannot break.",
       .attributes =
           {strength("flexural_strength", "Flexural strength. No effect without <bending> or <splitting>."),
            strength("compressive_strength", "Compressive strength, of <crushing>."),
            {.name = "fracture_toughness",
             .unit = "Pa sqrt(m)",
             .range = above(0),
             .default_note = "that of the ice's preset",
             .doc = "Fracture toughness. No effect without <splitting>."},
            {.name = "min_area",
             .unit = "m^2",
             .range = at_least(0),
             .default_note = "that of the ice's preset",
             .doc = "Smallest area that breaking, or cutting out crushed ice, leaves a piece. No effect without "
                    "<bending>, "
                    "<splitting> or <crushing clear_volume>."},
            {.name = "small_pieces",
             .type = ValueType::choice,
             .choices = {"brash", "refuse"},
             .default_value = "brash",
             .doc =
                 "What becomes of smaller ones. brash: they leave the bodies, and their mass is told (brash_kg). "
                 "refuse: the floe is not cut where that would leave one. No effect without <bending>, <splitting> or "
                 "<crushing clear_volume>."},
            {.name = "max_aspect",
             .range = at_least(1),
             .default_value = "8",
             .doc = "Longest piece, by the sides of the smallest box around it, that splitting of model seed-geometric "
                    "leaves. No effect without <splitting>."}}},
      {.name = "crushing",
       .parent = "fracture",
       .doc = "Crushing of breakable floes where the vessel or a body presses on them. Absent: they are rigid there.",
       .attributes =
           {model("model", {"seed-limit", "pressure-area", "compliant"},
                  "seed-limit: the normal force is at most compressive strength times contact area at the step's "
                  "start. compliant: the same with the area's growth within the step taken implicitly. pressure-area: "
                  "so too, with the pressure coefficient * area^exponent, in the ratio of the floe's strength to "
                  "that of <fracture>."),
            {.name = "coefficient",
             .unit = "Pa m^(-2 exponent)",
             .range = above(0),
             .default_note = "that of the ice's preset",
             .applies = {"model", {"pressure-area"}},
             .doc = "Pressure on an area of 1 m^2."},
            {.name = "exponent",
             .range = within(-0.95, 1),
             .default_value = "-0.7",
             .applies = {"model", {"pressure-area"}},
             .doc = "Power of the contact area in the pressure: the force grows with the area to 1 + exponent."},
            {.name = "between_floes",
             .type = ValueType::boolean,
             .default_value = "false",
             .doc = "Breakable floes crush each other too, where the weaker ice gives way. Without it they are rigid "
                    "against each other."},
            {.name = "clear_volume",
             .unit = "m^3",
             .range = above(0),
             .doc = "Crushed ice is cut out of a floe once more than this stands inside hulls through the floe's whole "
                    "thickness; its mass is told (extruded_kg). A strip of a quarter of the thickness, of narrow "
                    "hulls an eighth of their width, stays along their surfaces. Absent: outlines stay as they are."}}},
      {.name = "bending",
       .parent = "fracture",
       .doc = "Failure of breakable floes in bending where the vessel or a body presses on their edge. Needs "
              "<hydro><buoyancy>. "
              "Absent: they do not bend.",
       .attributes =
           {model("model", {"nevel"},
                  "nevel: radial cracks when the edge of a half-infinite plate on water reaches the flexural strength, "
                  "then wedges of a narrow beam each, which break where their stress is largest."),
            {.name = "wedge_angle_deg",
             .unit = "deg",
             .range = within(5, 60),
             .default_value = "45",
             .doc = "Opening of the wedges between radial cracks; as many as span the ice in angles nearest to it."},
            {.name = "speed_slope",
             .unit = "s/m",
             .range = within(-10, 10),
             .default_value = "0",
             .doc = "By how much the breaking length grows with the speed at which the ice is pushed down, of itself: "
                    "-0.14 in Su, Riska and Moan (2010). It keeps a quarter of itself at least."}}},
      {.name = "splitting",
       .parent = "fracture",
       .doc = "Splitting of breakable floes by what the vessel or a body presses on their edge. Needs "
              "<hydro><buoyancy>. Absent: "
              "they do not split.",
       .attributes =
           {model("model", {"seed-geometric", "lefm"},
                  "seed-geometric: where the edge cracks radially, along the shortest chord in the load's direction "
                  "when that is longer than the breaking length in bending and shorter than `multiplier` times it. "
                  "lefm: where half the sum of the forces across that chord reaches what the floe's length, width and "
                  "fracture toughness bear."),
            {.name = "multiplier",
             .range = above(1),
             .default_value = "2.5",
             .applies = {"model", {"seed-geometric"}},
             .doc = "Longest chord that splits, in breaking lengths."}}},
      {.name = "cracks",
       .parent = "fracture",
       .doc = "Paths of the cracks of <bending> and <splitting>. Absent: straight.",
       .attributes =
           {model(
                "path", {"straight", "curved"},
                "straight: through ice as strong as that at the load. curved: where ice is weak, along <weak_line> and "
                "seams of <bond>, and by strengths that vary within floes: splitting cracks go where a kink releases "
                "most energy for the toughness there, wedges break where stress over strength is largest."),
            {.name = "segment_thicknesses",
             .range = within(0.1, 1000),
             .default_value = "2",
             .applies = {"path", {"curved"}},
             .doc =
                 "Longest segment of a curved splitting crack, in thicknesses of the ice: how far ahead it feels the "
                 "toughness."}}},
      {.name = "damage",
       .parent = "fracture",
       .doc = "Loads that the ice bears weaken it where they act, for <bending> and <splitting>: ice of damage D bears "
              "1 - D of its strength. Absent: the strength stays.",
       .attributes = {{.name = "exponent",
                       .range = within(1, 100),
                       .default_value = "13.5",
                       .doc = "m: a load of a share S of the strength adds S^m to the damage of its place."},
                      {.name = "endurance",
                       .range = within(0.01, 1),
                       .default_value = "0.6",
                       .doc = "Shares of the strength below it do no harm. A load counts once, from where it rises to "
                              "it until it falls below."}}},
  };
}

}  // namespace nilas::schema_table
