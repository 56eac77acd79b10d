#pragma once
/// Primal-dual interior point for the convex contact problem: K* contains u, perpendicular to r in K, u = W r + b.
///
/// It is the optimality of min 1/2 r.W r + b.r over the cones, W symmetric positive semidefinite, in units of sqrt(J)
/// (mass_scaled.h). Per contact, in cones of slope one (x = S^-1 r, z = S (u + l n), S = diag(1, mu, mu), or
/// diag(1/mu, 1, 1) for mu > 1), with a slack s and multiplier m = S_0 l of the limit where there is one:
///   z = A x + S b + m n,   x_0 + s = cap/S_0,   x o z = t e,   s m = t,   x and z in {x_0 >= |x_T|},   s, m >= 0
/// t falls to zero by Mehrotra's predictor and corrector. dz = g - P^2 dx with the scaling P of Nesterov and Todd
/// (second_order_cone.h) leaves one symmetric system (A + P^2 + (m/s) n n^T) dx = rhs per iteration, factored once and
/// solved twice in the coordinates P dx (block_cholesky.h). mu = 0 is a half line: its tangential rows stay zero.
///
/// Iterations: 10 to 30, whatever the masses. The map of an iterate is about its gap where states are strict, the root
/// of it where they are not: there rounding ends progress near 1e-7 of the largest velocity.
/// Sources: Nesterov, Todd 1998; Mehrotra 1992; Andersen, Roos, Terlaky 2003 (the predictor and corrector on cones).
#include <vector>

#include "contact/solvers/linear/block_cholesky.h"
#include "contact/solvers/shared/budget.h"
#include "contact/solvers/shared/mass_scaled.h"
#include "contact/solvers/shared/second_order_cone.h"

namespace nilas::solvers {

/// Strictly inside all cones.
struct InteriorIterate {
  VecX x, z;               ///< 3 nc each [sqrt(J)]
  VecX slack, multiplier;  ///< nc; 1 and 0 without a limit [sqrt(J)]
};

class InteriorPoint {
 public:
  explicit InteriorPoint(const MassScaled& problem);

  struct Outcome {
    int iterations = 0;
    double map_m_s = 0;  ///< natural-map residual of the convex problem at the iterate
    bool finite = true;
  };
  /// A point on no particular path, of the size of b.
  InteriorIterate cold_start(const VecX& b) const;
  /// The iterate moved inside the cones by `distance` [sqrt(J)].
  InteriorIterate shifted(const InteriorIterate& iterate, double distance) const;
  /// Runs until the map is at most `tolerance` [m/s], it stops falling, or the budget is used up. Leaves the best
  /// iterate there.
  Outcome minimise(const VecX& b, double tolerance, const Budget& budget, InteriorIterate& iterate);
  /// r' of an iterate.
  VecX impulses(const InteriorIterate& iterate) const;

 private:
  /// Steps in the scaling's coordinates, where x and z are the same point: P dx and P^-1 dz.
  struct Direction {
    VecX x, z, slack, multiplier;
  };
  struct Right {
    VecX g;     ///< P dx + P^-1 dz
    VecX line;  ///< s dl + l ds
  };
  bool has_tangent(int a) const { return problem_.mu[a] > 0; }
  bool has_cap(int a) const;
  NesterovTodd scaling_at(const InteriorIterate& at, int a) const;
  bool factor(const InteriorIterate& at);
  double gap(const InteriorIterate& at) const;
  double gap_after(const InteriorIterate& at, const Direction& d, double step) const;
  Right predictor(const InteriorIterate& at) const;
  Right corrector(const InteriorIterate& at, const Direction& affine, double target) const;
  Direction direction(const InteriorIterate& at, const VecX& scaled_b, const Right& right) const;
  double longest_step(const InteriorIterate& at, const Direction& d) const;
  InteriorIterate moved(const InteriorIterate& at, const Direction& d, double step) const;

  const MassScaled& problem_;
  VecX slope_;  ///< S, 3 nc; 0 on the tangents of half lines
  VecX cap_;    ///< caps of x_0, nc
  Eigen::SparseMatrix<double> a_;
  BlockCholesky factor_;
  std::vector<NesterovTodd> nt_;
};

}  // namespace nilas::solvers
