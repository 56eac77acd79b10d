#include "core/base/error.h"
#include "core/sim/world.h"
#include "core/vessel/hull.h"

namespace nilas {

namespace {

Quat attitude(const Vec3& yaw_pitch_roll_deg) {
  return Quat(Eigen::AngleAxisd(yaw_pitch_roll_deg[0] * k_deg, Vec3::UnitZ()) *
              Eigen::AngleAxisd(yaw_pitch_roll_deg[1] * k_deg, Vec3::UnitY()) *
              Eigen::AngleAxisd(yaw_pitch_roll_deg[2] * k_deg, Vec3::UnitX()));
}

void add_wall(Bodies& bodies, const std::string& name, const Vec3& size, const Vec3& centre) {
  BodySpec spec;
  spec.name = name;
  spec.kind = BodyKind::wall;
  spec.motion = Motion::fixed;
  spec.material = "wall";
  spec.shape = std::make_shared<const Shape>(box_shape(size));
  spec.mass = 1;
  spec.pose.p = centre;
  bodies.add(spec);
}

/// Walls reach as far above still water as the tank is deep below it, so that no piece leaves over them.
void add_tank(const TankScene& tank, double level, Bodies& bodies) {
  const double t = tank.wall_thickness, height = 2 * tank.depth, length = tank.length + 2 * t;
  const double y = 0.5 * (tank.width + t);
  add_wall(bodies, "wall port", {length, t, height}, {0.5 * tank.length, y, level});
  add_wall(bodies, "wall starboard", {length, t, height}, {0.5 * tank.length, -y, level});
  add_wall(bodies, "wall start", {t, tank.width, height}, {-0.5 * t, 0, level});
  add_wall(bodies, "wall end", {t, tank.width, height}, {tank.length + 0.5 * t, 0, level});
  if (tank.floor)
    add_wall(bodies, "floor", {length, tank.width + 2 * t, t}, {0.5 * tank.length, 0, level - tank.depth - 0.5 * t});
}

struct BodyGeometry {
  Shape shape;
  MassProperties unit;  ///< of density 1 kg/m^3, com in the element's frame
};

BodyGeometry geometry(const BodyScene& body, const std::string& file) {
  const std::string place = file + ":" + std::to_string(body.line) + ": <body name='" + body.name + "'>";
  BodyGeometry g;
  if (body.shape == "sphere") {
    g.shape = sphere_shape(body.radius);
    g.unit = sphere_properties(body.radius, 4.0 / 3.0 * k_pi * body.radius * body.radius * body.radius);
  } else if (body.shape == "cylinder") {
    g.shape = cylinder_shape(body.radius, body.height);
    g.unit = cylinder_properties(body.radius, body.height, k_pi * body.radius * body.radius * body.height);
  } else if (body.shape == "plane") {
    if (!body.fixed) throw InputError(place + ": a plane must be fixed=\"true\"");
    g.shape = plane_shape();
    g.unit.mass = 1;
    g.unit.inertia = Mat3::Identity();
  } else if (body.shape == "mesh") {
    Hull hull = read_hull(body.mesh);
    g.unit = mesh_properties(hull.fluid, 1.0);
    double size = 0;
    for (auto& p : hull.fluid.vertices) size = std::max(size, (p -= g.unit.com).norm());
    std::vector<ConvexPolytope> parts;
    for (auto& part : hull.parts) {
      for (auto& p : part.vertices) p -= g.unit.com;
      constexpr double k_float_rounding = 1e-5;  // of the size: STL files hold float32 coordinates
      parts.push_back(make_polytope(part, k_float_rounding * size));
    }
    g.shape = mesh_shape(hull.fluid, std::move(parts));
  } else {
    g.shape = box_shape(body.size);
    g.unit = box_properties(body.size, body.size.prod());
  }
  return g;
}

void add_body(const BodyScene& body, const std::string& file, Bodies& bodies) {
  BodyGeometry g = geometry(body, file);
  if (body.mass && body.density)
    throw InputError(file + ":" + std::to_string(body.line) + ": <body name='" + body.name +
                     "'>: takes mass or density, not both");
  constexpr double k_default_density = 1000;  // [kg/m^3]
  const double mass = body.mass.value_or(body.density.value_or(k_default_density) * g.unit.mass);
  BodySpec spec;
  spec.name = body.name;
  spec.kind = BodyKind::rigid;
  spec.motion = body.fixed ? Motion::fixed : Motion::free;
  spec.material = body.material;
  spec.shape = std::make_shared<const Shape>(std::move(g.shape));
  spec.mass = mass;
  spec.inertia_B = g.unit.inertia * (mass / g.unit.mass);
  if (body.inertia) {
    const Vec6& i = *body.inertia;
    spec.inertia_B << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
  }
  spec.pose.q = attitude(body.rotation_deg);
  spec.pose.p = body.position + spec.pose.q * g.unit.com;
  if (!body.fixed) {
    spec.v = body.velocity;
    spec.w = body.angular_velocity;
  }
  bodies.add(spec);
}

}  // namespace

void build_structures(const Scene& scene, WorldParts& parts) {
  if (scene.tank) {
    add_tank(*scene.tank, parts.water ? parts.water->level : 0, parts.bodies);
    parts.info.modules.emplace_back("tank", "<tank>");
  }
  for (const auto& body : scene.bodies) add_body(body, scene.file.string(), parts.bodies);
}

}  // namespace nilas
