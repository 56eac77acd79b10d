#pragma once
/// Split impulse: pseudo velocities that move bodies out of each other without entering their momentum. Articulated
/// bodies stand still in it, however light.
#include <vector>

#include "contact/assemble.h"
#include "contact/detect/broad/contact_point.h"
#include "core/base/math.h"

namespace nilas {

struct CorrectionSettings {
  double h = 0;             ///< step [s]
  double erp = 0.2;         ///< share of the penetration beyond the slop that one step removes
  double slop = 0;          ///< penetration left alone [m]
  double max_speed = 1;     ///< of the separation [m/s]
  double tolerance = 1e-4;  ///< on u_N; 1e-4 m/s is 1 um in a step of 0.01 s [m/s]
  int max_sweeps = 50;      ///< or factorisations and extragradient steps
  /// By newton-order-free instead of Gauss-Seidel: the bits depend neither on the order of contacts and bodies nor, but
  /// for the sign, on a mirror.
  bool order_free = false;
};

struct PositionCorrection {
  VecX v;                 ///< nv pseudo velocities in the layout of the contact problem's blocks
  int contacts = 0;       ///< that took part
  bool converged = true;  ///< natural map of u_N against the least speeds at most the tolerance
  int sweeps = 0;         ///< or steps; most of any group
};

/// Solves, without friction and from rest, for the smallest motion with
///   u_N >= min(erp (depth - slop)/h, max_speed)  where depth > slop,
///   u_N >= -gap/h for gap > 0, u_N >= 0 for the other closed points,
/// so that what is pushed out of one body is not pushed into the next, by projected Gauss-Seidel on the normal rows in
/// mass-scaled velocities (solvers/pgs_rows.h), or as a frictionless ContactProblem. Groups of bodies (joined by
/// contact points, not through immovable ones nor by points that crush, which take no part) without a depth beyond slop
/// + tolerance h/erp are left out. `points` are those that `contacts` was assembled from.
PositionCorrection position_correction(const AssembledContacts& contacts, const std::vector<ContactPoint>& points,
                                       const CorrectionSettings& settings);

/// The same, written per body: v, w of the free bodies' centres of mass in G; entries of other bodies stay as they are.
PositionCorrection correction_velocities(const AssembledContacts& contacts, const std::vector<ContactPoint>& points,
                                         const CorrectionSettings& settings, std::vector<Vec3>& v,
                                         std::vector<Vec3>& w);

}  // namespace nilas
