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
       .built = false,
       .doc = "Breaking of ice. Absent: ice cannot break.",
       .attributes = {strength("flexural_strength", "4e4", "Flexural strength."),
                      strength("compressive_strength", "1e5", "Compressive strength."),
                      {.name = "fracture_toughness",
                       .unit = "Pa sqrt(m)",
                       .range = above(0),
                       .default_value = "3e3",
                       .doc = "Fracture toughness."},
                      {.name = "min_area",
                       .unit = "m^2",
                       .range = at_least(0),
                       .default_value = "2e-4",
                       .doc = "Pieces below this area are not broken further."},
                      {.name = "max_aspect",
                       .range = at_least(1),
                       .default_value = "8",
                       .doc = "Longest pieces that are kept."}}},
      {.name = "crushing",
       .parent = "fracture",
       .built = false,
       .doc = "Local crushing at a contact.",
       .attributes = {model("model", {"seed-limit", "pressure-area", "compliant"}, "Its model."),
                      {.name = "coefficient", .range = above(0), .default_value = "1e5", .doc = "Of the pressure."},
                      {.name = "exponent", .default_value = "-0.7", .doc = "Of the area."}}},
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
