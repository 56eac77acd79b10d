#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

ElementSpec rod_element() {
  return {.name = "rod",
          .parent = "vessel",
          .count = Count::many,
          .doc =
              "A rod is a rigid massless link between the vessel and a fixed point, such as a quay, a wall or the sea "
              "bed. It has ball joints at both ends, and it pulls and pushes. The file parts.csv holds its force.",
          .attributes = {{.name = "name", .type = ValueType::name, .required = true, .doc = "The name must be unique."},
                         {.name = "on",
                          .type = ValueType::name,
                          .default_note = "the hull",
                          .doc = "It names what the rod holds: the vessel or one of its parts."},
                         {.name = "at",
                          .min_count = 3,
                          .max_count = 3,
                          .unit = "m",
                          .required = true,
                          .doc = "It is the rod's end on the vessel, in V. On a part it is taken while all joints are "
                                 "at zero."},
                         {.name = "to",
                          .min_count = 3,
                          .max_count = 3,
                          .unit = "m",
                          .required = true,
                          .doc = "It is the rod's fixed end, in the ground frame."},
                         {.name = "length",
                          .unit = "m",
                          .range = above(0),
                          .default_note = "the distance of both ends at the start",
                          .doc = "The rod keeps its ends at this distance. It must be within 5 mm of the distance at "
                                 "the start; the start is then moved onto it."}}};
}

}  // namespace nilas::scene::schema_table
