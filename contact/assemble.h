#pragma once
/// Assembles one step's contact problem from bodies, loads and contact points.
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "contact/elastic_contacts.h"
#include "contact/law/friction.h"
#include "contact/problem/problem.h"
#include "core/bodies/bodies.h"
#include "core/bodies/module.h"

namespace nilas::contact {

/// A body whose motion belongs to an articulated system. The twist (v; w) of its centre of mass in G is jacobian *
/// speeds + prescribed.
struct ArticulatedBody {
  int body = -1;
  MatX jacobian;                   ///< 6 x n
  Vec6 prescribed = Vec6::Zero();  ///< [m/s, rad/s]
};

/// An articulated system of one body or of several joined bodies, in its n coordinates. n may be 0.
struct ArticulatedBlock {
  std::vector<ArticulatedBody> bodies;
  MatX mass;  ///< n x n
  VecX f;     ///< n, mass * (speeds without contact)
};

/// The stabilisation inside the velocity problem. A point deeper than the slop gets u_N >= min(erp (depth - slop)/h,
/// max_speed). erp = 0 asks for nothing, 0 < erp < 1 is Baumgarte's stabilisation, and erp = 1 is that of Tasora and
/// Anitescu.
struct VelocityStabilisation {
  double erp = 0;
  double slop = 0;       ///< [m]
  double max_speed = 1;  ///< [m/s]
};

struct AssemblySettings {
  double h = 0;  ///< step [s]
  Law law = Law::coulomb;
  int facets = 8;                       ///< number of sides of pyramid_k
  double axes = 0;                      ///< angle by which the tangents are turned about the normal [rad]
  double restitution_threshold = 1e-3;  ///< a slower approach is inelastic, so that a series of bounces ends [m/s]
  VelocityStabilisation stabilisation = {};
};

/// The contact problem, and the data that lead from it back to the bodies.
struct AssembledContacts {
  ContactProblem problem;
  std::vector<Mat3> C;  ///< contact frames: columns n, t1, t2 in G; the impulse on body B is C r. For a moment: the
                        ///< same columns times its lengths; the couple on body B is C r
  std::vector<double> speed_asked;  ///< u_N that the stabilisation asks for at each point, 0 for none [m/s]
  std::vector<Spring> springs;      ///< of the points; empty where no contact is elastic
  std::vector<int> block_of_body;   ///< -1 for a body that no contact touches or that has no coordinate of its own.
                                    ///< Bodies of one system share a block, and all have it once one of them is touched
  int first_articulated_block =
      0;  ///< the blocks of free bodies come first, in the order of the bodies; articulated blocks follow

  bool is_elastic(std::size_t point) const { return !springs.empty() && springs[point].exists(); }
};

/// Returns one contact per point, in the order given. Only bodies that a point touches get a block. A free body's block
/// has the velocities (v; w) of its centre of mass in G. Its M is diag(m I, I_G) at the present pose, and
///   f = (m v + h F; I_G w + h T),
/// where `free` holds (F; T) including weight. f contains no w x I w: the pose update conserves L = I_G w, and the
/// gyroscopic effect enters there. Fixed bodies have no velocity.
///
/// The normal rows of w hold gap/h for gap > 0, so that the gap may close but not be crossed. For penetration they hold
/// minus the speed that the stabilisation asks for. Restitution e > 0 applies to a point that is closed, or would close
/// within the step (u_N^- h < -gap), faster than the threshold. Its row holds e u_N^- instead, where u_N^- is the
/// relative normal velocity before the step; then u_N^+ = -e u_N^-. All rows add the velocity of prescribed motion.
///
/// A point's force limit times h limits its impulse, and its compliance is that of its row. Points that crush do not
/// bounce. Moments against rolling and spinning follow all points, in their order, for pairs that have them and laws
/// with friction. `springs`: one per point, or none where no contact is elastic; a point with a spring has the rows of
/// elastic_contacts.h, and neither bounces nor is stabilised. A point between two bodies of one articulated system has
/// that block on its side B alone, with the difference of both Jacobians. `friction` resolves the materials of
/// `bodies`. Throws ContractError for an articulated body without its block and for a point that names no body.
AssembledContacts assemble(const bodies::Bodies& bodies, const bodies::Wrenches& free,
                           const std::vector<detect::ContactPoint>& points, const FrictionPairs& friction,
                           const AssemblySettings& settings, const std::vector<ArticulatedBlock>& articulated,
                           std::vector<Spring> springs = {});

}  // namespace nilas::contact
