#include "core/scene/schema_table.h"

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

static std::vector<AttributeSpec> part_body() {
  return {
      {.name = "shape",
       .type = ValueType::choice,
       .choices = {"box", "sphere", "cylinder", "mesh"},
       .default_value = "box",
       .doc = "A cylinder's axis is its z."},
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
       .default_value = "hull",
       .doc = "Name used in <friction between>."},
      {.name = "mass", .unit = "kg", .range = above(0), .default_note = "from the density", .doc = "Mass."},
      {.name = "density",
       .unit = "kg/m^3",
       .range = above(0),
       .default_note = "1000 where no mass is given",
       .doc = "In place of a mass."},
      {.name = "cog",
       .min_count = 3,
       .max_count = 3,
       .unit = "m",
       .default_note = "the centre of the volume",
       .applies = {"shape", {"mesh"}},
       .doc = "Centre of mass in the part's own frame."},
      {.name = "inertia",
       .min_count = 6,
       .max_count = 6,
       .unit = "kg m^2",
       .default_note = "that of uniform density",
       .doc = "About the centre of mass in the part's own frame, tensor entries xx yy zz xy xz yz."},
      {.name = "position",
       .min_count = 3,
       .max_count = 3,
       .unit = "m",
       .default_value = "0 0 0",
       .doc = "Of the part's origin in V while all joints are at zero."},
      {.name = "rotation_deg",
       .min_count = 3,
       .max_count = 3,
       .unit = "deg",
       .default_value = "0 0 0",
       .doc = "Yaw, pitch, roll in V then: about z, then the new y, then the new x."},
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
  for (const auto& attributes : {part_joint(), part_start(), part_body()})
    part.attributes.insert(part.attributes.end(), attributes.begin(), attributes.end());
  return part;
}

}  // namespace nilas::schema_table
