#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

static std::vector<AttributeSpec> part_joint() {
  const PartScene part;
  const Condition sprung = when("joint", JointKind::hinge, JointKind::slider, JointKind::ball);
  AttributeSpec joint = choice<JointKind>("joint", "It sets how the part is held.");
  joint.required = true;
  return {
      {.name = "name", .type = ValueType::name, .required = true, .doc = "The name must be unique."},
      joint,
      {.name = "to",
       .type = ValueType::name,
       .default_note = "the hull",
       .doc = "It names what holds the part: the vessel, or a part that stands before this one."},
      {.name = "at",
       .min_count = 3,
       .max_count = 3,
       .unit = "m",
       .default_note = "the part's position",
       .doc = "It is the joint point in V while all joints are at zero."},
      {.name = "axis",
       .min_count = 3,
       .max_count = 3,
       .default_value = written(part.axis),
       .applies = when("joint", JointKind::hinge, JointKind::slider),
       .doc = "It is the axis of a hinge or slider, in V while all joints are at zero. Its length does not matter."},
      {.name = "stiffness",
       .unit = "N m/rad",
       .other_units = {{when("joint", JointKind::slider), "N/m"}},
       .range = at_least(0),
       .default_value = written(part.stiffness),
       .applies = sprung,
       .doc = "It is the stiffness of the joint's spring."},
      {.name = "damping",
       .unit = "N m s/rad",
       .other_units = {{when("joint", JointKind::slider), "N s/m"}},
       .range = at_least(0),
       .default_value = written(part.damping),
       .applies = sprung,
       .doc = "It is the coefficient of the joint's damper."},
  };
}

static std::vector<AttributeSpec> part_start() {
  const PartScene part;
  const auto start = [](const char* name, const char* unit, double value, JointKind kind, const char* doc) {
    return AttributeSpec{
        .name = name, .unit = unit, .default_value = written(value), .applies = when("joint", kind), .doc = doc};
  };
  return {
      start("rest_angle_deg", "deg", part.rest_angle_deg, JointKind::hinge,
            "The spring of a hinge exerts no moment at this angle."),
      start("angle_deg", "deg", part.angle_deg, JointKind::hinge, "It is the angle of a hinge at the start."),
      start("rate_deg", "deg/s", part.rate_deg, JointKind::hinge, "It is the angular speed of a hinge at the start."),
      start("rest_travel", "m", part.rest_travel, JointKind::slider,
            "The spring of a slider exerts no force at this travel."),
      start("travel", "m", part.travel, JointKind::slider, "It is the travel of a slider at the start."),
      start("speed", "m/s", part.speed, JointKind::slider, "It is the speed of a slider at the start."),
  };
}

static std::vector<AttributeSpec> part_place() {
  return {
      {.name = "cog",
       .min_count = 3,
       .max_count = 3,
       .unit = "m",
       .default_note = "the centre of the volume",
       .applies = when("shape", SolidShapeKind::mesh),
       .doc = "It is the centre of mass in the part's own frame."},
      three("position", "m", "It places the part's origin in V while all joints are at zero."),
      three("rotation_deg", "deg",
            "These are yaw, pitch and roll in V then: turns about z, then the new y, then the new x."),
  };
}

ElementSpec part_element() {
  ElementSpec part{.name = "part",
                   .parent = "vessel",
                   .count = Count::many,
                   .doc =
                       "A part is a body that a joint attaches to the hull or to another part: a pod, a rudder, a "
                       "hinged barge. Bodies that a joint connects do not collide with each other. With parts the hull "
                       "needs a mass value and a position of three numbers."};
  for (const auto& attributes :
       {part_joint(), part_start(), shape_attributes(false, k_hull_material), mass_attributes("part"), part_place()})
    part.attributes.insert(part.attributes.end(), attributes.begin(), attributes.end());
  return part;
}

}  // namespace nilas::scene::schema_table
