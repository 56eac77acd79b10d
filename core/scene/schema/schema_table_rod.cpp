#include "core/scene/schema/schema_table.h"

namespace nilas::schema_table {

ElementSpec rod_element() {
  return {.name = "rod",
          .parent = "vessel",
          .count = Count::many,
          .doc =
              "A rigid link without mass between the vessel and a fixed point, such as a quay, a wall or the sea "
              "bed, with ball joints at both ends. It pulls and pushes; its force is in parts.csv.",
          .attributes = {{.name = "name", .type = ValueType::name, .required = true, .doc = "Unique name."},
                         {.name = "on",
                          .type = ValueType::name,
                          .default_note = "the hull",
                          .doc = "What the rod holds: the vessel's name, or that of one of its parts."},
                         {.name = "at",
                          .min_count = 3,
                          .max_count = 3,
                          .unit = "m",
                          .required = true,
                          .doc = "Its end on the vessel, in V; on a part while all joints are at zero."},
                         {.name = "to",
                          .min_count = 3,
                          .max_count = 3,
                          .unit = "m",
                          .required = true,
                          .doc = "Its fixed end, in the ground frame."},
                         {.name = "length",
                          .unit = "m",
                          .range = above(0),
                          .default_note = "the distance of both ends at the start",
                          .doc = "Distance that it keeps. Within 5 mm of that at the start, which is then moved onto "
                                 "it."}}};
}

}  // namespace nilas::schema_table
