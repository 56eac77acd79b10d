#include "core/scene/schema/schema_table.h"

namespace nilas::schema_table {

static ElementSpec vessel() {
  return {
      .name = "vessel",
      .parent = "scene",
      .doc =
          "The vessel. Its frame V: x forward, y port, z up, origin at the hull mesh's origin. It is free unless it "
          "holds <carriage> or <fixed>. Its hull is named by the attribute or the child `hull`.",
      .attributes = {
          {.name = "name", .type = ValueType::name, .default_value = "ship", .doc = "Name in the outputs."},
          {.name = "hull",
           .type = ValueType::hull,
           .doc = "Hull folder written by `nilas hull`, or a convex STL file."},
          {.name = "position",
           .min_count = 2,
           .max_count = 3,
           .unit = "m",
           .default_value = "0 0 0",
           .doc = "Of V's origin in the ground frame; with two numbers the height is that of floating equilibrium."},
          {.name = "heading_deg", .unit = "deg", .default_value = "0", .doc = "Of the x axis from X towards Y."},
          {.name = "velocity",
           .min_count = 3,
           .max_count = 3,
           .unit = "m/s",
           .default_value = "0 0 0",
           .doc = "Of a free vessel's centre of mass at the start, in the ground frame."},
          {.name = "angular_velocity",
           .min_count = 3,
           .max_count = 3,
           .unit = "rad/s",
           .default_value = "0 0 0",
           .doc = "Of a free vessel at the start, in the ground frame."}}};
}

/// A parameter of a generated form: what is not named is the generator's to choose, lengths in proportion to `length`.
static AttributeSpec form(const std::string& name, const std::string& unit, const Range& range, const std::string& note,
                          const std::string& doc) {
  return {.name = name, .unit = unit, .range = range, .default_note = note, .doc = doc};
}

static ElementSpec hull() {
  return {
      .name = "hull",
      .parent = "vessel",
      .doc =
          "A generated hull in place of a hull folder: x = 0 at the aft end, x = length at the stem, y = 0 on "
          "the centre plane, z = 0 at the keel.",
      .attributes = {{.name = "generate",
                      .type = ValueType::choice,
                      .choices = {"icebreaker", "wedge"},
                      .default_value = "icebreaker",
                      .doc = "Kind of form: icebreaker, or wedge (vertical sides, wedge bow)."},
                     form("length", "m", above(0), "6", "Length over all."),
                     form("beam", "m", above(0), "0.2 of the length", "Beam."),
                     form("draught", "m", above(0), "0.35/6 of the length", "Design waterline above the keel."),
                     form("depth", "m", above(0), "0.1 of the length", "Keel to deck."),
                     form("stem_angle_deg", "deg", {.min = 0, .max = 90, .min_inclusive = false}, "25",
                          "Between the stem and still water; icebreaker only."),
                     form("entrance_angle_deg", "deg", inside(0, 90), "30",
                          "Half angle of the waterline at the stem; icebreaker only."),
                     form("bow_length", "m", above(0), "0.3 of the length", "Length of the forebody at the waterline."),
                     form("stern_length", "m", at_least(0), "1/6 of the length", "Length of the run; icebreaker only."),
                     form("flare_angle_deg", "deg", {.min = 0, .max = 90, .max_inclusive = false}, "8",
                          "Of the sides amidships from the vertical; icebreaker only."),
                     {.name = "triangles",
                      .type = ValueType::integer,
                      .range = within(100, 1e6),
                      .default_note = "6000",
                      .doc = "Wanted number of triangles of the fluid mesh."}}};
}

static ElementSpec mass() {
  return {
      .name = "mass",
      .parent = "vessel",
      .doc = "What is not given follows from uniform density and the displaced water.",
      .attributes = {{.name = "value",
                      .unit = "kg",
                      .range = above(0),
                      .default_note = "the mass of the displaced water",
                      .doc = "Mass."},
                     {.name = "draught",
                      .unit = "m",
                      .range = above(0),
                      .doc = "In place of a mass: depth of the keel below still water, from which the mass follows."},
                     {.name = "cog",
                      .min_count = 3,
                      .max_count = 3,
                      .unit = "m",
                      .default_note = "the centre of the hull's volume",
                      .doc = "Centre of mass in V."},
                     {.name = "inertia",
                      .min_count = 6,
                      .max_count = 6,
                      .unit = "kg m^2",
                      .default_note = "that of uniform density",
                      .doc = "About the centre of mass in V, tensor entries xx yy zz xy xz yz."}}};
}

static std::vector<ElementSpec> carriage() {
  return {
      {.name = "fixed", .parent = "vessel", .doc = "The vessel does not move. Not together with <carriage>."},
      {.name = "carriage",
       .parent = "vessel",
       .doc = "A towing carriage that moves the vessel. The chain is carriage, force balance, joint, vessel.",
       .attributes =
           {{.name = "speed", .unit = "m/s", .default_value = "0", .doc = "Speed of a straight run."},
            {.name = "heading_deg",
             .unit = "deg",
             .default_value = "0",
             .doc = "Direction of the run, from X towards Y."},
            {.name = "ramp",
             .unit = "s",
             .range = at_least(0),
             .default_value = "0",
             .doc = "Time over which the speed is reached."},
            {.name = "ramp_shape",
             .type = ValueType::choice,
             .choices = {"linear", "smooth"},
             .default_value = "linear",
             .doc = "linear: constant acceleration, which begins and ends with a jump that makes load cells ring. "
                    "smooth: it rises from zero to 1.5 times as much and falls back to zero; the run is as long."},
            {.name = "joint",
             .min_count = 3,
             .max_count = 3,
             .unit = "m",
             .default_note = "the centre of mass",
             .doc = "Point of the vessel, in V, at which it is held."},
            {.name = "free",
             .type = ValueType::words,
             .min_count = 0,
             .max_count = 6,
             .choices = {"surge", "sway", "heave", "roll", "pitch", "yaw"},
             .default_note = "none",
             .doc = "Axes along and about which the joint is free, blank-separated."},
            {.name = "start",
             .type = ValueType::choice,
             .choices = {"equilibrium", "as-placed"},
             .default_value = "equilibrium",
             .doc =
                 "equilibrium: the vessel starts at rest under weight and buoyancy, the cells deflected; "
                 "axes that are free and that water balances (heave, roll, pitch) are in balance too. "
                 "as-placed: at its position and upright, the cells unloaded, as vessels with <rod> start always."}}},
      {.name = "path",
       .parent = "carriage",
       .doc = "A prescribed motion in place of a speed; heading_deg, ramp and ramp_shape of the carriage have no "
              "effect with it.",
       .attributes = {{.name = "file",
                       .type = ValueType::path,
                       .required = true,
                       .doc = "CSV file with columns t_s,x_m,y_m,yaw_deg, relative to the start."}}},
  };
}

static ElementSpec force_balance() {
  return {
      .name = "force_balance",
      .parent = "carriage",
      .always = true,
      .doc = "How the carriage holds the joint and measures the load.",
      .attributes = {{.name = "kind",
                      .type = ValueType::choice,
                      .choices = {"rigid", "six-cells", "prismatic"},
                      .default_value = "rigid",
                      .doc = "rigid (reactions are constraint forces), six-cells (six uniaxial load cells), prismatic "
                             "(a single joint along Z)."},
                     {.name = "stiffness",
                      .unit = "N/m",
                      .range = above(0),
                      .default_note = "1e7 for a hull of 6 m, others by Froude's law: times (length / 6 m)^2",
                      .applies = {"kind", {"six-cells"}},
                      .doc = "Of each cell."},
                     {.name = "damping",
                      .unit = "N s/m",
                      .range = at_least(0),
                      .default_note = "1e4 for a hull of 6 m, others by Froude's law: times (length / 6 m)^2.5",
                      .applies = {"kind", {"six-cells"}},
                      .doc = "Of each cell."},
                     {.name = "layout",
                      .type = ValueType::path,
                      .default_note = "one longitudinal, two transverse, three vertical cells",
                      .applies = {"kind", {"six-cells"}},
                      .doc = "CSV file with columns x_m,y_m,z_m,ax,ay,az: point and axis of each cell in the "
                             "carriage's frame, from the joint."}}};
}

static std::vector<ElementSpec> means_of_control() {
  const AttributeSpec file{.name = "file", .type = ValueType::path, .required = true, .doc = "Its description."};
  return {
      {.name = "thrusters", .parent = "vessel", .built = false, .doc = "Thrusters.", .attributes = {file}},
      {.name = "control",
       .parent = "vessel",
       .built = false,
       .doc = "Automatic control of the vessel.",
       .attributes =
           {{.name = "mode",
             .type = ValueType::choice,
             .choices = {"dp", "heading-speed", "none"},
             .default_value = "none",
             .doc = "Dynamic positioning, heading and speed, or none."},
            {.name = "setpoint", .min_count = 2, .max_count = 2, .unit = "m", .doc = "Of the centre of mass."},
            {.name = "heading_deg", .unit = "deg", .default_value = "0", .doc = "Wanted heading."}}},
      {.name = "mooring", .parent = "vessel", .built = false, .doc = "Mooring lines.", .attributes = {file}},
  };
}

std::vector<ElementSpec> vessel_elements() {
  std::vector<ElementSpec> elements{vessel(), hull(), mass()};
  for (auto& element : carriage()) elements.push_back(element);
  elements.push_back(force_balance());
  elements.push_back(part_element());
  elements.push_back(rod_element());
  for (auto& element : means_of_control()) elements.push_back(element);
  return elements;
}

}  // namespace nilas::schema_table
