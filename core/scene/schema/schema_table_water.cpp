#include "core/scene/schema/schema_table.h"

namespace nilas::schema_table {

static AttributeSpec velocity(const std::string& doc) {
  return {.name = "velocity", .min_count = 3, .max_count = 3, .unit = "m/s", .default_value = "0 0 0", .doc = doc};
}

static std::vector<ElementSpec> water() {
  return {
      {.name = "water",
       .parent = "scene",
       .doc = "Properties of the water. Absent: its defaults where <hydro> asks for buoyancy or drag, else no water.",
       .attributes =
           {{.name = "density",
             .unit = "kg/m^3",
             .range = above(0),
             .default_value = "1025",
             .doc = "Density of the water."},
            {.name = "level", .unit = "m", .default_value = "0", .doc = "Height of still water in the ground frame."}}},
      {.name = "current",
       .parent = "water",
       .doc = "A steady current.",
       .attributes = {velocity("Uniform current in the ground frame."),
                      {.name = "profile",
                       .type = ValueType::path,
                       .built = false,
                       .doc = "CSV file with columns z_m, u, v: current over depth."}}},
      {.name = "waves",
       .parent = "water",
       .built = false,
       .doc = "Waves.",
       .attributes =
           {{.name = "kind",
             .type = ValueType::choice,
             .choices = {"regular", "jonswap"},
             .default_value = "regular",
             .doc = "Regular waves or a JONSWAP spectrum."},
            {.name = "height",
             .unit = "m",
             .range = at_least(0),
             .required = true,
             .doc = "Height, or significant height."},
            {.name = "period", .unit = "s", .range = above(0), .required = true, .doc = "Period, or peak period."},
            {.name = "heading_deg",
             .unit = "deg",
             .default_value = "0",
             .doc = "Direction the waves run to, from X towards Y."}}},
  };
}

static std::vector<ElementSpec> hydro() {
  return {
      {.name = "hydro", .parent = "scene", .doc = "The hydrodynamic forces that are modelled: its children."},
      {.name = "buoyancy",
       .parent = "hydro",
       .doc = "Hydrostatic pressure integrated exactly over the wetted surface of hull, floes and bodies."},
      {.name = "drag",
       .parent = "hydro",
       .doc = "Drag on every wetted face, by the velocity relative to the current.",
       .attributes =
           {{.name = "form",
             .range = at_least(0),
             .default_value = "1",
             .doc = "Coefficient of form drag, on faces that meet the flow."},
            {.name = "skin", .range = at_least(0), .default_value = "0.005", .doc = "Coefficient of skin friction."}}},
      {.name = "added_mass",
       .parent = "hydro",
       .built = false,
       .doc = "Added mass by closed forms or from a hydrodynamic database.",
       .attributes =
           {{.name = "model",
             .type = ValueType::choice,
             .choices = {"strip", "disc", "database"},
             .required = true,
             .doc = "Closed form for strips or discs, or a database."},
            {.name = "file", .type = ValueType::path, .applies = {"model", {"database"}}, .doc = "The database."}}},
      {.name = "radiation",
       .parent = "hydro",
       .built = false,
       .doc = "Radiation forces; needs a database.",
       .attributes = {{.name = "model",
                       .type = ValueType::choice,
                       .choices = {"cummins"},
                       .default_value = "cummins",
                       .doc = "Cummins' equation."}}},
      {.name = "virtual_drag",
       .parent = "hydro",
       .doc = "F = coefficient (velocity - v) on each floe: what drives the pieces of the pre-sawn test.",
       .attributes = {{.name = "coefficient",
                       .unit = "N s/m",
                       .range = at_least(0),
                       .default_value = "0.1",
                       .doc = "The coefficient."},
                      velocity("Velocity the floes are driven to, in the ground frame.")}},
  };
}

static ElementSpec tank() {
  return {
      .name = "tank",
      .parent = "scene",
      .doc = "Walls around x 0..length, y -width/2..width/2. Absent: open water.",
      .attributes = {
          {.name = "length", .unit = "m", .range = above(0), .required = true, .doc = "Inside length, along X."},
          {.name = "width", .unit = "m", .range = above(0), .required = true, .doc = "Inside width, along Y."},
          {.name = "depth", .unit = "m", .range = above(0), .required = true, .doc = "Depth below still water."},
          {.name = "wall_thickness",
           .unit = "m",
           .range = above(0),
           .default_value = "0.2",
           .doc = "Thickness of walls and floor."},
          {.name = "floor", .type = ValueType::boolean, .default_value = "true", .doc = "Whether it has a floor."}}};
}

std::vector<ElementSpec> water_elements() {
  std::vector<ElementSpec> elements = water();
  for (auto& element : hydro()) elements.push_back(element);
  elements.push_back(tank());
  return elements;
}

}  // namespace nilas::schema_table
