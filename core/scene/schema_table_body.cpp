#include "core/scene/schema_table.h"

namespace nilas::schema_table {

static std::vector<AttributeSpec> body_shape() {
  return {{.name = "name", .type = ValueType::name, .default_note = "body and a running number", .doc = "Unique name."},
          {.name = "shape",
           .type = ValueType::choice,
           .choices = {"box", "sphere", "cylinder", "plane", "mesh"},
           .default_value = "box",
           .doc = "A cylinder's axis is its z; a plane is the half space below its z = 0 and always fixed."},
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
           .default_value = "structure",
           .doc = "Name used in <friction between>."}};
}

static std::vector<AttributeSpec> body_mass() {
  return {{.name = "mass", .unit = "kg", .range = above(0), .default_note = "from the density", .doc = "Mass."},
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
           .doc = "About the centre of mass in the body's own frame, tensor entries xx yy zz xy xz yz."},
          {.name = "fixed",
           .type = ValueType::boolean,
           .default_note = "false; true for a plane",
           .doc = "A fixed body never moves."}};
}

static AttributeSpec three(const std::string& name, const std::string& unit, const std::string& doc) {
  return {.name = name, .min_count = 3, .max_count = 3, .unit = unit, .default_value = "0 0 0", .doc = doc};
}

std::vector<ElementSpec> body_elements() {
  ElementSpec body{.name = "body",
                   .parent = "scene",
                   .count = Count::many,
                   .doc = "A free or fixed rigid body: structures and analytic cases.",
                   .attributes = body_shape()};
  for (const auto& attribute : body_mass()) body.attributes.push_back(attribute);
  body.attributes.push_back(three("position", "m", "Of the body's origin in the ground frame."));
  body.attributes.push_back(three("rotation_deg", "deg", "Yaw, pitch, roll: about z, then the new y, then the new x."));
  body.attributes.push_back(three("velocity", "m/s", "Of the centre of mass at the start, in the ground frame."));
  body.attributes.push_back(three("angular_velocity", "rad/s", "At the start, in the ground frame."));
  return {body};
}

}  // namespace nilas::schema_table
