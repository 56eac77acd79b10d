#pragma once
/// Alternating directions with De Saxce's shift, a spectral penalty and one factorisation for many iterations.
///
/// In units of sqrt(J) (mass_scaled.h: W of mean unit diagonal, which is what keeps heavy and light contacts in step):
///   (W_s + (p + e) 1) x = (p + e) y - z - q - s - (W - W_s) y,   W_s = (W + W^T)/2,   s = mu |z_T| n
///   y <- P_K(x + z/p),   z <- z + p (x - y)
/// At a fixed point x = y and z = -(u + s). Law ccp has no s. p = sqrt(L e) (L/e)^k with L the largest eigenvalue of
/// W_s and e = 1e-6 L: k starts at 0.2, or as asked, and moves by 0.05 (p by a factor of two) while primal and dual
/// residual are more than ten apart; only then is the matrix factored again. (y, z/p) is accelerated (anderson.h); when
/// the fixed-point residual grows twofold, the best point is taken up again and plain iterations follow, twice as many
/// each time.
///
/// Cost per iteration: two triangular solves and a product with W. Iterations: 30 to 1000; few factorisations. Stalls
/// where slipping contacts are redundant. Force limit and compliance are honoured.
/// Sources: Boyd et al. 2011 (ADMM); Carpentier, Le Lidec, Montaut 2024 (contact, spectral rule); De Saxce, Feng 1998.
///
/// Nominal tolerances: 1e-6 m/s, 1e-9 m/s where it does not stall. Islands are solved apart.
#include "contact/solvers/solver.h"

namespace nilas::solvers {

struct AdmmSettings {
  contact::SolverSettings shared;
  int anderson_depth = 10;      ///< 0: no acceleration
  int stall_iterations = 1000;  ///< window of the stall rule (best_impulses.h); share 0.9
  double first_exponent = 0.2;  ///< k of the penalty
  /// stalled: two iterations left more than this share of law_map; it is then measured in each. 0: not asked for.
  double least_fall = 0;
};

class AdmmSolver final : public IslandSolver {
 public:
  explicit AdmmSolver(const AdmmSettings& settings) : IslandSolver(settings.shared), settings_(settings) {}
  std::string name() const override { return "admm"; }
  /// converged: law_map_m_s as `measure` finds it is at most the tolerance in every island. The best impulses measured
  /// are returned whatever the status. Throws InputError for laws other than coulomb, ccp and frictionless.
  void demand_law(Law law) const override;
  contact::ContactSolution solve_island(const contact::LocalProblem& island, const VecX& guess,
                                        const contact::SolverSettings& shared, const Budget& budget) const override;

 private:
  AdmmSettings settings_;
};

}  // namespace nilas::solvers
