#pragma once
/// Proximal semismooth Newton: the reference solver.
///
///   outer:  r_0 = r;  solve the law for u + a d (r - r_0) with inner steps;  a falls while that goes well, else rises
///   inner:  (U (W + a d) + R) dr = -F,  r <- r + dr; when |F| has not fallen for some steps, from the best r on
///           r <- r + t dr,  t = 1, 1/2, 1/4, ... until |F| falls
///
/// F is the map of law_slopes.h in units of sqrt(J), d_a = (trace(W_aa) + c_a)/3, and the systems are those of
/// newton/newton_system.h. The term a d (r - r_0) makes the rank-deficient W of hyperstatic contact regular and
/// vanishes at the solution: where Newton gets caught at a kink, the neighbouring problem of a larger a does not, and
/// its solution lies nearer. Undamped steps cross kinks that a line search stops at: they come first. Cost per
/// iteration: one sparse factorisation of the contacts that carry impulses (about 1 ms for 2000 contacts of a loose ice
/// field, 15 ms for 4600 of a jam). Use it for accuracy, stacks, hyperstatic contact and mass ratios, with a few sweeps
/// of nsgs before it when started cold. Sources: Alart & Curnier 1991; Rockafellar 1976 (proximal point); Qi & Sun 1993
/// (semismooth Newton); Acary, Bremond, Huber 2018 (the two together).
///
/// Stall: no window. It has stalled when |F| is rounding, or when three times even the largest a did not help.
///
/// Laws: all. Nominal tolerances: 1e-6 m/s in simulations, 1e-10 m/s as a reference. Islands are solved apart.
#include "contact/solvers/newton/newton_system.h"
#include "contact/solvers/solver.h"

namespace nilas::solvers {

struct NewtonSettings {
  contact::SolverSettings shared;
  double first_weight = 1e-3;   ///< a at the start [-]
  double least_weight = 1e-13;  ///< least a; below it a is lost in rounding against W', whose diagonal is about 1 [-]
  double plunge = 0.01, fall = 0.3;  ///< factors of the weight after a good inner solve in very few or few steps
  double inner_share = 1e-2;         ///< an inner solve ends when |F| fell to this share
  int inner_steps = 30;              ///< most Newton steps of one inner solve
  int free_steps = 10;               ///< undamped steps in a row that may pass without |F| falling to half
  int halvings = 10;                 ///< halvings of t before the inner solve ends
  int max_factorisations = 400;      ///< most factorisations per island
  bool order_free = false;           ///< order-free sums and steps, see newton/delassus_system.h
};

class NewtonSolver final : public IslandSolver {
 public:
  explicit NewtonSolver(const NewtonSettings& settings) : IslandSolver(settings.shared), settings_(settings) {}
  std::string name() const override { return "newton"; }
  /// converged: every island's law_map_m_s is at most the tolerance, as `measure` finds it on the impulses returned.
  /// iterations: factorisations of the island that took most. stalled, iteration_limit: the impulses are the best
  /// found. numerical_error: input that is not finite, or a contact that closes, cannot move and has no force limit.
  contact::ContactSolution solve_island(const contact::LocalProblem& island, const VecX& guess,
                                        const contact::SolverSettings& shared, const Budget& budget) const override;

 private:
  NewtonSettings settings_;
};

/// The same for one island, as a stage of a solve that runs.
contact::ContactSolution newton_island(const contact::LocalProblem& island, const VecX& guess,
                                       const NewtonSettings& settings, const Budget& budget);

/// The method on systems of either form. `guess`: 3 nc impulses, or empty.
contact::ContactSolution newton_on(NewtonSystem& system, const VecX& guess, const NewtonSettings& settings,
                                   const Budget& budget);

}  // namespace nilas::solvers
