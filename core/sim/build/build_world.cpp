#include "core/sim/build/build_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "contact/detect/detector.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/sim/build/implausible.h"
#include "core/sim/build/load_database.h"
#include "core/sim/build/module/flow_modules.h"
#include "core/sim/build/module/wave_modules.h"
#include "core/sim/build/vessel_doubts.h"
#include "core/sim/world/contact_model.h"
#include "core/sim/world/course.h"
#include "core/sim/world/load_axes.h"
#include "core/sim/world/world.h"

namespace nilas::sim {

/// Adds the contact model to the list of what was built.
static void list_contact(const scene::Scene& scene, RunInfo& info) {
  const scene::ContactScene& contact = scene.contact;
  info.modules.emplace_back(
      "contact", "law " + name_of(contact.law) + ", solver " + name_of(contact.solver) + ", stabilisation " +
                     name_of(contact.stabilisation) + ", detection " + name_of(contact.detection) + ", narrow phase " +
                     name_of(contact.narrow_phase) + ", integrator " + name_of(contact.integrator) +
                     (has_static_friction(contact) ? ", static friction above kinetic" : "") +
                     (info.elastic_contacts ? ", elastic contacts" : ""));
}

static void build_modules(const ModuleSources& from, const ModuleList& modules, WorldParts& parts) {
  for (const ModuleEntry& entry : modules) {
    BuiltModule built = entry.build(from);
    if (!built.module) {
      if (entry.listed) parts.info.not_built.push_back(entry.name);
      continue;
    }
    NILAS_DEMAND(std::none_of(parts.modules.begin(), parts.modules.end(), [&](const auto& other) {
      return other->name() == built.module->name();  // names a group of the checkpoint and columns
    }));
    bodies::Module& module = *parts.modules.emplace_back(std::move(built.module));
    if (entry.listed) parts.info.modules.emplace_back(entry.name, built.reason);
    for (std::string& column : module.columns()) parts.info.module_columns.push_back(std::move(column));
    if (!module.exerts_loads()) continue;
    parts.forces.push_back(&module);
    if (!module.conservative()) parts.info.work_names.push_back(module.name());
    if (!parts.vessel) continue;
    const bodies::VesselLoad kind = module.load_on_vessel();
    if (kind == bodies::VesselLoad::own) parts.info.vessel_loads.push_back(module.name());
    if (kind == bodies::VesselLoad::water) parts.info.has_hydro = true;
  }
}

/// Gives bodies and hull the water that moves with them, as the modules say.
static void build_added_mass(WorldParts& parts) {
  const Vec3 flow = parts.water ? parts.water->current : Vec3(Vec3::Zero());
  for (const auto& module : parts.modules)
    if (bodies::AddedMassOf of = module->added_mass_of_bodies()) {
      NILAS_DEMAND(!parts.bodies.has_added_mass());
      parts.bodies.set_added_mass(std::move(of), flow);
    }
  for (std::size_t k = 0; k < parts.forces.size(); ++k)
    if (const std::optional<Mat6> added = parts.forces[k]->vessel_added_mass()) {
      NILAS_DEMAND(!parts.hull_water && parts.vessel);
      if (parts.vessel->fixed()) continue;
      const vessel::VesselState& state = parts.vessel->state();
      parts.hull_water.emplace();
      parts.hull_water->force = k;
      parts.hull_water->added_B = *added;
      parts.hull_water->twist << state.v, state.w;
    }
}

static void build_water(const scene::Scene& scene, WorldParts& parts) {
  const bool needs_water =
      scene.hydro && (scene.hydro->buoyancy || scene.hydro->drag || scene.hydro->added_mass || scene.hydro->wave_loads);
  NILAS_DEMAND(!needs_water || scene.water);
  if (!scene.water) return;
  hydro::Water water;
  water.density = scene.water->density;
  water.level = scene.water->level;
  add_flows(scene, water, parts);
  NILAS_DEMAND(!needs_water || (scene.gravity.x() == 0 && scene.gravity.y() == 0 && scene.gravity.z() <= 0));
  water.gravity = scene.gravity.norm();
  add_waves(scene, water, parts);
  parts.water = water;
}

/// Poisson's ratio where no ice gives one; it hardly matters.
constexpr double k_poisson = 0.3;

static std::optional<contact::Elasticity> elasticity(const scene::Scene& scene, const scene::FrictionScene& pair) {
  if (!pair.elastic) return std::nullopt;
  const double nu = scene.ice ? scene.ice->poisson : k_poisson;
  const double of_ice = 2 * (1 - nu) / (2 - nu);  // Mindlin 1949
  return contact::Elasticity{pair.stiffness.value_or(0), pair.edge_factor, pair.tangential_ratio.value_or(of_ice),
                             pair.damping_ratio};
}

static contact::FrictionTable friction_table(const scene::Scene& scene) {
  contact::FrictionTable table;
  for (const auto& f : scene.contact.friction)
    table.add(f.material_a, f.material_b,
              {f.static_, f.kinetic, f.restitution, f.rolling, f.spinning, elasticity(scene, f)});
  return table;
}

static void list_absent(const scene::Scene& scene, RunInfo& info) {
  const auto absent = [&](bool present, const char* name) {
    if (!present) info.not_built.emplace_back(name);
  };
  absent(scene.vessel.has_value(), "vessel");
  absent(scene.vessel && scene.vessel->carriage, "carriage");
  absent(scene.ice.has_value(), "ice");
  absent(scene.tank.has_value(), "tank");
  absent(scene.fracture.has_value(), "fracture");
}

/// Bodies that a user places and that must not overlap others at the start. Other bodies may overlap each other, but
/// not with integrator reference: it removes no overlap, and its ledger would not close.
constexpr std::array k_judged{bodies::BodyKind::floe, bodies::BodyKind::vessel};

void refuse_overlaps(const scene::Scene& scene, const WorldParts& parts) {
  const bodies::Bodies& bodies = parts.bodies;
  const auto kind = [&](int b) { return bodies.kind[b]; };
  double tolerance = scene::PackedFieldScene{}.overlap_tolerance;
  const auto tolerate = [&](const scene::PackedFieldScene& packed) {
    tolerance = std::max(tolerance, packed.overlap_tolerance);
  };
  if (scene.ice)
    for (const auto& field : scene.ice->fields) {
      if (const auto* packed = std::get_if<scene::PackedFieldScene>(&field.form)) tolerate(*packed);
      if (const auto* channel = std::get_if<scene::ChannelFieldScene>(&field.form)) tolerate(channel->ice);
    }
  detect::ContactDetector detector;
  const auto joined = [&](int a, int b) { return parts.are_joined(a, b); };
  for (const auto& c : detector.detect(bodies, 0, joined)) {
    const bool judged = std::any_of(k_judged.begin(), k_judged.end(),
                                    [&](bodies::BodyKind k) { return kind(c.a) == k || kind(c.b) == k; });
    if (!judged) continue;
    const auto reach = [&](int b) { return bodies.shape[b]->bounding_radius; };
    const double allowed = tolerance * std::min(reach(c.a), reach(c.b));
    if (-c.gap <= allowed) continue;
    const auto& names = bodies.name;
    throw InputError(fmt::format(
        "{}: '{}' and '{}' overlap by {:g} m at the start, along the shortest way apart; allowed is {:.3g} m, "
        "{:g} times the smaller radius (the largest overlap_tolerance of the scene's fields)",
        scene.file.string(), names[c.a], names[c.b], -c.gap, allowed, tolerance));
  }
}

/// Starts a perturbed run: shifts free floes and bodies horizontally by up to 1e-12 m. In a chaotic scene the run soon
/// diverges from the unperturbed one.
void set_aside(std::uint64_t twin, bodies::Bodies& bodies) {
  constexpr double k_aside = 1e-12;  // [m]
  RandomStream stream(twin, "twin");
  for (int b = 0; b < bodies.size(); ++b) {
    const auto i = static_cast<std::size_t>(b);
    if (bodies.kind[i] != bodies::BodyKind::floe && !(bodies.kind[i] == bodies::BodyKind::rigid && bodies.is_free(b)))
      continue;
    const double x = stream.uniform(-k_aside, k_aside), y = stream.uniform(-k_aside, k_aside);
    bodies.set_pose(b, bodies.p_GB[i] + Vec3(x, y, 0), bodies.q_GB[i]);
  }
}

WorldParts build_world(const scene::Scene& scene, int threads, WarningCounts& warnings, const ModuleList& modules) {
  WorldParts parts;
  parts.info.scene_name = scene.name;
  build_water(scene, parts);
  const contact::FrictionTable friction = friction_table(scene);
  if (scene.vessel) parts.vessel_index = build_vessel(scene, parts);
  if (scene.hydro && scene.hydro->database) parts.database = load_database(scene, parts);
  if (scene.ice) build_ice(scene, threads, parts, warnings);
  build_structures(scene, parts);
  if (scene.twin != 0) set_aside(scene.twin, parts.bodies);
  if (parts.ice_properties) parts.ice_properties->resize(parts.bodies.id.size());
  parts.friction = friction.resolve(parts.bodies.materials);
  parts.info.has_hydro = scene.hydro && (scene.hydro->buoyancy || scene.hydro->drag);
  parts.info.elastic_contacts = parts.friction.any_elastic();
  list_contact(scene, parts.info);
  list_absent(scene, parts.info);
  build_modules({scene, parts, threads, warnings}, modules, parts);
  build_added_mass(parts);
  if (parts.info.has_carriage) parts.info.work_names.emplace_back("carriage");
  if (parts.is_jointed()) parts.info.work_names.emplace_back("joints");
  parts.info.bodies = parts.bodies.size();
  try {
    refuse_overlaps(scene, parts);
  } catch (const InputError& overlap) {
    // A hull with a wrong orientation is a frequent cause.
    std::string message = overlap.what();
    for (const std::string& doubt : vessel_doubts(scene, parts)) message += "\n" + doubt;
    throw InputError(message);
  }
  describe_loads(scene, parts);
  describe_course(scene, parts);
  note_implausible(scene, parts);
  return parts;
}

}  // namespace nilas::sim
