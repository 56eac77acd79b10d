#pragma once
/// Interior point with a De Saxce outer loop and a Newton finish: for extreme mass ratios and hyperstatic stacks.
///
///   inner (interior_point.h):  K* contains u, perpendicular to r in K, u = (W + W^T)/2 r + b
///   outer:                     b <- q + mu |u_T| n + (W - W^T)/2 r,   u = W r + q
/// The inner problem is convex; its solution is one of the outer law when b repeats itself. Law ccp has no mu |u_T|; a
/// symmetric W has no last term. The outer fixed point is accelerated (anderson.h), each inner solve starts from the
/// last iterate moved inside the cones. Because an iterate's map is the root of its gap where a contact is between two
/// states, and rounding ends the inner solve near 1e-7, each outer round ends with a few Newton steps on the exact law
/// (newton_finish.h); what they reach is kept if `measure` finds it better.
///
/// Cost: 10 to 30 factorisations of W + block diagonal for the first round, 5 to 15 for each later one, whatever the
/// masses; rounds: 1 to 15. Contraction of the outer loop needs mu times the coupling of slip and normal velocity below
/// one: large mu with many sliding contacts may stall (1 of 300 random heaps at mu 0.3 to 1). Force limit and
/// compliance are honoured.
///
/// Sources: De Saxce, Feng 1998; Acary, Cadoux, Lemarechal, Malick 2011 (outer loop); those of the headers named.
///
/// Nominal tolerances: 1e-9 m/s. Islands are solved apart.
#include "contact/solvers/solver.h"

namespace nilas::solvers {

struct IpmSettings {
  contact::SolverSettings shared;  ///< max_iterations counts factorisations, inner and Newton's
  int max_rounds = 60;             ///< most rounds of the outer loop
  int stall_rounds = 20;           ///< window of the stall rule (best_impulses.h), in rounds; share 0.5
  int finish_iterations = 20;      ///< Newton's factorisations per round; 0: none
};

class IpmSolver final : public IslandSolver {
 public:
  explicit IpmSolver(const IpmSettings& settings) : IslandSolver(settings.shared), settings_(settings) {}
  std::string name() const override { return "ipm"; }
  /// converged: law_map_m_s as `measure` finds it is at most the tolerance in every island. The best impulses seen are
  /// returned whatever the status. Throws InputError for laws other than coulomb, ccp and frictionless.
  void demand_law(Law law) const override;
  contact::ContactSolution solve_island(const contact::LocalProblem& island, const VecX& guess,
                                        const contact::SolverSettings& shared, const Budget& budget) const override;

 private:
  IpmSettings settings_;
};

}  // namespace nilas::solvers
