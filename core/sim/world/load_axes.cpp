#include "core/sim/world/load_axes.h"

#include <algorithm>
#include <cmath>

namespace nilas::sim {

namespace {

constexpr double k_at_rest = 1e-9;  // [m/s]

/// Horizontal velocity of the drift against a fixed vessel or structure: the first non-zero one of the modules, the
/// current, and the velocities of the ice.
Vec2 drift_of(const scene::Scene& scene, const WorldParts& parts) {
  std::vector<Vec3> named;
  for (const bodies::Module* module : parts.forces)
    if (const std::optional<Vec3> drift = module->drift()) named.push_back(*drift);
  named.push_back(parts.current);
  if (scene.ice) {
    for (const scene::FieldScene& field : scene.ice->fields)
      if (!field.fixed) named.push_back(field.velocity);
    for (const scene::FloeScene& floe : scene.ice->floes)
      if (!floe.fixed) named.push_back(floe.velocity);
  }
  for (const Vec3& velocity : named)
    if (velocity.head<2>().norm() > std::sqrt(scene.scale) * k_at_rest) return velocity.head<2>();
  return Vec2::Zero();
}

bool all_breakable(const scene::IceScene& ice) {
  const auto breaks = [](const auto& item) { return item.breakable; };
  return std::all_of(ice.fields.begin(), ice.fields.end(), breaks) &&
         std::all_of(ice.floes.begin(), ice.floes.end(), breaks);
}

double horizontal_extent(const bodies::Bodies& bodies, std::size_t b) {
  const geometry::Shape& shape = *bodies.shape[b];
  if (shape.surface.vertices.empty()) return std::isfinite(shape.bounding_radius) ? 2 * shape.bounding_radius : 0;
  Vec2 low = Vec2::Constant(1e300), high = -low;
  for (const Vec3& vertex : shape.surface.vertices) {
    const Vec2 x = (bodies.R_GB[b] * vertex).head<2>();
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).maxCoeff();
}

double length_along_x(const geometry::Shape& hull) {
  double low = 0, high = 0;
  for (const Vec3& vertex : hull.surface.vertices) {
    low = std::min(low, vertex.x());
    high = std::max(high, vertex.x());
  }
  return high - low;
}

/// Whether ice meets the vessel and all fixed structures elastically.
bool ice_is_elastic(const WorldParts& parts) {
  if (!parts.friction.any_elastic()) return false;
  const bodies::Bodies& bodies = parts.bodies;
  for (std::size_t b = 0; b < bodies.id.size(); ++b) {
    if (!parts.is_of_vessel(static_cast<int>(b)) && !is_structure(bodies, b)) continue;
    for (std::size_t floe = 0; floe < bodies.id.size(); ++floe)
      if (bodies.kind[floe] == bodies::BodyKind::floe &&
          !parts.friction.of(bodies.material[b], bodies.material[floe]).elastic)
        return false;
  }
  return true;
}

}  // namespace

void describe_loads(const scene::Scene& scene, WorldParts& parts) {
  RunInfo& info = parts.info;
  const Vec2 drift = drift_of(scene, parts);
  const bool drifts = !drift.isZero(0);
  if (drifts) info.drift_course = -drift.normalized();
  if (scene.vessel) {
    info.vessel_length = length_along_x(*parts.bodies.shape[parts.vessel_index]);
    if (scene.vessel->fixed && drifts) info.course = CourseKind::drift;
    if (const auto& carriage = scene.vessel->carriage; carriage && (carriage->speed != 0 || !carriage->path.empty())) {
      info.course = CourseKind::carriage;
      if (carriage->path.empty() && carriage->ramp > 0) info.ramp_end = scene.time.start + carriage->ramp;
    }
  }
  info.statistics = scene.output.statistics;
  info.peak_filter = scene.output.peak_filter;
  const bool crushes = scene.fracture && scene.fracture->crushing && scene.ice;
  info.rigid_contacts = (!crushes || !all_breakable(*scene.ice)) && !ice_is_elastic(parts);
  // Its impacts within a step leave no contacts to add up.
  if (scene.contact.integrator == Integrator::reference) return;
  for (std::size_t b = 0; b < parts.bodies.id.size(); ++b)
    if (is_structure(parts.bodies, b))
      info.structures.push_back({parts.bodies.name[b], horizontal_extent(parts.bodies, b)});
}

bool is_structure(const bodies::Bodies& bodies, std::size_t b) {
  return bodies.kind[b] == bodies::BodyKind::rigid && bodies.motion[b] == bodies::Motion::fixed &&
         bodies.shape[b]->kind != geometry::ShapeKind::plane;
}

Vec2 course_at(const WorldParts& parts, double t) {
  if (parts.info.course == CourseKind::drift) return parts.info.drift_course;
  if (parts.info.course == CourseKind::carriage) {
    const vessel::CarriageMotion& motion = parts.carriage->motion;
    if (!motion.follows_path()) return direction_of(motion.direction());
    const Vec2 v = motion.at(t).v.head<2>();
    if (v.norm() > k_at_rest) return v.normalized();
  }
  const Vec3 forward = parts.vessel->state().pose.q * Vec3::UnitX();
  const Vec2 heading = forward.head<2>();
  // A vessel that points straight up or down has no heading.
  return heading.norm() > k_at_rest ? Vec2(heading.normalized()) : Vec2(Vec2::UnitX());
}

}  // namespace nilas::sim
