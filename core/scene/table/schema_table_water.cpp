#include "core/scene/table/schema_table.h"

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
       .doc = "It adds a current. The uniform velocity, the profile and the series add up.",
       .attributes = {three("velocity", "m/s", "It is the uniform current in the ground frame."),
                      {.name = "profile",
                       .type = ValueType::path,
                       .scaled_file = true,
                       .doc = "This CSV file has the columns z_m,u_m_s,v_m_s and gives the current over depth. z_m is "
                              "the height above still water, negative below. It is linear between its rows and "
                              "constant beyond them."},
                      {.name = "series",
                       .type = ValueType::path,
                       .scaled_file = true,
                       .doc = "This CSV file has the columns t_s,u_m_s,v_m_s and gives the current over time. It is "
                              "linear between its rows, and stays as it is at its ends beyond them."}}},
      waves_element(),
  };
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
  elements.push_back(added_mass_element());
  elements.push_back(wave_loads_element());
  elements.push_back(database_element());
  elements.push_back({.name = "restoring",
                      .parent = "hydro",
                      .doc = "It takes the hydrostatics of the vessel from the <database>: linear in heave, roll and "
                             "pitch, in place of the pressure on its mesh by <buoyancy>."});
  elements.push_back(radiation_element());
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
