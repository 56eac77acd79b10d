#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/hull/hull.h"
#include "core/sim/build/body_geometry.h"
#include "core/sim/build/moored_vessel.h"
#include "core/sim/build/vessel_rest.h"
#include "core/sim/world/world.h"
#include "core/vessel/tree/rods.h"
#include "hydro/equilibrium.h"
#include "hydro/wetted.h"

namespace nilas::sim {

namespace {

/// Distance of the default transverse and vertical load cells from the joint [share of the hull's length].
constexpr double k_cell_arm_share = 0.25;
/// Convex pieces of a hull folder have float32 coordinates: they are convex only within this share of the hull's size.
constexpr double k_part_tolerance = 1e-5;

Mat3 tensor(const Vec6& entries) {
  Mat3 m;
  m << entries[0], entries[3], entries[4], entries[3], entries[1], entries[5], entries[4], entries[5], entries[2];
  return m;
}

hull::Hull load_hull(const scene::VesselScene& vessel, double file_scale) {
  if (!vessel.generate) return hull::read_hull(vessel.hull, file_scale);
  return hull::generate_hull(hull::hull_form(vessel.generate->kind, vessel.generate->parameters));
}

double lowest(const geometry::TriangleMesh& mesh) {
  double z = mesh.vertices.front().z();
  for (const auto& p : mesh.vertices) z = std::min(z, p.z());
  return z;
}

[[noreturn]] void refuse(const scene::Scene& scene, const std::string& message) {
  throw InputError(scene.file.string() + ": <vessel name='" + scene.vessel->name + "'>: " + message);
}

double height_of(const geometry::TriangleMesh& mesh) {
  const auto [bottom, top] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                                                 [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  return top->z() - bottom->z();
}

/// Mass, centre of mass and inertia in V. Missing values follow from uniform density; a missing mass follows from the
/// draught or the given height.
geometry::MassProperties vessel_mass(const scene::Scene& scene, const geometry::TriangleMesh& fluid, const Mat3& R,
                                     const WorldParts& parts) {
  const scene::VesselScene& vessel = *scene.vessel;
  const scene::MassScene& given = vessel.mass;
  NILAS_DEMAND(!given.value || !given.draught);
  const auto displaced = [&](double z) {
    return parts.water->density * hydro::submerged_mesh(fluid, R, {0, 0, z}, parts.water->level).volume;
  };
  double mass = given.value.value_or(0);
  if (!given.value) {
    NILAS_DEMAND(parts.water && (given.draught || vessel.position_has_z));
    if (given.draught && !(*given.draught < height_of(fluid)))
      refuse(scene, fmt::format("draught {:g} m: the hull is only {:g} m high", *given.draught, height_of(fluid)));
    if (given.draught)
      mass = displaced(parts.water->level - *given.draught - lowest(fluid));
    else
      mass = displaced(vessel.position.z());
    if (!(mass > 0)) refuse(scene, "the hull displaces no water at the given height, so it has no mass");
  }
  geometry::MassProperties properties = geometry::mesh_properties(fluid, 1.0);
  properties.inertia *= mass / properties.mass;
  properties.mass = mass;
  if (given.cog) properties.com = *given.cog;
  if (given.inertia) properties.inertia = tensor(*given.inertia);
  return properties;
}

/// Height of V's origin: the given one, the one that gives the draught, or that of floating equilibrium.
double vessel_height(const scene::Scene& scene, const geometry::TriangleMesh& fluid, const Mat3& R, double mass,
                     const WorldParts& parts) {
  const scene::VesselScene& vessel = *scene.vessel;
  if (vessel.position_has_z) return vessel.position.z();
  NILAS_DEMAND(parts.water.has_value());
  if (vessel.mass.draught) return parts.water->level - *vessel.mass.draught - lowest(fluid);
  return hydro::floating_height(fluid, R, mass, *parts.water);
}

vessel::CarriageModel carriage_model(const scene::Scene& scene, const vessel::VesselModel& model, double length) {
  const scene::CarriageScene& given = *scene.vessel->carriage;
  vessel::CarriageModel carriage;
  carriage.joint_V = given.joint.value_or(model.mass.com);
  const Vec3 start = model.pose_V.p + model.pose_V.q * carriage.joint_V;
  const double yaw = scene.vessel->heading_deg * k_deg;
  carriage.motion = given.path.empty()
                        ? vessel::CarriageMotion::straight(start, yaw, given.speed, given.heading_deg * k_deg,
                                                           given.ramp, scene.time.start, given.ramp_shape)
                        : vessel::CarriageMotion::path(start, yaw, given.path, scene.scale);
  if (!given.path.empty() && carriage.motion.path_span()[1] <= scene.time.start)
    throw InputError(fmt::format("{}: the path ends at {:g} s, and the scene starts at {:g} s; t_s is the scene's time",
                                 given.path, carriage.motion.path_span()[1], scene.time.start));
  carriage.free = given.free;
  carriage.stiffness = given.balance.stiffness;
  carriage.damping = given.balance.damping;
  carriage.balance = given.balance.kind;
  if (carriage.balance == BalanceKind::six_cells)
    carriage.cells = given.balance.layout.empty() ? vessel::default_cells(k_cell_arm_share * length)
                                                  : vessel::read_cells(given.balance.layout, scene.scale);
  return carriage;
}

/// Hull geometry with its origin at the centre of mass, as the body arrays need it.
std::shared_ptr<const geometry::Shape> hull_shape(const hull::Hull& hull, const Vec3& com) {
  const auto shifted = [&](geometry::TriangleMesh mesh) {
    for (auto& p : mesh.vertices) p -= com;
    return mesh;
  };
  double size = 0;
  for (const auto& p : hull.fluid.vertices) size = std::max(size, (p - com).norm());
  std::vector<geometry::ConvexPolytope> parts;
  for (const auto& part : hull.parts) parts.push_back(geometry::make_polytope(shifted(part), k_part_tolerance * size));
  return std::make_shared<const geometry::Shape>(geometry::mesh_shape(shifted(hull.fluid), std::move(parts)));
}

double length_of(const geometry::TriangleMesh& mesh) {
  double low = mesh.vertices.front().x(), high = low;
  for (const auto& p : mesh.vertices) {
    low = std::min(low, p.x());
    high = std::max(high, p.x());
  }
  return high - low;
}

/// Adds a part to the model and its shape to `solids`.
void add_part(const scene::Scene& scene, const scene::PartScene& given, vessel::VesselModel& model,
              std::vector<Solid>& solids) {
  solids.push_back(build_solid(given, scene.scale));
  const geometry::MassProperties& mass = solids.back().mass;
  vessel::PartModel part;
  part.mass = mass.mass;
  part.inertia_B = mass.inertia;
  part.in_V.q = attitude_of(given.rotation_deg);
  part.in_V.p = given.position + part.in_V.q * mass.com;
  const auto& all = scene.vessel->parts;
  const auto to =
      std::find_if(all.begin(), all.end(), [&](const scene::PartScene& other) { return other.name == given.to; });
  part.to = to == all.end() ? -1 : static_cast<int>(to - all.begin());
  part.joint = given.joint;
  part.point_V = given.at.value_or(given.position);
  part.axis_V = given.axis.normalized();
  part.stiffness = given.stiffness;
  part.damping = given.damping;
  const bool slides = part.joint == JointKind::slider;
  part.rest = slides ? given.rest_travel : given.rest_angle_deg * k_deg;
  part.coordinate = slides ? given.travel : given.angle_deg * k_deg;
  part.rate = slides ? given.speed : given.rate_deg * k_deg;
  model.parts.push_back(part);
}

void add_rods(const scene::Scene& scene, vessel::VesselModel& model, RunInfo& info) {
  const auto& all = scene.vessel->parts;
  for (const scene::RodScene& given : scene.vessel->rods) {
    const auto on =
        std::find_if(all.begin(), all.end(), [&](const scene::PartScene& part) { return part.name == given.on; });
    const int part = on == all.end() ? -1 : static_cast<int>(on - all.begin());
    model.rods.push_back({given.name, part, given.at, given.to, given.length});
    info.rods.push_back(given.name);
    info.modules.emplace_back("rod " + given.name, "<rod>");
  }
  if (model.rods.empty()) return;
  if (const auto fault = vessel::rod_fault(model, scene.time.start)) {
    const scene::RodScene& rod = scene.vessel->rods[fault->rod];
    const std::string line = rod.line > 0 ? std::to_string(rod.line) + ":" : "";  // added elements have none
    throw InputError(scene.file.string() + ":" + line + " <rod name='" + rod.name + "'>: " + fault->message);
  }
}

/// Whether a part stands still: the hull is fixed and all joints between hull and part are welds.
bool stands_still(const vessel::VesselModel& model, std::size_t part) {
  if (!model.fixed || model.parts[part].joint != JointKind::weld) return false;
  return model.parts[part].to < 0 || stands_still(model, static_cast<std::size_t>(model.parts[part].to));
}

std::vector<bodies::BodySpec> part_bodies(const scene::Scene& scene, const vessel::VesselModel& model,
                                          const std::vector<Solid>& solids, const vessel::VesselSystem& vessel) {
  std::vector<bodies::BodySpec> specs;
  for (std::size_t k = 0; k < model.parts.size(); ++k) {
    const scene::PartScene& given = scene.vessel->parts[k];
    bodies::BodySpec spec;
    spec.name = given.name;
    spec.kind = bodies::BodyKind::vessel;
    spec.motion = stands_still(model, k) ? bodies::Motion::fixed : bodies::Motion::articulated;
    spec.material = given.material;
    spec.shape = solids[k].shape;
    spec.mass = model.parts[k].mass;
    spec.inertia_B = model.parts[k].inertia_B;
    spec.pose = vessel.parts()[k].state.pose;
    specs.push_back(spec);
  }
  return specs;
}

void start_as(const vessel::VesselState& state, bodies::BodySpec& spec) {
  spec.pose = state.pose;
  spec.v = state.v;
  spec.w = state.w;
}

void add_part_bodies(const scene::Scene& scene, const vessel::VesselModel& model,
                     const std::vector<bodies::BodySpec>& specs, int hull, WorldParts& parts) {
  parts.num_parts = static_cast<int>(model.parts.size());
  for (std::size_t k = 0; k < model.parts.size(); ++k) {
    const scene::PartScene& given = scene.vessel->parts[k];
    const vessel::PartModel& part = model.parts[k];
    const int body = parts.bodies.add(specs[k]);
    if (part.joint != JointKind::free) parts.joined.emplace_back(hull + 1 + part.to, body);
    parts.info.parts.push_back({given.name, part.joint});
    parts.info.modules.emplace_back("part " + given.name, "<part joint=\"" + name_of(given.joint) + "\">");
  }
  std::sort(parts.joined.begin(), parts.joined.end());
}

}  // namespace

int build_vessel(const scene::Scene& scene, WorldParts& parts) {
  const scene::VesselScene& vessel = *scene.vessel;
  const hull::Hull hull = load_hull(vessel, scene.scale);
  vessel::VesselModel model;
  model.pose_V.q = Quat(Eigen::AngleAxisd(vessel.heading_deg * k_deg, Vec3::UnitZ()));
  const Mat3 R = model.pose_V.q.toRotationMatrix();
  model.mass = vessel_mass(scene, hull.fluid, R, parts);
  model.pose_V.p = {vessel.position.x(), vessel.position.y(),
                    vessel_height(scene, hull.fluid, R, model.mass.mass, parts)};
  model.v = vessel.velocity;
  model.w = vessel.angular_velocity;
  model.fixed = vessel.fixed;
  model.gyroscopic = scene.contact.gyroscopic;
  model.length_unit = scene.scale;
  if (scene.contact.integrator == Integrator::moreau) model.theta = scene.contact.theta;
  if (vessel.carriage) model.carriage = carriage_model(scene, model, length_of(hull.fluid));
  std::vector<Solid> solids;
  for (const scene::PartScene& part : vessel.parts) add_part(scene, part, model, solids);
  add_rods(scene, model, parts.info);
  moor_vessel(scene, hull.fluid, model, parts);
  parts.carriage = model.carriage;
  parts.vessel_model = model;
  parts.vessel.emplace(model, scene.time.start);

  bodies::BodySpec spec;
  spec.name = vessel.name;
  spec.kind = bodies::BodyKind::vessel;
  spec.motion = vessel.fixed ? bodies::Motion::fixed : bodies::Motion::articulated;
  spec.material = scene::k_hull_material;
  spec.shape = hull_shape(hull, model.mass.com);
  spec.mass = model.mass.mass;
  spec.inertia_B = model.mass.inertia;
  spec.pose = parts.vessel->state().pose;
  std::vector<bodies::BodySpec> specs{spec};
  for (const bodies::BodySpec& part : part_bodies(scene, model, solids, *parts.vessel)) specs.push_back(part);
  settle_vessel(scene, specs, parts);
  start_as(parts.vessel->state(), specs.front());
  for (std::size_t k = 0; k < model.parts.size(); ++k) start_as(parts.vessel->parts()[k].state, specs[k + 1]);

  RunInfo& info = parts.info;
  info.has_vessel = true;
  info.has_carriage = vessel.carriage.has_value();
  info.has_cells = info.has_carriage && model.carriage->balance == BalanceKind::six_cells;
  info.vessel_mass = model.mass;
  for (const auto& name : parts.vessel->built()) info.modules.emplace_back(name, "<vessel>");
  const int index = parts.bodies.add(specs.front());
  add_part_bodies(scene, model, {specs.begin() + 1, specs.end()}, index, parts);
  return index;
}

}  // namespace nilas::sim
