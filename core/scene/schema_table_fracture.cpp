#include "core/scene/schema_table.h"

namespace nilas::schema_table {

static AttributeSpec strength(const std::string& name, const std::string& value, const std::string& doc) {
  return {.name = name, .unit = "Pa", .range = above(0), .default_value = value, .doc = doc};
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
           {strength("flexural_strength", "4e4", "Flexural strength. No effect without <bending>."),
            strength("compressive_strength", "1e5", "Compressive strength, of <crushing>."),
            {.name = "fracture_toughness",
             .unit = "Pa sqrt(m)",
             .range = above(0),
             .default_value = "3e3",
             .doc = "Fracture toughness. No effect without <splitting>."},
            {.name = "min_area",
             .unit = "m^2",
             .range = at_least(0),
             .default_value = "2e-4",
             .doc = "Pieces below this area are not broken further. No effect without <bending> or <splitting>."},
            {.name = "max_aspect",
             .range = at_least(1),
             .default_value = "8",
             .doc = "Longest pieces that are kept. No effect without <bending> or <splitting>."}}},
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
             .default_value = "1e5",
             .applies = {"model", {"pressure-area"}},
             .doc = "Pressure on an area of 1 m^2."},
            {.name = "exponent",
             .range = within(-0.95, 1),
             .default_value = "-0.7",
             .applies = {"model", {"pressure-area"}},
             .doc = "Power of the contact area in the pressure: the force grows with the area to 1 + exponent."}}},
      {.name = "bending",
       .parent = "fracture",
       .built = false,
       .doc = "Failure in bending.",
       .attributes = {model("model", {"nevel"}, "Its model.")}},
      {.name = "splitting",
       .parent = "fracture",
       .built = false,
       .doc = "Splitting of floes.",
       .attributes = {model("model", {"seed-geometric", "lefm"}, "Its model."),
                      {.name = "multiplier", .range = above(0), .default_value = "2.5", .doc = "Of the criterion."}}},
      {.name = "cracks",
       .parent = "fracture",
       .built = false,
       .doc = "Paths of cracks.",
       .attributes = {model("path", {"straight", "curved"}, "Straight or curved.")}},
  };
}

}  // namespace nilas::schema_table
