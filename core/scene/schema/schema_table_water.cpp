#include "core/scene/schema/schema_table.h"

namespace nilas::scene::schema_table {

static std::vector<ElementSpec> water() {
  const WaterScene values;
  return {
      {.name = "water",
       .parent = "scene",
       .doc = "It sets the properties of the water. If it is absent, there is no water, unless <hydro> has buoyancy or "
              "drag: then the defaults hold.",
       .attributes = {{.name = "density",
                       .unit = "kg/m^3",
                       .range = above(0),
                       .default_value = written(values.density),
                       .doc = "It is the density of the water."},
                      {.name = "level",
                       .unit = "m",
                       .default_value = written(values.level),
                       .doc = "It is the height of still water in the ground frame."}}},
      {.name = "current",
       .parent = "water",
       .doc = "It adds a steady current.",
       .attributes = {three("velocity", "m/s", "It is the uniform current in the ground frame."),
                      {.name = "profile",
                       .type = ValueType::path,
                       .built = false,
                       .doc = "This CSV file has the columns z_m, u, v and gives the current over depth."}}},
      {.name = "waves",
       .parent = "water",
       .built = false,
       .doc = "It adds waves.",
       .attributes = {{.name = "kind",
                       .type = ValueType::choice,
                       .choices = {"regular", "jonswap"},
                       .default_value = "regular",
                       .doc = "It selects regular waves or a JONSWAP spectrum."},
                      {.name = "height",
                       .unit = "m",
                       .range = at_least(0),
                       .required = true,
                       .doc = "It is the height, or the significant height."},
                      {.name = "period",
                       .unit = "s",
                       .range = above(0),
                       .required = true,
                       .doc = "It is the period, or the peak period."},
                      {.name = "heading_deg",
                       .unit = "deg",
                       .default_value = "0",
                       .doc = "It is the direction in which the waves travel, from X towards Y."}}},
  };
}

static std::vector<ElementSpec> models_not_built() {
  return {{.name = "added_mass",
           .parent = "hydro",
           .built = false,
           .doc = "It adds added mass, by closed forms or from a hydrodynamic database.",
           .attributes = {{.name = "model",
                           .type = ValueType::choice,
                           .choices = {"strip", "disc", "database"},
                           .required = true,
                           .doc = "It selects a closed form for strips or discs, or a database."},
                          {.name = "file",
                           .type = ValueType::path,
                           .applies = {"model", {"database"}},
                           .doc = "It names the database."}}},
          {.name = "radiation",
           .parent = "hydro",
           .built = false,
           .doc = "It adds radiation forces, which need a database.",
           .attributes = {{.name = "model",
                           .type = ValueType::choice,
                           .choices = {"cummins"},
                           .default_value = "cummins",
                           .doc = "It selects Cummins' equation."}}}};
}

static std::vector<ElementSpec> hydro() {
  const DragScene drag;
  const VirtualDragScene driving;
  std::vector<ElementSpec> elements{
      {.name = "hydro", .parent = "scene", .doc = "Its child elements are the hydrodynamic forces that are modelled."},
      {.name = "buoyancy",
       .parent = "hydro",
       .doc = "It integrates the hydrostatic pressure exactly over the wetted surface of hull, floes and bodies."},
      {.name = "drag",
       .parent = "hydro",
       .doc = "It adds drag on every wetted face, by the velocity relative to the current.",
       .attributes = {{.name = "form",
                       .range = at_least(0),
                       .default_value = written(drag.form),
                       .doc = "It is the coefficient of form drag, which acts on faces that meet the flow."},
                      {.name = "skin",
                       .range = at_least(0),
                       .default_value = written(drag.skin),
                       .doc = "It is the coefficient of skin friction."}}}};
  for (ElementSpec& element : models_not_built()) elements.push_back(std::move(element));
  elements.push_back(
      {.name = "virtual_drag",
       .parent = "hydro",
       .doc = "Each floe with velocity v takes the force F = coefficient (velocity - v), as in the pre-sawn test.",
       .attributes = {{.name = "coefficient",
                       .unit = "N s/m",
                       .range = at_least(0),
                       .default_value = written(driving.coefficient),
                       .doc = "It is the coefficient."},
                      three("velocity", "m/s", "The floes are driven to this velocity, in the ground frame.")}});
  return elements;
}

static ElementSpec tank() {
  const TankScene values;
  return {.name = "tank",
          .parent = "scene",
          .doc =
              "It adds walls around x from 0 to length and y from -width/2 to width/2. If it is absent, the water is "
              "open.",
          .attributes = {{.name = "length",
                          .unit = "m",
                          .range = above(0),
                          .required = true,
                          .doc = "It is the inside length, along X."},
                         {.name = "width",
                          .unit = "m",
                          .range = above(0),
                          .required = true,
                          .doc = "It is the inside width, along Y."},
                         {.name = "depth",
                          .unit = "m",
                          .range = above(0),
                          .required = true,
                          .doc = "It is the depth below still water."},
                         {.name = "wall_thickness",
                          .unit = "m",
                          .range = above(0),
                          .default_value = written(values.wall_thickness),
                          .doc = "It is the thickness of walls and floor."},
                         {.name = "floor",
                          .type = ValueType::boolean,
                          .default_value = written(values.floor),
                          .doc = "It says whether the tank has a floor."}}};
}

std::vector<ElementSpec> water_elements() {
  std::vector<ElementSpec> elements = water();
  for (auto& element : hydro()) elements.push_back(element);
  elements.push_back(tank());
  return elements;
}

}  // namespace nilas::scene::schema_table
