#include "core/base/error.h"
#include "core/sim/build/body_geometry.h"
#include "core/sim/world/world.h"

namespace nilas::sim {

namespace {

void add_wall(bodies::Bodies& bodies, const std::string& name, const Vec3& size, const Vec3& centre) {
  bodies::BodySpec spec;
  spec.name = name;
  spec.kind = bodies::BodyKind::wall;
  spec.motion = bodies::Motion::fixed;
  spec.material = "wall";
  spec.shape = std::make_shared<const geometry::Shape>(geometry::box_shape(size));
  spec.mass = 1;
  spec.pose.p = centre;
  bodies.add(spec);
}

/// Walls reach as far above still water as the tank is deep below it, so that no piece leaves over them.
void add_tank(const scene::TankScene& tank, double level, bodies::Bodies& bodies) {
  const double t = tank.wall_thickness, height = 2 * tank.depth, length = tank.length + 2 * t;
  const double y = 0.5 * (tank.width + t);
  add_wall(bodies, "wall port", {length, t, height}, {0.5 * tank.length, y, level});
  add_wall(bodies, "wall starboard", {length, t, height}, {0.5 * tank.length, -y, level});
  add_wall(bodies, "wall start", {t, tank.width, height}, {-0.5 * t, 0, level});
  add_wall(bodies, "wall end", {t, tank.width, height}, {tank.length + 0.5 * t, 0, level});
  if (tank.floor)
    add_wall(bodies, "floor", {length, tank.width + 2 * t, t}, {0.5 * tank.length, 0, level - tank.depth - 0.5 * t});
}

void add_body(const scene::BodyScene& body, double file_scale, bodies::Bodies& bodies) {
  NILAS_DEMAND(body.kind() != SolidShapeKind::plane || body.fixed);
  const Solid solid = build_solid(body, file_scale);
  bodies::BodySpec spec;
  spec.name = body.name;
  spec.kind = bodies::BodyKind::rigid;
  spec.motion = body.fixed ? bodies::Motion::fixed : bodies::Motion::free;
  spec.material = body.material;
  spec.shape = solid.shape;
  spec.mass = solid.mass.mass;
  spec.inertia_B = solid.mass.inertia;
  spec.pose.q = attitude_of(body.rotation_deg);
  spec.pose.p = body.position + spec.pose.q * solid.mass.com;
  if (!body.fixed) {
    spec.v = body.velocity;
    spec.w = body.angular_velocity;
  }
  bodies.add(spec);
}

}  // namespace

void build_structures(const scene::Scene& scene, WorldParts& parts) {
  if (scene.tank) {
    add_tank(*scene.tank, parts.water ? parts.water->level : 0, parts.bodies);
    parts.info.modules.emplace_back("tank", "<tank>");
  }
  for (const auto& body : scene.bodies) add_body(body, scene.scale, parts.bodies);
}

}  // namespace nilas::sim
