#include "core/scene/schema/schema_table.h"

namespace nilas::schema_table {

std::vector<ElementSpec> run_elements() {
  /// Integers beyond 2^53 have no exact double, so a scene with a larger seed would not survive other XML tools.
  constexpr double k_max_seed = 9007199254740992.0;
  return {
      {.name = "scene",
       .count = Count::one,
       .doc = "The root. What it does not name is not modelled.",
       .attributes = {{.name = "version",
                       .type = ValueType::choice,
                       .choices = {"1"},
                       .required = true,
                       .doc = "Version of the scene format."},
                      {.name = "name",
                       .type = ValueType::name,
                       .default_note = "the file's name without its ending",
                       .doc = "Name of the scene, used for the run folder and in the outputs."}}},
      {.name = "time",
       .parent = "scene",
       .always = true,
       .doc = "The span that is simulated and its step.",
       .attributes =
           {{.name = "step",
             .unit = "s",
             .range = above(0),
             .default_note =
                 "0.01; of a scene with a vessel by Froude's law from 0.01 s for a hull of 6 m, rounded to 1, "
                 "2 or 5 times a power of ten",
             .doc = "Length of a time step."},
            {.name = "start", .unit = "s", .default_value = "0", .doc = "Time of the initial state."},
            {.name = "end",
             .unit = "s",
             .default_value = "10",
             .doc = "Time at which the run ends, after the start: with the first step that reaches it."}}},
      {.name = "gravity",
       .parent = "scene",
       .always = true,
       .doc = "Acceleration of gravity in the ground frame (Z up). With water it must point along -Z.",
       .attributes = {{.name = "value",
                       .min_count = 3,
                       .max_count = 3,
                       .unit = "m/s^2",
                       .default_value = "0 0 -9.81",
                       .doc = "Its three components; 0 0 0 is allowed."}}},
      {.name = "seed",
       .parent = "scene",
       .always = true,
       .doc = "The one number from which every random stream of the run derives. Same seed, same bits.",
       .attributes = {{.name = "value",
                       .type = ValueType::integer,
                       .range = within(0, k_max_seed),
                       .default_value = "1",
                       .doc = "Any whole number."},
                      {.name = "twin",
                       .type = ValueType::integer,
                       .range = within(0, k_max_seed),
                       .default_value = "0",
                       .doc = "0: the scene itself. Another number: a twin, whose floes and free bodies start up to "
                              "1e-12 m aside in x and y, drawn by this number. How far twins part tells what of a "
                              "result is chaos."}}},
  };
}

}  // namespace nilas::schema_table
