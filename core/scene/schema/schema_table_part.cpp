#include "core/scene/schema/schema_table.h"

namespace nilas::schema_table {

static std::vector<AttributeSpec> part_joint() {
  const Condition sprung{"joint", {"hinge", "slider", "ball"}};
  return {
      {.name = "name", .type = ValueType::name, .required = true, .doc = "Unique name."},
      {.name = "joint",
       .type = ValueType::choice,
       .choices = {"hinge", "slider", "ball", "free", "weld"},
       .required = true,
       .doc = "hinge turns about one axis, slider moves along one, ball turns about a point, free is not held, weld is "
              "held fast."},
      {.name = "to",
       .type = ValueType::name,
       .default_note = "the hull",
       .doc = "What the part hangs on: the vessel's name, or that of a part before it."},
      {.name = "at",
       .min_count = 3,
       .max_count = 3,
       .unit = "m",
       .default_note = "the part's position",
       .doc = "Joint point in V while all joints are at zero."},
      {.name = "axis",
       .min_count = 3,
       .max_count = 3,
       .default_value = "0 0 1",
       .applies = {"joint", {"hinge", "slider"}},
       .doc = "Axis of a hinge or slider in V while all joints are at zero; its length does not matter."},
      {.name = "stiffness",
       .unit = "N m/rad; of a slider N/m",
       .range = at_least(0),
       .default_value = "0",
       .applies = sprung,
       .doc = "Of the joint's spring."},
      {.name = "damping",
       .unit = "N m s/rad; of a slider N s/m",
       .range = at_least(0),
       .default_value = "0",
       .applies = sprung,
       .doc = "Of the joint's damper."},
  };
}

static std::vector<AttributeSpec> part_start() {
  const Condition hinge{"joint", {"hinge"}}, slider{"joint", {"slider"}};
  return {
      {.name = "rest_angle_deg",
       .unit = "deg",
       .default_value = "0",
       .applies = hinge,
       .doc = "Where a hinge's spring is slack."},
      {.name = "angle_deg", .unit = "deg", .default_value = "0", .applies = hinge, .doc = "Of a hinge at the start."},
      {.name = "rate_deg", .unit = "deg/s", .default_value = "0", .applies = hinge, .doc = "Of a hinge at the start."},
      {.name = "rest_travel",
       .unit = "m",
       .default_value = "0",
       .applies = slider,
       .doc = "Where a slider's spring is slack."},
      {.name = "travel", .unit = "m", .default_value = "0", .applies = slider, .doc = "Of a slider at the start."},
      {.name = "speed", .unit = "m/s", .default_value = "0", .applies = slider, .doc = "Of a slider at the start."},
  };
}

static std::vector<AttributeSpec> part_place() {
  return {
      {.name = "cog",
       .min_count = 3,
       .max_count = 3,
       .unit = "m",
       .default_note = "the centre of the volume",
       .applies = {"shape", {"mesh"}},
       .doc = "Centre of mass in the part's own frame."},
      three("position", "m", "Of the part's origin in V while all joints are at zero."),
      three("rotation_deg", "deg", "Yaw, pitch, roll in V then: about z, then the new y, then the new x."),
  };
}

ElementSpec part_element() {
  ElementSpec part{
      .name = "part",
      .parent = "vessel",
      .count = Count::many,
      .doc =
          "A body that a joint holds to the hull or to another part: a pod, a rudder, a hinged barge. What "
          "a joint holds together does not collide; all else does. With parts the hull needs a mass by "
          "value and a position of three numbers."};
  for (const auto& attributes :
       {part_joint(), part_start(),
        shape_attributes({"box", "sphere", "cylinder", "mesh"}, "A cylinder's axis is its z.", "hull"),
        mass_attributes("part"), part_place()})
    part.attributes.insert(part.attributes.end(), attributes.begin(), attributes.end());
  return part;
}

}  // namespace nilas::schema_table
