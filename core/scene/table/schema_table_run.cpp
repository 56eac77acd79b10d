#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

static ElementSpec scene() {
  return {.name = "scene",
          .count = Count::one,
          .doc = "This is the root element. What a scene does not name is not modelled.",
          .attributes = {{.name = "version",
                          .type = ValueType::choice,
                          .choices = {"1"},
                          .required = true,
                          .doc = "It gives the version of the scene format."},
                         {.name = "name",
                          .type = ValueType::name,
                          .default_note = "the file's name without its ending",
                          .doc = "The name appears in the outputs and in the name of the run folder."},
                         {.name = "scale",
                          .range = above(0),
                          .default_note = "1",
                          .doc = "It is the factor of lengths of a scene that was scaled by `nilas run --scale`, which "
                                 "writes it. It scales the files that the scene names, and the program's own small "
                                 "speeds and lengths. Attributes of the scene hold scaled values already."}}};
}

static ElementSpec time() {
  const TimeScene time;
  return {.name = "time",
          .parent = "scene",
          .always = true,
          .doc = "It sets the simulated time span and the time step.",
          .attributes = {{.name = "step",
                          .unit = "s",
                          .range = above(0),
                          .default_note = written(time.step) + " without a vessel or for a hull of " +
                                          written(defaults::k_hull_length) +
                                          " m. Other hulls scale it by Froude's law, rounded to 1, 2 or 5 times a "
                                          "power of ten.",
                          .doc = "It is the length of a time step."},
                         {.name = "start",
                          .unit = "s",
                          .default_value = written(time.start),
                          .doc = "It is the time of the initial state."},
                         {.name = "end",
                          .unit = "s",
                          .default_value = written(time.end),
                          .doc = "The run ends with the first step that reaches this time, which must be after the "
                                 "start."}}};
}

std::vector<ElementSpec> run_elements() {
  const Scene scene_values;
  /// Integers beyond 2^53 have no exact double, so a scene with a larger seed would not survive other XML tools.
  constexpr double k_max_seed = 9007199254740992.0;
  return {
      scene(),
      time(),
      {.name = "gravity",
       .parent = "scene",
       .always = true,
       .doc =
           "It sets the acceleration of gravity in the ground frame, whose Z axis points up. With buoyancy or drag it "
           "must point along -Z.",
       .attributes = {{.name = "value",
                       .min_count = 3,
                       .max_count = 3,
                       .unit = "m/s^2",
                       .default_value = written(scene_values.gravity),
                       .doc = "These are its three components; 0 0 0 is allowed."}}},
      {.name = "seed",
       .parent = "scene",
       .always = true,
       .doc = "All random numbers of the run derive from this seed. The same seed gives the same bits.",
       .attributes = {{.name = "value",
                       .type = ValueType::integer,
                       .range = within(0, k_max_seed),
                       .default_value = std::to_string(scene_values.seed),
                       .doc = "Any whole number is a valid seed."},
                      {.name = "twin",
                       .type = ValueType::integer,
                       .range = within(0, k_max_seed),
                       .default_value = std::to_string(scene_values.twin),
                       .doc =
                           "0 runs the scene itself. Any other number makes a perturbed run. It shifts each floe and "
                           "free body at the start by up to 1e-12 m in x and y. The difference between perturbed "
                           "runs shows how much of a result is due to chaos."}}},
  };
}

}  // namespace nilas::scene::schema_table
