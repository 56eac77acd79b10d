#pragma once
/// The residuals by which any impulses on any problem are judged, independent of all solvers. Formulas:
/// docs/theory/contact.md.
#include "contact/problem/local_problem.h"
#include "contact/problem/prepared_problem.h"
#include "contact/problem/problem.h"

namespace nilas::contact {

/// d_a = trace(W_aa)/3 and m_a = 1/d_a scale impulses to velocities, so every length below is in m/s.
struct Residuals {
  double law_map_m_s = 0;      ///< natural-map residual of the law asked for; every solver stops on it
  double natural_map_m_s = 0;  ///< max over contacts of the distance from exact Coulomb
  double natural_map_rms_m_s = 0;
  double ccp_map_m_s = 0;
  double penetration_rate_m_s = 0;
  double complementarity_J = 0;
  double cone_violation_m_s = 0;
  double slip_angle_deg = 0;
  double creep_m_s = 0;
  double bipotential_J = 0;
  double momentum_sqrtJ = 0;
};

/// Returns the residuals of impulses r with the velocities v that belong to them: the same bits for any `threads`.
Residuals measure(const PreparedProblem& prepared, const VecX& r, const VecX& v, int threads = 1);
/// The same with v = M^-1 (f + H r).
Residuals measure(const PreparedProblem& prepared, const VecX& r);

/// The same. Also writes d_a of every contact [1/kg], 0 for a moment, to `d`, which impulse_residual() takes.
Residuals measure(const PreparedProblem& prepared, const VecX& r, const VecX& v, std::vector<double>& d,
                  int threads = 1);

/// Returns law_map_m_s alone, for impulses r with v = M^-1 (f + H r): the bits of `measure` at a third of its cost.
double largest_law_map(const PreparedProblem& prepared, const VecX& r, int threads = 1);

/// Prepares the problem first.
Residuals measure(const ContactProblem& problem, const VecX& r, const VecX& v);
/// The same with v = M^-1 (f + H r).
Residuals measure(const ContactProblem& problem, const VecX& r);

/// Residuals of impulses r; momentum_sqrtJ is zero, since nothing can be out of balance.
Residuals measure(const LocalProblem& problem, const VecX& r);

/// Names and values in the order of the output columns.
struct NamedResidual {
  const char* name;
  double Residuals::*member;
};
const std::vector<NamedResidual>& residual_columns();

}  // namespace nilas::contact
