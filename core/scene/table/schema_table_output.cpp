#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

static std::vector<AttributeSpec> stored_states() {
  const OutputScene values;
  return {{.name = "folder",
           .type = ValueType::text,
           .default_note = "runs/, the scene's name and the time",
           .doc = "It is the run folder, relative to the working directory. The flag --out wins."},
          {.name = "trajectory_every",
           .unit = "s",
           .range = at_least(0),
           .default_value = written(values.trajectory_every),
           .doc = "The states of all bodies are stored at this interval; 0 stores none."},
          {.name = "tank_walls",
           .type = ValueType::boolean,
           .default_value = written(values.tank_walls),
           .doc = "It says whether trajectory.pvd shows the tank's walls and floor, which hide what is behind them."},
          choice("contacts", values.contacts, "It sets which contacts contacts.h5 stores and trajectory.pvd shows."),
          choice("problems", values.problems,
                 "It sets which contact problems are stored in the folder problems. They are in FCLIB form with the "
                 "impulses used."),
          {.name = "checkpoint_every",
           .unit = "s",
           .range = at_least(0),
           .default_value = written(values.checkpoint_every),
           .doc = "Checkpoints are written at this interval of simulated time; 0 writes none. `nilas run --resume` "
                  "continues from them."}};
}

static std::vector<AttributeSpec> statistics() {
  return {{.name = "statistics",
           .min_count = 2,
           .max_count = 2,
           .unit = "s",
           .default_note = "from the end of the carriage's ramp or the first contact with ice, whichever is later, to "
                           "the end of the run",
           .doc = "Means, deviations and peaks of loads are taken from the first time to the second. `nilas run "
                  "--statistics FROM:TO` sets it too."},
          {.name = "peak_filter",
           .unit = "s",
           .range = above(0),
           .default_note = "0.2 s for a hull of 100 m, times the root of length / 100 m for others",
           .doc = "Peaks are also given of the load averaged over this time. They hardly depend on the time step."},
          {.name = "load_checks",
           .type = ValueType::integer,
           .range = within(0, 1e9),
           .default_note = "50, and at most one step of 100, where a rigid contact has friction; else 0",
           .doc = "The contacts of about so many steps are solved a second time, to a strict tolerance. The run then "
                  "states how far the ice load of one step is off. The motion does not change."},
          {.name = "bodies",
           .type = ValueType::boolean,
           .default_note = "true up to 200 bodies",
           .doc = "It says whether bodies.csv is written."}};
}

static ElementSpec output() {
  ElementSpec element{.name = "output", .parent = "scene", .always = true, .doc = "It sets what a run stores."};
  for (const auto& group : {stored_states(), statistics()})
    element.attributes.insert(element.attributes.end(), group.begin(), group.end());
  return element;
}

static ElementSpec view() {
  const ViewScene values;
  const auto degrees = [](const std::string& name, const Range& range, double value, const std::string& doc) {
    return AttributeSpec{.name = name, .unit = "deg", .range = range, .default_value = written(value), .doc = doc};
  };
  return {.name = "view",
          .parent = "scene",
          .doc = "It sets the first view of the scene in a viewer. It has no effect on the run.",
          .attributes = {degrees("camera_elevation_deg", within(-90, 90), values.camera_elevation_deg,
                                 "It is the camera's angle above the horizon."),
                         degrees("camera_heading_deg", {}, values.camera_heading_deg,
                                 "The camera looks in this direction, counted from x towards y."),
                         {.name = "camera_distance",
                          .unit = "m",
                          .range = above(0),
                          .default_value = written(values.camera_distance),
                          .doc = "It is the camera's distance from the target."},
                         three("target", "m", "The camera looks at this point."),
                         choice("mesh", values.mesh, "It selects the mesh of the hull that is drawn."),
                         {.name = "wireframe",
                          .type = ValueType::boolean,
                          .default_value = written(values.wireframe),
                          .doc = "Only edges are drawn."},
                         {.name = "normals",
                          .type = ValueType::boolean,
                          .default_value = written(values.normals),
                          .doc = "The normals of contacts are drawn."}}};
}

static ElementSpec input() {
  return {
      .name = "input",
      .parent = "scene",
      .count = Count::many,
      .doc = "It records an input file of a run, which must not change. The program writes it.",
      .attributes = {
          {.name = "file", .type = ValueType::path, .required = true, .scaled_file = true, .doc = "It names the file."},
          {.name = "sha256",
           .type = ValueType::words,
           .required = true,
           .doc = "It is the SHA-256 of the file's content, in hexadecimal digits."}}};
}

std::vector<ElementSpec> output_elements() { return {output(), view(), input()}; }

}  // namespace nilas::scene::schema_table
