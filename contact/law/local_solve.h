#pragma once
/// One contact solved exactly with all others held: the impulse r of a law for u = A r + b.
///
///   A = W_aa + diag(c_N, c_T, c_T) (3 x 3, normal first; may be slightly asymmetric) [1/kg],   b = u - A r with r the
///   old impulse coulomb, slipping:  u_N = 0,  u_T = -x r_T,  |r_T| = mu r_N,  x >= 0 the one unknown:
///     (S + x I) r_T = -s,  r_N = -(b_N + A_NT r_T)/A_NN,  S = A_TT - A_TN A_NT/A_NN,  s = b_T - A_TN b_N/A_NN
///   and mu r_N / |r_T| rises from below 1 at x = 0 (or the contact sticks) to infinity, nearly along a line, which
///   makes Newton's steps inside a bracket quick. One root when mu |A_NT|/A_NN is small; else the root found is one of
///   several. Other laws: r_T is the exact answer of the disc, square or polygon mu r_N P for a given r_N, and r_N the
///   root of
///     u_N (pyramids, and Coulomb at its limit)   or   u_N - mu |u_T| (ccp: the derivative of a convex function).
///
/// Directions that cannot move (A_TT singular) count as moving by 1e-15 of the trace: nothing that rounding can see.
/// Sources: Bonnefon & Daviet 2011 for the single contact; More & Sorensen 1983 for the iteration in x.
/// Nominal accuracy: law_map 1e-14 of (1 + mu) |b| + d |r| on blocks of rigid bodies.
#include "contact/law/law_map.h"

namespace nilas::contact {

/// The data of a contact that stay constant while other contacts change.
struct ContactBlock {
  ContactBlock() = default;
  ContactBlock(const Mat3& w, double mu, double force_limit, double compliance, double tangential_compliance);

  double nn = 0;                   ///< A_NN
  double inverse_nn = 0;           ///< 1/A_NN, 0 when nothing yields along the normal
  double nt[2] = {0, 0};           ///< A_NT, row
  double tn[2] = {0, 0};           ///< A_TN, column
  double tt[4] = {0, 0, 0, 0};     ///< A_TT, by rows
  double schur[4] = {0, 0, 0, 0};  ///< S, by rows
  double stick[3] = {0, 0, 0};     ///< S + x_min I as triangles: 1/pivot, the row's multiple, 1/(second pivot)
  double x_min = 0;                ///< stands for sticking [1/kg]
  double mu = 0;
  double force_limit = 0;

  /// b = u - A r for the compliant velocity u that r has now.
  Vec3 without(const Vec3& r, const Vec3& u) const {
    return {u[0] - (nn * r[0] + nt[0] * r[1] + nt[1] * r[2]), u[1] - (tn[0] * r[0] + tt[0] * r[1] + tt[1] * r[2]),
            u[2] - (tn[1] * r[0] + tt[2] * r[1] + tt[3] * r[2])};
  }
};

/// Roots are as good as rounding when their equation holds to this.
constexpr double k_root_accuracy = 4e-16;
/// Newton's next step squares an error as small as this: its straight line is then as good as another evaluation.
constexpr double k_nearly_root = 1e-9;
/// Enough within sweeps: what is left is the square of what the next visit of the contact would change anyway.
constexpr double k_nearly_root_in_sweeps = 1e-2;

/// The start of the iteration: the last answer for the same contact, or zeros.
struct ContactStart {
  double slip = 0;    ///< x of the last slipping state [1/kg]
  double normal = 0;  ///< last r_N [N s]
};

/// The impulse that answers b. A contact that closes and cannot yield gets its force limit, or 0 if it has none.
Vec3 solve_contact(Law law, int facets, const ContactBlock& block, const Vec3& b, ContactStart& start);
/// Returns that impulse for Coulomb's law.
Vec3 solve_coulomb(const ContactBlock& block, const Vec3& b, ContactStart& start, double nearly_root = k_nearly_root);

/// r_T of the disc |r_T| <= radius that answers the tangential velocities `free` that r_T = 0 leaves.
Vec2 solve_disc(const ContactBlock& block, const Vec2& free, double radius, ContactStart& start);

/// The moment (S, R1, R2) of a contact with normal impulse r_N that answers b: |r_S| <= r_N, and |r_R| <= r_N, or each
/// |r_Ri| <= r_N with `boxes`. One pass over S, then R, from `old`: exact once repeated visits leave it unchanged.
Vec3 solve_moment(const ContactBlock& block, const Vec3& b, double normal, const Vec3& old, bool boxes,
                  ContactStart& start);

/// Solves a contact like solve_contact, at the accuracy that sweeps need. It is exact where no last slip is known, so
/// that a good guess is kept.
inline Vec3 solve_in_sweep(Law law, int facets, const ContactBlock& block, const Vec3& b, ContactStart& start) {
  if (law == Law::coulomb && block.inverse_nn > 0)
    return solve_coulomb(block, b, start, start.slip > block.x_min ? k_nearly_root_in_sweeps : k_nearly_root);
  return solve_contact(law, facets, block, b, start);
}

}  // namespace nilas::contact
