#include "core/scene/schema/schema_table.h"

namespace nilas::schema_table {

static ElementSpec output() {
  return {.name = "output",
          .parent = "scene",
          .always = true,
          .doc = "What a run leaves.",
          .attributes = {{.name = "folder",
                          .type = ValueType::text,
                          .default_note = "runs/, the scene's name and the time",
                          .doc = "The run folder, relative to the working directory; --out wins."},
                         {.name = "trajectory_every",
                          .unit = "s",
                          .range = at_least(0),
                          .default_value = "0.1",
                          .doc = "Between stored states of all bodies; 0: none."},
                         {.name = "tank_walls",
                          .type = ValueType::boolean,
                          .default_value = "false",
                          .doc = "Whether trajectory.pvd shows the walls and floor of the tank, which hide what is "
                                 "behind them."},
                         {.name = "contacts",
                          .type = ValueType::choice,
                          .choices = {"hull", "all", "none"},
                          .default_value = "hull",
                          .doc = "Which contacts are stored in contacts.h5 and shown in trajectory.pvd: those of the "
                                 "vessel and of fixed bodies, of all bodies (not with integrator reference, which "
                                 "then stores those of the vessel alone), or none."},
                         {.name = "problems",
                          .type = ValueType::choice,
                          .choices = {"never", "worst", "failed", "every"},
                          .default_value = "never",
                          .doc = "Which contact problems are stored, in FCLIB form with the impulses used, in the "
                                 "folder problems: none, the one with the largest residual so far, those whose solver "
                                 "missed its tolerance, or every step's."},
                         {.name = "checkpoint_every",
                          .unit = "s",
                          .range = at_least(0),
                          .default_value = "0",
                          .doc = "Simulated time between checkpoints, from which `nilas run --resume` goes on; 0: "
                                 "none."},
                         {.name = "statistics",
                          .min_count = 2,
                          .max_count = 2,
                          .unit = "s",
                          .default_note = "from the end of the carriage's ramp and the first contact with ice, "
                                          "whichever is later, to the end of the run",
                          .doc = "From when to when means, deviations and peaks of loads are taken; "
                                 "`nilas run --statistics FROM:TO` sets it."},
                         {.name = "peak_filter",
                          .unit = "s",
                          .range = above(0),
                          .default_note = "0.2 s for a hull of 100 m, times the root of length / 100 m for others",
                          .doc = "Peaks are also told of the load averaged over this time: they hardly depend on the "
                                 "time step."},
                         {.name = "bodies",
                          .type = ValueType::boolean,
                          .default_note = "true up to 200 bodies",
                          .doc = "Whether bodies.csv is written."}}};
}

static ElementSpec view() {
  const auto degrees = [](const std::string& name, const Range& range, const std::string& value,
                          const std::string& doc) {
    return AttributeSpec{.name = name, .unit = "deg", .range = range, .default_value = value, .doc = doc};
  };
  return {
      .name = "view",
      .parent = "scene",
      .remark = "this version has no viewer, so the element has no effect",
      .doc = "The first view of the scene in pictures; no effect on the run.",
      .attributes = {
          degrees("camera_elevation_deg", within(-90, 90), "25", "Of the camera above the horizon."),
          degrees("camera_heading_deg", {}, "200", "Direction the camera looks along."),
          {.name = "camera_distance", .unit = "m", .range = above(0), .default_value = "12", .doc = "From the target."},
          {.name = "target",
           .min_count = 3,
           .max_count = 3,
           .unit = "m",
           .default_value = "0 0 0",
           .doc = "Point the camera looks at."},
          {.name = "mesh",
           .type = ValueType::choice,
           .choices = {"collision", "fluid"},
           .default_value = "fluid",
           .doc = "Which mesh of the hull is drawn."},
          {.name = "wireframe", .type = ValueType::boolean, .default_value = "false", .doc = "Draw edges only."},
          {.name = "normals", .type = ValueType::boolean, .default_value = "false", .doc = "Draw face normals."}}};
}

static ElementSpec input() {
  return {.name = "input",
          .parent = "scene",
          .count = Count::many,
          .doc = "An input file of the scene as run, which must still be the same. Written by the program.",
          .attributes = {{.name = "file", .type = ValueType::path, .required = true, .doc = "The file."},
                         {.name = "sha256",
                          .type = ValueType::words,
                          .required = true,
                          .doc = "SHA-256 of its content, in hexadecimal digits."}}};
}

std::vector<ElementSpec> output_elements() { return {output(), view(), input()}; }

}  // namespace nilas::schema_table
