#include "core/scene/schema/schema_table.h"

namespace nilas::schema_table {

std::vector<ElementSpec> body_elements() {
  ElementSpec body{.name = "body",
                   .parent = "scene",
                   .count = Count::many,
                   .doc = "A free or fixed rigid body: structures and analytic cases.",
                   .attributes = {{.name = "name",
                                   .type = ValueType::name,
                                   .default_note = "body and a running number",
                                   .doc = "Unique name."}}};
  auto& all = body.attributes;
  const auto shape = shape_attributes(
      {"box", "sphere", "cylinder", "plane", "mesh"},
      "A cylinder's axis is its z; a plane is the half space below its z = 0 and always fixed.", "structure");
  all.insert(all.end(), shape.begin(), shape.end());
  const auto mass = mass_attributes("body");
  all.insert(all.end(), mass.begin(), mass.end());
  all.push_back({.name = "fixed",
                 .type = ValueType::boolean,
                 .default_note = "false; true for a plane",
                 .doc = "A fixed body never moves."});
  all.push_back(three("position", "m", "Of the body's origin in the ground frame."));
  all.push_back(three("rotation_deg", "deg", "Yaw, pitch, roll: about z, then the new y, then the new x."));
  all.push_back(three("velocity", "m/s", "Of the centre of mass at the start, in the ground frame."));
  all.push_back(three("angular_velocity", "rad/s", "At the start, in the ground frame."));
  return {body};
}

}  // namespace nilas::schema_table
