#include <algorithm>

#include "core/scene/spec/values.h"
#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

std::string written(double x) { return format_number(x); }
std::string written(int x) { return std::to_string(x); }
std::string written(const Vec3& x) { return written(x[0]) + " " + written(x[1]) + " " + written(x[2]); }

static AttributeSpec shape(bool can_be_plane) {
  std::string doc = "It sets the shape.";
  AttributeSpec attribute = choice("shape", SolidScene{}.kind(), "");
  if (!can_be_plane) std::erase(attribute.choices, name_of(SolidShapeKind::plane));
  for (const SolidShapeKind kind : all_choices<SolidShapeKind>())
    if (can_be_plane || kind != SolidShapeKind::plane)
      doc += " `" + name_of(kind) + "`: " + std::string(choice_text(kind).doc);
  attribute.doc = doc;
  return attribute;
}

std::vector<AttributeSpec> shape_attributes(bool can_be_plane, const std::string& material) {
  return {
      shape(can_be_plane),
      {.name = "size",
       .min_count = 3,
       .max_count = 3,
       .unit = "m",
       .range = above(0),
       .default_value = written(BoxScene{}.size),
       .applies = when("shape", SolidShapeKind::box),
       .doc = "These are the edge lengths of a box."},
      {.name = "radius",
       .unit = "m",
       .range = above(0),
       .default_value = written(SphereScene{}.radius),
       .applies = when("shape", SolidShapeKind::sphere, SolidShapeKind::cylinder),
       .doc = "It is the radius."},
      {.name = "height",
       .unit = "m",
       .range = above(0),
       .default_value = written(CylinderScene{}.height),
       .applies = when("shape", SolidShapeKind::cylinder),
       .doc = "It is the height of a cylinder."},
      {.name = "mesh",
       .type = ValueType::hull,
       .default_note = "none: the shape mesh needs it",
       .applies = when("shape", SolidShapeKind::mesh),
       .scaled_file = true,
       .doc = "It names a hull folder or a convex STL file."},
      {.name = "material",
       .type = ValueType::words,
       .default_value = material,
       .doc = "<friction between> refers to this name."},
  };
}

std::vector<AttributeSpec> mass_attributes(const std::string& owner) {
  return {
      {.name = "mass", .unit = "kg", .range = above(0), .default_note = "from the density", .doc = "It is the mass."},
      {.name = "density",
       .unit = "kg/m^3",
       .range = above(0),
       .default_note = written(SolidScene::k_density) + " where no mass is given",
       .doc = "It sets the mass from the volume."},
      {.name = "inertia",
       .min_count = 6,
       .max_count = 6,
       .unit = "kg m^2",
       .default_note = "that of uniform density",
       .doc = "These are the entries xx yy zz xy xz yz of the inertia tensor. It is taken about the centre of mass in "
              "the " +
              owner + "'s own frame."},
  };
}

AttributeSpec three(const std::string& name, const std::string& unit, const std::string& doc) {
  return {.name = name,
          .min_count = 3,
          .max_count = 3,
          .unit = unit,
          .default_value = written(Vec3(Vec3::Zero())),
          .doc = doc};
}

}  // namespace nilas::scene::schema_table
