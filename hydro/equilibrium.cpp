#include "hydro/equilibrium.h"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "core/numerics/nonlinear_solve.h"
#include "hydro/mesh_water.h"
#include "hydro/wet_body.h"

namespace nilas::hydro {

namespace {

constexpr double k_balance = 1e-12;  // |rho V - m| / m, above the rounding of V

/// Displaced mass and its slope over the height at one trial height.
struct Displacement {
  double mass = 0;   ///< [kg]
  double slope = 0;  ///< Minus the density times the waterplane area [kg/m].
};

Displacement displacement(MeshWater& mesh, const Mat3& R, double z, const Water& water) {
  const Vec3 p(0, 0, z);
  const WaterPlane plane = water_plane(R, p, water.level);
  double area = 0;  // of the waterplane, which closes the wet surface
  mesh.for_each_wet_face(plane,
                         [&](double face, const Vec3&, const Vec3& normal) { area -= face * normal.dot(plane.up); });
  return {water.density * mesh.submerged(R, p, water.level).volume, -water.density * area};
}

[[noreturn]] void refuse_to_sink(double mass, double most) {
  throw InputError("the body would sink: its mass is " + std::to_string(mass) +
                   " kg, wholly under water it displaces " + std::to_string(most) + " kg");
}

/// A body of any shape about its centre of mass, with the water integrals of the buoyancy module.
class FloatingShape {
 public:
  explicit FloatingShape(const geometry::Shape& shape) : shape_(shape), geometry_(prepare_geometry(shape)) {}

  Submerged submerged(const Mat3& R, double z, double level) {
    const Vec3 p(0, 0, z);
    if (auto* prism = std::get_if<PrismWater>(&geometry_)) return prism->submerged(R, p, level);
    if (auto* mesh = std::get_if<MeshWater>(&geometry_)) return mesh->submerged(R, p, level);
    return submerged_sphere(shape_.radius, p, level);
  }
  Waterplane cut(const Mat3& R, double z, double level) const {
    if (shape_.kind != geometry::ShapeKind::sphere) return waterplane(shape_.surface, R, {0, 0, z}, level);
    const double square = std::max(shape_.radius * shape_.radius - (level - z) * (level - z), 0.0);
    return {k_pi * square, Vec2::Zero(), 0.25 * k_pi * square * square, 0.25 * k_pi * square * square, 0};
  }
  /// The height of the lowest point above the origin, mostly negative [m].
  double lowest(const Mat3& R) const {
    if (shape_.kind == geometry::ShapeKind::sphere) return -shape_.radius;
    double z = 0;
    for (const Vec3& x : shape_.surface.vertices) z = std::min(z, R.row(2).dot(x));
    return z;
  }
  /// The height at which the Newton iteration begins: heave balance at this attitude, for a sphere half under water
  /// [m].
  double start_height(const Mat3& R, double mass, const Water& water) const {
    if (shape_.kind != geometry::ShapeKind::sphere) return floating_height(shape_.surface, R, mass, water);
    const double most = water.density * 4 / 3 * k_pi * std::pow(shape_.radius, 3);
    if (mass >= most) refuse_to_sink(mass, most);
    return water.level;
  }

 private:
  const geometry::Shape& shape_;
  WetGeometry geometry_;
};

/// The start attitude turned in G by `tilt`, a rotation vector about horizontal axes of G [rad].
Mat3 tilted(const Vec2& tilt, const Quat& start) {
  const double angle = tilt.norm();
  if (!(angle > 0)) return start.toRotationMatrix();
  const Vec3 axis(tilt.x() / angle, tilt.y() / angle, 0);
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix() * start.toRotationMatrix();
}

/// Fills in the metacentric heights: BM along and across the heading, plus the height of the centre of buoyancy over
/// the centre of mass.
void add_metacentres(const Waterplane& cut, double buoyancy_height, const Mat3& R, FloatingEquilibrium& found) {
  const double heading = std::atan2(R(1, 0), R(0, 0)), c = std::cos(heading), s = std::sin(heading);
  const double across = s * s * cut.xx + c * c * cut.yy - 2 * s * c * cut.xy;
  const double along = c * c * cut.xx + s * s * cut.yy + 2 * s * c * cut.xy;
  const double middle = 0.5 * (cut.xx + cut.yy), spread = std::hypot(0.5 * (cut.xx - cut.yy), cut.xy);
  found.gm_transverse = across / found.volume + buoyancy_height;
  found.gm_longitudinal = along / found.volume + buoyancy_height;
  found.gm_least = (middle - spread) / found.volume + buoyancy_height;
}

}  // namespace

double floating_height(const geometry::TriangleMesh& mesh, const Mat3& R, double mass, const Water& water) {
  if (!(mass > 0)) throw InputError("a floating body needs a positive mass, not " + std::to_string(mass) + " kg");
  MeshWater prepared(mesh);
  const auto [bottom, top] = prepared.height_range({R.row(2).transpose(), 0});
  const double sunk = water.level - top, height = top - bottom;
  const double most = displacement(prepared, R, sunk, water).mass;
  if (mass > most * (1 + k_balance)) refuse_to_sink(mass, most);
  // Newton's method needs bounds here, and KINSOL has none. Of 1400 random masses and attitudes KINSOL missed 27: a
  // step led out of the water, where the displacement has no slope. The unknown is the rise from where all is under
  // water.
  const auto excess = [&](double rise) {
    const Displacement now = displacement(prepared, R, sunk + rise, water);
    if (std::abs(now.mass - mass) <= k_balance * mass) return std::pair(0.0, now.slope);
    return std::pair(now.mass / mass - 1, now.slope / mass);
  };
  constexpr int k_bits = 50;    // of the rise
  std::uintmax_t passes = 200;  // bisection alone needs about 60 to reach rounding
  return sunk + boost::math::tools::newton_raphson_iterate(excess, 0.5 * height, 0.0, height, k_bits, passes);
}

FloatingEquilibrium floating_equilibrium(const geometry::Shape& shape, double mass, const Quat& start,
                                         const Water& water) {
  if (!(mass > 0)) throw InputError("a floating body needs a positive mass, not " + std::to_string(mass) + " kg");
  if (shape.kind == geometry::ShapeKind::plane) throw InputError("a half space does not float");
  FloatingShape body(shape);
  const double size = shape.bounding_radius;
  const double z_start = body.start_height(start.toRotationMatrix(), mass, water);
  const bool round = shape.kind == geometry::ShapeKind::sphere;  // rests at any attitude
  const auto height = [&](const VecX& x) { return z_start + size * x[0]; };
  const auto attitude = [&](const VecX& x) { return tilted(round ? Vec2(Vec2::Zero()) : Vec2(x.tail<2>()), start); };
  // The unknowns are the height over the body's size, and the tilt. The equations are buoyancy over weight, and the
  // lever of buoyancy over the size.
  const auto balance = [&](const VecX& x, VecX& f) {
    const Submerged wet = body.submerged(attitude(x), height(x), water.level);
    const double carried = water.density * wet.volume / mass;
    f[0] = carried - 1;
    if (!round) f.tail<2>() = carried / size * wet.centre.head<2>();
  };
  numerics::NonlinearSettings settings;
  settings.longest_step = 0.5;  // half a radius, or half a radian
  const numerics::NonlinearSolution solution = numerics::solve_nonlinear(balance, VecX::Zero(round ? 1 : 3), settings);
  if (!solution.converged)
    throw InputError("no floating equilibrium found from the given attitude: buoyancy and weight stay " +
                     std::to_string(solution.residual) + " of the weight or of the body's radius apart (" +
                     solution.message + ")");

  FloatingEquilibrium found;
  const Mat3 R = attitude(solution.x);
  const double z = height(solution.x);
  const Submerged wet = body.submerged(R, z, water.level);
  found.pose = {Quat(R), {0, 0, z}};
  found.draught = water.level - z - body.lowest(R);
  found.trim = -std::asin(std::clamp(R(2, 0), -1.0, 1.0));
  found.heel = std::atan2(R(2, 1), R(2, 2));
  found.volume = wet.volume;
  add_metacentres(body.cut(R, z, water.level), wet.centre.z() - z, R, found);
  return found;
}

}  // namespace nilas::hydro
