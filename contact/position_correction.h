#pragma once
/// Split impulse: pseudo velocities that separate overlapping bodies without entering their momentum. Articulated
/// bodies, however light, do not move in it.
#include <vector>

#include "contact/assemble.h"
#include "contact/detect/broad/contact_point.h"
#include "core/base/math.h"

namespace nilas::contact {

struct CorrectionSettings {
  double h = 0;             ///< step [s]
  double erp = 0.2;         ///< share of the penetration beyond the slop that one step removes
  double slop = 0;          ///< penetration left alone [m]
  double max_speed = 1;     ///< largest speed of separation [m/s]
  double tolerance = 1e-4;  ///< tolerance on u_N [m/s]; 1e-4 m/s is 1 um in a step of 0.01 s
  int max_sweeps = 50;      ///< limit of sweeps, or with `order_free` of factorisations and of extragradient steps
  /// Uses newton-order-free instead of Gauss-Seidel. The bits then do not depend on the order of contacts and bodies. A
  /// mirror changes only signs.
  bool order_free = false;
  /// Finishes by newton, in large groups on the bodies, what the sweeps leave short of the tolerance. Otherwise the
  /// sweeps' result stays.
  bool finish = false;
};

struct PositionCorrection {
  VecX v;                 ///< nv pseudo velocities in the layout of the contact problem's blocks
  int contacts = 0;       ///< number of contacts that took part
  bool converged = true;  ///< the natural map of u_N against the required speeds is at most the tolerance
  int sweeps = 0;         ///< largest number of sweeps of any group, or of steps with `order_free`
  int finished = 0;       ///< number of groups that the sweeps left short and that were finished
};

/// Solves, without friction and from rest, for the smallest motion with
///   u_N >= min(erp (depth - slop)/h, max_speed)  where depth > slop,
///   u_N >= -gap/h for gap > 0, u_N >= 0 for the other closed points,
/// so that a body pushed out of one body is not pushed into the next. The method is projected Gauss-Seidel on the
/// normal rows in mass-scaled velocities (solvers/shared/pgs_rows.h), or a frictionless ContactProblem. Sweeps need
/// thousands of rounds where heavy bodies press through light ones; there newton takes a few factorisations, or the
/// interior point on the bodies (solvers/body_ladder.h) a few iterations. Bodies form groups that are joined by contact
/// points, but not through immovable bodies. Points that crush or are elastic take no part. Groups without a depth
/// above slop + tolerance h/erp are left out. `points` are those from which `contacts` was assembled.
PositionCorrection position_correction(const AssembledContacts& contacts,
                                       const std::vector<detect::ContactPoint>& points,
                                       const CorrectionSettings& settings);

/// The position correction, written per body: v and w of the free bodies' centres of mass in G. Entries of other bodies
/// stay unchanged.
PositionCorrection correction_velocities(const AssembledContacts& contacts,
                                         const std::vector<detect::ContactPoint>& points,
                                         const CorrectionSettings& settings, std::vector<Vec3>& v,
                                         std::vector<Vec3>& w);

}  // namespace nilas::contact
