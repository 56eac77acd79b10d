#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

static ElementSpec vessel() {
  const VesselScene values;
  AttributeSpec position = three("position", "m",
                                 "It places V's origin in the ground frame. With two numbers the height follows from "
                                 "floating equilibrium.");
  position.min_count = 2;
  position.default_value = written(values.position);
  return {
      .name = "vessel",
      .parent = "scene",
      .doc =
          "This is the vessel. Its frame V has its origin at that of the hull mesh, x forward, y to port and z "
          "up. The vessel is free unless it has <carriage> or <fixed>. It needs a hull, by the attribute or by "
          "the child element.",
      .attributes = {
          {.name = "name", .type = ValueType::name, .default_value = values.name, .doc = "The outputs use this name."},
          {.name = "hull",
           .type = ValueType::hull,
           .scaled_file = true,
           .doc = "It names a hull folder as `nilas hull` writes it, or a convex STL file."},
          position,
          {.name = "heading_deg",
           .unit = "deg",
           .default_value = written(values.heading_deg),
           .doc = "It is the angle of the vessel's x axis, from X towards Y."},
          three("velocity", "m/s",
                "It is the velocity of a free vessel's centre of mass at the start, in the ground frame."),
          three("angular_velocity", "rad/s",
                "It is the angular velocity of a free vessel at the start, in the ground frame.")}};
}

/// A parameter of a generated form. The generator chooses parameters that are not named; lengths are proportional to
/// `length`.
static AttributeSpec form(const std::string& name, const std::string& unit, const Range& range, const std::string& note,
                          const std::string& doc) {
  return {.name = name, .unit = unit, .range = range, .default_note = note, .doc = doc};
}

static std::string of_length(double x) {
  return written(x) + "/" + written(defaults::k_hull_length) + " of the length";
}

static ElementSpec hull() {
  const Range upright{.min = 0, .max = 90, .max_inclusive = false}, steep{.min = 0, .max = 90, .min_inclusive = false};
  return {.name = "hull",
          .parent = "vessel",
          .doc =
              "This generates a hull. The aft end is at x = 0 and the stem at x = length. The centre plane is at y = 0 "
              "and the keel at z = 0.",
          .attributes = {
              choice("generate", HullGenerateScene{}.kind, "It sets the kind of hull form."),
              form("length", "m", above(0), written(defaults::k_hull_length), "It is the length over all."),
              form("beam", "m", above(0), of_length(defaults::k_hull_beam), "It is the beam at the design waterline."),
              form("draught", "m", above(0), of_length(defaults::k_hull_draught),
                   "It is the height of the design waterline above the keel."),
              form("depth", "m", above(0), of_length(defaults::k_hull_depth), "It is the height from keel to deck."),
              form("stem_angle_deg", "deg", steep, written(defaults::k_stem_angle_deg),
                   "It is the angle between the stem and still water, of the icebreaker only."),
              form("entrance_angle_deg", "deg", inside(0, 90), written(defaults::k_entrance_angle_deg),
                   "It is the half angle of the waterline at the stem, of the icebreaker only."),
              form("bow_length", "m", above(0), of_length(defaults::k_bow_length),
                   "It is the length of the forebody at the waterline."),
              form("stern_length", "m", at_least(0), of_length(defaults::k_stern_length),
                   "It is the length of the run aft, of the icebreaker only."),
              form("flare_angle_deg", "deg", upright, written(defaults::k_flare_angle_deg),
                   "It is the angle of the sides amidships from the vertical, of the icebreaker only."),
              {.name = "triangles",
               .type = ValueType::integer,
               .range = within(100, 1e6),
               .default_note = written(defaults::k_hull_triangles),
               .doc = "It is the wanted number of triangles of the fluid mesh."}}};
}

static ElementSpec mass() {
  return {.name = "mass",
          .parent = "vessel",
          .doc =
              "It sets the mass properties. Those that are not given follow from uniform density and the displaced "
              "water.",
          .attributes = {{.name = "value",
                          .unit = "kg",
                          .range = above(0),
                          .default_note = "the mass of the displaced water",
                          .doc = "It is the mass."},
                         {.name = "draught",
                          .unit = "m",
                          .range = above(0),
                          .doc = "It is the depth of the keel below still water. The mass follows from it, so it "
                                 "excludes a mass value."},
                         {.name = "cog",
                          .min_count = 3,
                          .max_count = 3,
                          .unit = "m",
                          .default_note = "the centre of the hull's volume",
                          .doc = "It is the centre of mass in V."},
                         {.name = "inertia",
                          .min_count = 6,
                          .max_count = 6,
                          .unit = "kg m^2",
                          .default_note = "that of uniform density",
                          .doc = "These are the entries xx yy zz xy xz yz of the inertia tensor about the centre of "
                                 "mass, in V."}}};
}

static ElementSpec towing_carriage() {
  const CarriageScene values;
  return {.name = "carriage",
          .parent = "vessel",
          .doc =
              "A towing carriage moves the vessel. It holds a force balance, which holds a joint, which holds the "
              "vessel.",
          .attributes = {{.name = "speed",
                          .unit = "m/s",
                          .default_value = written(values.speed),
                          .doc = "It is the speed of a straight run."},
                         {.name = "heading_deg",
                          .unit = "deg",
                          .default_value = written(values.heading_deg),
                          .doc = "It is the direction of the run, from X towards Y."},
                         {.name = "ramp",
                          .unit = "s",
                          .range = at_least(0),
                          .default_value = written(values.ramp),
                          .doc = "The carriage takes this time to reach its speed."},
                         choice("ramp_shape", values.ramp_shape, "It sets how the speed rises."),
                         {.name = "joint",
                          .min_count = 3,
                          .max_count = 3,
                          .unit = "m",
                          .default_note = "the centre of mass",
                          .doc = "It is the point of the vessel, in V, at which the carriage holds it."},
                         {.name = "free",
                          .type = ValueType::words,
                          .min_count = 0,
                          .max_count = 6,
                          .choices = choice_names<JointAxis>(),
                          .default_note = "none",
                          .doc = "The joint is free along and about these axes."},
                         choice("start", values.start, "It sets how the vessel starts.")}};
}

static std::vector<ElementSpec> carriage() {
  return {
      {.name = "fixed", .parent = "vessel", .doc = "The vessel does not move. It excludes <carriage>."},
      towing_carriage(),
      {.name = "path",
       .parent = "carriage",
       .doc = "A prescribed motion replaces the speed. The carriage's heading_deg, ramp and ramp_shape then have no "
              "effect.",
       .attributes = {{.name = "file",
                       .type = ValueType::path,
                       .required = true,
                       .scaled_file = true,
                       .doc = "This CSV file has the columns t_s,x_m,y_m,yaw_deg: the scene's time, and "
                              "place and heading relative to the first row."}}}};
}

static ElementSpec force_balance() {
  const ForceBalanceScene values;
  const std::string for_hull = " for a hull of " + written(defaults::k_hull_length) + " m; other hulls scale it by ";
  const std::string froude = "(length / " + written(defaults::k_hull_length) + " m)";
  return {.name = "force_balance",
          .parent = "carriage",
          .always = true,
          .doc = "It holds the joint and measures the load.",
          .attributes = {choice("kind", values.kind, "It sets the kind of balance."),
                         {.name = "stiffness",
                          .unit = "N/m",
                          .range = above(0),
                          .default_note = written(values.stiffness) + for_hull + froude + "^2",
                          .applies = when("kind", BalanceKind::six_cells),
                          .doc = "It is the stiffness of each cell."},
                         {.name = "damping",
                          .unit = "N s/m",
                          .range = at_least(0),
                          .default_note = written(values.damping) + for_hull + froude + "^2.5",
                          .applies = when("kind", BalanceKind::six_cells),
                          .doc = "It is the damping coefficient of each cell."},
                         {.name = "layout",
                          .type = ValueType::path,
                          .default_note = "one longitudinal, two transverse and three vertical cells",
                          .applies = when("kind", BalanceKind::six_cells),
                          .scaled_file = true,
                          .doc = "This CSV file has the columns x_m,y_m,z_m,ax,ay,az. They give the point and axis of "
                                 "each cell in the carriage's frame, from the joint."}}};
}

std::vector<ElementSpec> vessel_elements() {
  std::vector<ElementSpec> elements{vessel(), hull(), mass()};
  for (auto& element : carriage()) elements.push_back(element);
  elements.push_back(force_balance());
  elements.push_back(part_element());
  elements.push_back(rod_element());
  for (auto& element : thruster_elements()) elements.push_back(element);
  for (auto& element : manoeuvring_elements()) elements.push_back(element);
  for (auto& element : mooring_elements()) elements.push_back(element);
  elements.push_back(remote_control_element());
  return elements;
}

}  // namespace nilas::scene::schema_table
