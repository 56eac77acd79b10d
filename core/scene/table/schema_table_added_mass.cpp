#include "core/scene/elements/added_mass_scene.h"
#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

ElementSpec added_mass_element() {
  const AddedMassScene values;
  constexpr int k_diagonal = 6, k_whole = 36;
  return {
      .name = "added_mass",
      .parent = "hydro",
      .doc = "It adds the water that moves with floes and vessel. Contacts feel it as well as the motion does.",
      .attributes = {
          choice("floes", values.floes, "It selects the closed form for floes."),
          choice("vessel", values.vessel, "It says where the added mass of the vessel comes from."),
          {.name = "matrix",
           .min_count = k_diagonal,
           .max_count = k_whole,
           .unit = "kg, kg m, kg m^2",
           .applies = when("vessel", VesselAddedMass::matrix),
           .scaled = false,
           .doc = "It is the added mass of the vessel in surge, sway, heave, roll, pitch and yaw, in the "
                  "axes of V: the six entries of the diagonal, or all 36, row by row. With --scale, the numbers stay "
                  "those of the unscaled vessel."},
          {.name = "at",
           .min_count = 3,
           .max_count = 3,
           .unit = "m",
           .default_note = "the centre of mass",
           .applies = when("vessel", VesselAddedMass::matrix),
           .doc = "It is the point in V to which the matrix refers."}}};
}

}  // namespace nilas::scene::schema_table
