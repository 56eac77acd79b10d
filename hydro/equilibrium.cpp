#include "hydro/equilibrium.h"

#include <cmath>
#include <string>

#include "core/base/error.h"
#include "hydro/mesh_water.h"

namespace nilas {

namespace {

constexpr double k_balance = 1e-12;  // |rho V - m| / m, above the rounding of V
constexpr int k_passes = 200;        // bisection alone needs about 60 down to rounding

/// Displaced mass and its slope over the height at one trial height.
struct Displacement {
  double mass = 0;   ///< [kg]
  double slope = 0;  ///< minus density times waterplane area [kg/m]
};

Displacement displacement(MeshWater& mesh, const Mat3& R, double z, const Water& water) {
  const Vec3 p(0, 0, z);
  const WaterPlane plane = water_plane(R, p, water.level);
  double area = 0;  // of the waterplane: it closes the wet surface
  mesh.for_each_wet_face(plane,
                         [&](double face, const Vec3&, const Vec3& normal) { area -= face * normal.dot(plane.up); });
  return {water.density * mesh.submerged(R, p, water.level).volume, -water.density * area};
}

}  // namespace

double floating_height(const TriangleMesh& mesh, const Mat3& R, double mass, const Water& water) {
  if (!(mass > 0)) throw InputError("a floating body needs a positive mass, not " + std::to_string(mass) + " kg");
  MeshWater prepared(mesh);
  const auto [bottom, top] = prepared.height_range({R.row(2).transpose(), 0});
  double sunk = water.level - top, dry = water.level - bottom;
  const double most = displacement(prepared, R, sunk, water).mass;
  if (mass > most * (1 + k_balance))
    throw InputError("the body would sink: its mass is " + std::to_string(mass) +
                     " kg, wholly under water it displaces " + std::to_string(most) + " kg");
  double z = sunk;
  for (int pass = 0; pass < k_passes; ++pass) {
    const Displacement now = displacement(prepared, R, z, water);
    const double excess = now.mass - mass;
    if (std::abs(excess) <= k_balance * mass) break;
    (excess > 0 ? sunk : dry) = z;
    const double newton = z - excess / now.slope;
    z = newton > sunk && newton < dry ? newton : 0.5 * (sunk + dry);
    if (z == sunk || z == dry) break;  // the heights are exhausted
  }
  return z;
}

}  // namespace nilas
