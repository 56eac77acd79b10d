#include "core/scene/elements/database_scene.h"
#include "core/scene/elements/radiation_scene.h"
#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

/// A positive property of the computation that a WAMIT file does not state.
static AttributeSpec of_computation(const std::string& name, const std::string& unit, const std::string& note,
                                    const std::string& doc) {
  return {.name = name, .unit = unit, .range = above(0), .default_note = note, .doc = doc};
}

static AttributeSpec point(const std::string& name, const std::string& note, const std::string& doc) {
  return {.name = name, .min_count = 3, .max_count = 3, .unit = "m", .default_note = note, .doc = doc};
}

ElementSpec database_element() {
  const DatabaseScene values;
  return {.name = "database",
          .parent = "hydro",
          .doc =
              "It names the hydrodynamic database of the vessel. Other elements say what is taken from it. "
              "`nilas hydro` prints and checks its content.",
          .attributes = {
              {.name = "file",
               .type = ValueType::path,
               .required = true,
               .scaled_file = true,
               .doc = "It is one of WAMIT's result files, such as .1, with which all others of the same name are "
                      "read; or the HDF5 file of BEMIO; or the NetCDF file of Capytaine."},
              of_computation("length", "m", "none; WAMIT needs one",
                             "It is the length ULEN by which the results of WAMIT are divided."),
              of_computation("density", "kg/m^3", "that of the file; WAMIT needs one",
                             "It is the density of the water in the computation."),
              of_computation("gravity", "m/s^2", "that of the file; WAMIT needs one",
                             "It is the acceleration of gravity in the computation."),
              of_computation("depth", "m", "that of the file; else infinite",
                             "It is the depth of the water in the computation. It goes before that of the file."),
              point("reference", "that of the file; else the origin of its frame",
                    "It is the point to which the file's rotations and moments refer, in the frame D of the "
                    "database. This is XBODY of WAMIT and the centre of rotation of Capytaine."),
              point("origin", "above or below the origin of V, at the still water when the run starts",
                    "It is the origin of frame D in V. The plane z = 0 of D is the still water."),
              {.name = "rotation_deg",
               .unit = "deg",
               .default_value = written(values.rotation_deg),
               .doc = "It turns the axis X of frame D about the vertical, from x of V towards y. It is 180 where the "
                      "database has its bow at negative X."}}};
}

ElementSpec radiation_element() {
  const RadiationScene values;
  constexpr int k_most_poles = 24;
  return {.name = "radiation",
          .parent = "hydro",
          .doc =
              "It adds the load of the waves that the vessel's own motion makes, from the damping in the <database>. "
              "Its part at infinite frequency is the added mass, so <added_mass vessel=\"database\"> must be there.",
          .attributes = {choice("model", values.model, "It selects the form of the memory of these waves."),
                         {.name = "error",
                          .range = inside(0, 1),
                          .default_value = written(values.error),
                          .applies = when("model", RadiationModel::state_space),
                          .doc = "It is the allowed root-mean-square error of the fit, as a share of the damping. The "
                                 "fewest poles that reach it are taken."},
                         {.name = "order",
                          .type = ValueType::integer,
                          .range = within(2, k_most_poles),
                          .default_note = "the fewest for the error",
                          .applies = when("model", RadiationModel::state_space),
                          .doc = "It is the number of poles of each group of modes that couple with each other. It "
                                 "goes before the error."},
                         {.name = "memory",
                          .unit = "s",
                          .range = above(0),
                          .default_note = "until 0.1 % of the retardation functions is left",
                          .applies = when("model", RadiationModel::convolution),
                          .doc = "Motion that is older counts as steady."},
                         {.name = "highest_frequency",
                          .unit = "rad/s",
                          .range = above(0),
                          .default_note = "the last before damping that is low turns negative",
                          .doc = "Damping above this frequency is not used. Set it where the panels of the computation "
                                 "do not resolve shorter waves."}}};
}

}  // namespace nilas::scene::schema_table
