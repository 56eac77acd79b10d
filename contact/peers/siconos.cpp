#include "contact/peers/siconos.h"

#include <siconos/numerics/CSparseMatrix.h>
#include <siconos/numerics/FrictionContactProblem.h>
#include <siconos/numerics/Friction_cst.h>
#include <siconos/numerics/NonSmoothDrivers.h>
#include <siconos/numerics/NumericsMatrix.h>
#include <siconos/numerics/NumericsSparseMatrix.h>
#include <siconos/numerics/NumericsVerbose.h>
#include <siconos/numerics/SolverOptions.h>
#include <siconos/numerics/SparseBlockMatrix.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "core/base/error.h"

namespace nilas::contact {

namespace {

constexpr double k_first_relative = 1e-4;
constexpr double k_last_relative = 0.9e-16;
constexpr double k_ladder_factor = 1e-2;

struct FreeMatrix {
  void operator()(NumericsMatrix* matrix) const { static_cast<void>(NM_free(matrix)); }
};
using Matrix = std::unique_ptr<NumericsMatrix, FreeMatrix>;

struct DeleteOptions {
  void operator()(SolverOptions* options) const { solver_options_delete(options); }
};

Matrix sparse_operator(const LocalProblem& problem) {
  const int rows = 3 * problem.num_contacts();
  Matrix matrix(NM_create(NM_SPARSE, rows, rows));
  NM_triplet_alloc(matrix.get(), static_cast<CS_INT>(9 * problem.block.size()));
  matrix->matrix2->origin = NSM_TRIPLET;
  for (int a = 0; a < problem.num_contacts(); ++a)
    for (int k = problem.row_start[a]; k < problem.row_start[static_cast<std::size_t>(a) + 1]; ++k) {
      const int b = problem.column[k];
      Mat3 block = problem.block[k];
      if (a == b) {
        const double tangential = problem.tangential_compliance[a];
        block.diagonal() += Vec3(problem.compliance[a], tangential, tangential);
      }
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) NM_entry(matrix.get(), 3 * a + i, 3 * b + j, block(i, j));
    }
  return matrix;
}

/// The 3 x 3 blocks that Siconos' sweeps expect.
Matrix block_operator(const Matrix& sparse) {
  Matrix matrix(NM_create(NM_SPARSE_BLOCK, sparse->size0, sparse->size1));
  if (matrix->matrix1 == nullptr) matrix->matrix1 = SBM_new();
  SBM_from_csparse(3, NM_csc(sparse.get()), matrix->matrix1);
  return matrix;
}

int solver_id(SiconosMethod method) {
  switch (method) {
    case SiconosMethod::nsgs:
      return SICONOS_FRICTION_3D_NSGS;
    case SiconosMethod::nsn_ac:
      return SICONOS_FRICTION_3D_NSN_AC;
    case SiconosMethod::prox:
      return SICONOS_FRICTION_3D_PROX;
    case SiconosMethod::admm:
      return SICONOS_FRICTION_3D_ADMM;
  }
  return SICONOS_FRICTION_3D_NSGS;
}

/// One run of Siconos' driver.
ContactSolution run_once(const LocalProblem& local, const VecX& guess, const SiconosSettings& settings,
                         double relative) {
  // the driver may change its problem, so every run gets its own
  Matrix matrix = sparse_operator(local);
  if (settings.method == SiconosMethod::nsgs) matrix = block_operator(matrix);
  VecX q = local.q, r = guess.size() > 0 ? guess : VecX(VecX::Zero(q.size())), u = VecX::Zero(q.size());
  std::vector<double> mu = local.mu;
  FrictionContactProblem problem{};
  problem.dimension = 3;
  problem.numberOfContacts = local.num_contacts();
  problem.M = matrix.get();
  problem.q = q.data();
  problem.mu = mu.data();
  const std::unique_ptr<SolverOptions, DeleteOptions> options(solver_options_create(solver_id(settings.method)));
  options->dparam[SICONOS_DPARAM_TOL] = relative;
  options->iparam[SICONOS_IPARAM_MAX_ITER] = settings.shared.max_iterations;
  numerics_set_verbose(0);
  const int info = fc3d_driver(&problem, r.data(), u.data(), options.get());
  ContactSolution out;
  out.iterations = options->iparam[SICONOS_IPARAM_ITER_DONE];
  out.status = info == 0 ? SolveStatus::stalled : SolveStatus::iteration_limit;
  out.r = r;
  if (!r.allFinite()) {
    out.status = SolveStatus::numerical_error;
    out.message = "Siconos returned impulses that are not finite";
    out.r.setZero();
  } else if (measure(local, r).law_map_m_s <= settings.shared.tolerance) {
    out.status = SolveStatus::converged;
  }
  return out;
}

std::string in_words(double relative) {
  char text[48];
  std::snprintf(text, sizeof text, "relative tolerance %.0e", relative);
  return text;
}

/// Runs down the ladder of relative tolerances, always from the same guess.
ContactSolution climb(const LocalProblem& problem, const VecX& guess, const SiconosSettings& settings) {
  ContactSolution best;
  best.r = VecX::Zero(problem.q.size());
  if (std::any_of(problem.force_limit.begin(), problem.force_limit.end(), [](double x) { return std::isfinite(x); })) {
    best.message = "Siconos knows no force limit";
    return best;
  }
  if (settings.relative_tolerance > 0) return run_once(problem, guess, settings, settings.relative_tolerance);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const double limit = settings.shared.max_seconds;
  double best_map = std::numeric_limits<double>::infinity();
  int iterations = 0;
  for (double relative = k_first_relative; relative > k_last_relative; relative *= k_ladder_factor) {
    ContactSolution run = run_once(problem, guess, settings, relative);
    iterations += run.iterations;
    const double map = measure(problem, run.r).law_map_m_s;
    if (best_map > map || relative == k_first_relative) {
      best_map = map;
      best = std::move(run);
      best.message += (best.message.empty() ? "" : "; ") + in_words(relative);
    }
    const bool over = limit > 0 && std::chrono::duration<double>(Clock::now() - start).count() > limit;
    if (best.status == SolveStatus::converged || over) break;
  }
  best.iterations = iterations;
  return best;
}

}  // namespace

std::string SiconosSolver::name() const {
  switch (settings_.method) {
    case SiconosMethod::nsgs:
      return "siconos-nsgs";
    case SiconosMethod::nsn_ac:
      return "siconos-nsn-ac";
    case SiconosMethod::prox:
      return "siconos-prox";
    case SiconosMethod::admm:
      return "siconos-admm";
  }
  return "siconos";
}

ContactSolution SiconosSolver::solve(const PreparedProblem& problem, const VecX& guess) const {
  ContactSolution solution = solve(reduce(problem.problem()), guess);
  solution.v = velocities(problem, solution.r);
  solution.u = contact_velocities(problem.problem(), solution.v);
  return solution;
}

ContactSolution SiconosSolver::solve(const LocalProblem& problem, const VecX& guess) const {
  solvers::demand_known(name().c_str(), std::array{Law::coulomb}, problem.law);
  NILAS_DEMAND(guess.size() == 0 || guess.size() == problem.q.size());
  ContactSolution solution = climb(problem, guess, settings_);
  solution.u = contact_velocities(problem, solution.r);
  return solution;
}

}  // namespace nilas::contact
