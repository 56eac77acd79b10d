#pragma once
/// From bodies, loads and contact points to one step's contact problem.
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "contact/law/friction.h"
#include "contact/problem/problem.h"
#include "core/bodies/bodies.h"
#include "core/bodies/module.h"

namespace nilas {

/// A body whose motion belongs to another system: twist (v; w) of its centre of mass in G = jacobian * speeds +
/// prescribed.
struct ArticulatedBody {
  int body = -1;
  MatX jacobian;                   ///< 6 x n
  Vec6 prescribed = Vec6::Zero();  ///< [m/s, rad/s]
};

/// Such a system, in its n coordinates (n may be 0): one body or several that are joined.
struct ArticulatedBlock {
  std::vector<ArticulatedBody> bodies;
  MatX mass;  ///< n x n
  VecX f;     ///< n, mass * (speeds without contact)
};

/// What the velocity problem itself asks of a point deeper than the slop: u_N >= min(erp (depth - slop)/h, max_speed).
/// Nothing at erp 0; Baumgarte's stabilisation at a share, that of Tasora and Anitescu at 1.
struct VelocityStabilisation {
  double erp = 0;
  double slop = 0;       ///< [m]
  double max_speed = 1;  ///< [m/s]
};

struct AssemblySettings {
  double h = 0;  ///< step [s]
  Law law = Law::coulomb;
  int facets = 8;                       ///< of pyramid_k
  double axes = 0;                      ///< turns the tangents about the normal [rad]
  double restitution_threshold = 1e-3;  ///< slower approach is inelastic, so that a series of bounces ends [m/s]
  VelocityStabilisation stabilisation = {};
};

/// The problem and what is needed to go back from it to bodies.
struct AssembledContacts {
  ContactProblem problem;
  std::vector<Mat3> C;              ///< per contact: columns n, t1, t2 in G; impulse on body B = C r. Of a moment: the
                                    ///< same columns times its lengths; couple on body B = C r
  std::vector<double> speed_asked;  ///< per point: u_N that the stabilisation asks for, 0: nothing [m/s]
  std::vector<int> block_of_body;   ///< -1: touched by no contact, or without a coordinate of its own; bodies of one
                                    ///< system share a block, and have it once one of them is touched
  int first_articulated_block =
      0;  ///< free bodies' blocks come first, in the order of the bodies; articulated ones last
};

/// One contact per point, in the order given. Only bodies that a point touches get a block. A free body's block has the
/// velocities (v; w) of its centre of mass in G, M = diag(m I, I_G) at the present pose and
///   f = (m v + h F; I_G w + h T),
/// `free` being (F; T) with weight. There is no w x I w in f: the pose update conserves L = I_G w, and that is where
/// the gyroscopic effect enters. Fixed bodies have no velocity.
///
/// Normal rows of w: gap/h for gap > 0, so that the gap may close but not be crossed; for penetration minus the speed
/// that the stabilisation asks for. With restitution e > 0, for a point that is closed or would close within the step
/// (u_N^- h < -gap) faster than the threshold, e u_N^- instead, u_N^- being the relative normal velocity before the
/// step: then u_N^+ = -e u_N^-.
/// A point's force limit times h limits its impulse; its compliance is that of its row. Points that crush do not
/// bounce. Moments against rolling and spinning follow all points, in their order, for pairs that have them and laws
/// with friction. A point between two bodies of one articulated system has that block on its side B alone, with the
/// difference of both Jacobians. All rows: what prescribed motion adds. `friction` resolves the materials of `bodies`.
/// Throws ContractError for an articulated body without its block and for a point that names no body.
AssembledContacts assemble(const Bodies& bodies, const Wrenches& free, const std::vector<ContactPoint>& points,
                           const FrictionPairs& friction, const AssemblySettings& settings,
                           const std::vector<ArticulatedBlock>& articulated);

}  // namespace nilas
