#include "core/numerics/quadratic_program.h"

#include <libalglib/optimization.h>

#include "core/base/error.h"

namespace nilas::numerics {

namespace {

alglib::real_1d_array alglib_array(const VecX& x) {
  alglib::real_1d_array a;
  a.setcontent(x.size(), x.data());
  return a;
}

alglib::real_2d_array alglib_array(const MatX& x) {
  alglib::real_2d_array a;
  const MatX by_rows = x.transpose();  // ALGLIB takes rows after rows
  a.setcontent(x.rows(), x.cols(), by_rows.data());
  return a;
}

bool fits(const QuadraticProgram& p) {
  const auto n = p.g.size();
  return n > 0 && p.H.rows() == n && p.H.cols() == n && p.lower.size() == n && p.upper.size() == n &&
         (p.lower.array() <= p.upper.array()).all() && (p.rows.rows() == 0 || p.rows.cols() == n) &&
         p.least.size() == p.rows.rows() && p.most.size() == p.rows.rows() && (p.least.array() <= p.most.array()).all();
}

}  // namespace

QuadraticSolution solve_quadratic_program(const QuadraticProgram& program) {
  NILAS_DEMAND(fits(program));
  QuadraticSolution solution;
  solution.x = VecX::Zero(program.g.size()).cwiseMax(program.lower).cwiseMin(program.upper);
  try {
    alglib::minqpstate state;
    alglib::minqpcreate(program.g.size(), state);
    alglib::minqpsetquadraticterm(state, alglib_array(program.H));
    alglib::minqpsetlinearterm(state, alglib_array(program.g));
    alglib::minqpsetbc(state, alglib_array(program.lower), alglib_array(program.upper));
    alglib::minqpsetscale(state, alglib_array(VecX(VecX::Ones(program.g.size()))));
    if (program.rows.rows() > 0) {
      alglib::minqpsetlc2dense(state, alglib_array(program.rows), alglib_array(program.least),
                               alglib_array(program.most));
      alglib::minqpsetalgodenseipm(state, 0);  // 0: the library's own, near rounding
    } else {
      alglib::minqpsetstartingpoint(state, alglib_array(solution.x));
      alglib::minqpsetalgoquickqp(state, 0, 0, 0, 0, true);
    }
    alglib::minqpoptimize(state);
    alglib::real_1d_array x;
    alglib::minqpreport report;
    alglib::minqpresults(state, x, report);
    solution.converged = report.terminationtype > 0;
    if (!solution.converged) solution.message = "ALGLIB ended with code " + std::to_string(report.terminationtype);
    for (Eigen::Index k = 0; k < solution.x.size(); ++k) solution.x[k] = x[k];
  } catch (const alglib::ap_error& fault) {
    solution.message = fault.msg;
  }
  solution.converged = solution.converged && solution.x.allFinite();
  // Interior points end within rounding of a bound, on either side.
  if (solution.converged) solution.x = solution.x.cwiseMax(program.lower).cwiseMin(program.upper);
  return solution;
}

double objective(const QuadraticProgram& program, const VecX& x) {
  return 0.5 * x.dot(program.H * x) + program.g.dot(x);
}

}  // namespace nilas::numerics
