#pragma once
/// One point of contact between two bodies, as the narrow phase finds it.
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/math.h"

namespace nilas::detect {

struct ContactPoint {
  int a = -1;      ///< index of the body with the lower id
  int b = -1;      ///< index of the other body
  int part_a = 0;  ///< convex part of A
  int part_b = 0;
  Vec3 p = Vec3::Zero();   ///< midway between the two surfaces, in G [m]
  Vec3 n = Vec3::UnitX();  ///< unit normal from A to B, in G
  double gap = 0;          ///< signed distance along n: > 0 apart, < 0 penetration [m]
  double force_limit =
      std::numeric_limits<double>::infinity();  ///< limit of the normal force, finite where ice crushes [N]
  double pressure = 0;    ///< pressure of the ice that the normal force crushes, 0 where none does [Pa]
  double compliance = 0;  ///< compliance of such a point: u_N + c r_N replaces u_N [m/(s N s)]
  std::uint64_t key =
      0;  ///< hash of the ids of bodies, the parts and the touching features; it lasts as long as the features do

  /// Returns whether ice crushes here; then there is no rebound and no position correction.
  bool crushes() const { return std::isfinite(force_limit); }
};

}  // namespace nilas::detect
