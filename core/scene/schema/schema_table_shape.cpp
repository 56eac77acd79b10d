#include "core/scene/schema/schema_table.h"

namespace nilas::schema_table {

std::vector<AttributeSpec> shape_attributes(const std::vector<std::string>& shapes, const std::string& doc,
                                            const std::string& material) {
  return {
      {.name = "shape", .type = ValueType::choice, .choices = shapes, .default_value = "box", .doc = doc},
      {.name = "size",
       .min_count = 3,
       .max_count = 3,
       .unit = "m",
       .range = above(0),
       .default_value = "1 1 1",
       .applies = {"shape", {"box"}},
       .doc = "Edge lengths of a box."},
      {.name = "radius",
       .unit = "m",
       .range = above(0),
       .default_value = "0.5",
       .applies = {"shape", {"sphere", "cylinder"}},
       .doc = "Radius."},
      {.name = "height",
       .unit = "m",
       .range = above(0),
       .default_value = "1",
       .applies = {"shape", {"cylinder"}},
       .doc = "Height of a cylinder."},
      {.name = "mesh",
       .type = ValueType::hull,
       .default_note = "none: the shape mesh needs it",
       .applies = {"shape", {"mesh"}},
       .doc = "Hull folder, or a convex STL file."},
      {.name = "material",
       .type = ValueType::words,
       .default_value = material,
       .doc = "Name used in <friction between>."},
  };
}

std::vector<AttributeSpec> mass_attributes(const std::string& owner) {
  return {
      {.name = "mass", .unit = "kg", .range = above(0), .default_note = "from the density", .doc = "Mass."},
      {.name = "density",
       .unit = "kg/m^3",
       .range = above(0),
       .default_note = "1000 where no mass is given",
       .doc = "In place of a mass."},
      {.name = "inertia",
       .min_count = 6,
       .max_count = 6,
       .unit = "kg m^2",
       .default_note = "that of uniform density",
       .doc = "About the centre of mass in the " + owner + "'s own frame, tensor entries xx yy zz xy xz yz."},
  };
}

AttributeSpec three(const std::string& name, const std::string& unit, const std::string& doc) {
  return {.name = name, .min_count = 3, .max_count = 3, .unit = unit, .default_value = "0 0 0", .doc = doc};
}

}  // namespace nilas::schema_table
