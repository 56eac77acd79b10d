#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

std::vector<ElementSpec> body_elements() {
  ElementSpec body{.name = "body",
                   .parent = "scene",
                   .count = Count::many,
                   .doc = "A body is a free or fixed rigid body, such as a structure or an analytic test body.",
                   .attributes = {{.name = "name",
                                   .type = ValueType::name,
                                   .default_note = "body and a running number",
                                   .doc = "The name must be unique."}}};
  auto& all = body.attributes;
  const auto shape = shape_attributes(true, BodyScene{}.material);
  all.insert(all.end(), shape.begin(), shape.end());
  const auto mass = mass_attributes("body");
  all.insert(all.end(), mass.begin(), mass.end());
  all.push_back({.name = "fixed",
                 .type = ValueType::boolean,
                 .default_note = "false; true for a plane",
                 .doc = "A fixed body never moves."});
  all.push_back(three("position", "m", "It places the body's origin in the ground frame."));
  all.push_back(
      three("rotation_deg", "deg", "These are yaw, pitch and roll: turns about z, then the new y, then the new x."));
  all.push_back(
      three("velocity", "m/s", "It is the velocity of the centre of mass at the start, in the ground frame."));
  all.push_back(three("angular_velocity", "rad/s", "It is the angular velocity at the start, in the ground frame."));
  return {body};
}

}  // namespace nilas::scene::schema_table
