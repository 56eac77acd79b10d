#include "core/numerics/nonlinear_solve.h"

#include <kinsol/kinsol.h>

#include <cstdlib>
#include <exception>

#include "core/numerics/sundials_objects.h"

namespace nilas::numerics {

namespace {

struct Session {
  const NonlinearEquations& equations;
  VecX x, f;
  std::exception_ptr thrown;  ///< exceptions must not pass through C code
};

int evaluate(N_Vector x, N_Vector f, void* data) {
  auto& session = *static_cast<Session*>(data);
  try {
    session.x = sundials::view(x);
    session.equations(session.x, session.f);
    sundials::view(f) = session.f;
  } catch (...) {
    session.thrown = std::current_exception();
    return -1;
  }
  return 0;
}

struct FreeKinsol {
  void operator()(void* memory) const { KINFree(&memory); }
};

std::string name_of(int code) {
  const std::unique_ptr<char, decltype(&std::free)> name(KINGetReturnFlagName(code), &std::free);
  return name.get();
}

}  // namespace

NonlinearSolution solve_nonlinear(const NonlinearEquations& equations, const VecX& start,
                                  const NonlinearSettings& settings) {
  NILAS_DEMAND(start.size() > 0);
  const sundials::Context context;
  const sundials::Vector x = sundials::copy(start, context);
  const sundials::Vector scale = sundials::copy(VecX::Ones(start.size()), context);
  const sundials::Matrix jacobian(SUNDenseMatrix(start.size(), start.size(), context.get()));
  const sundials::LinearSolver linear(SUNLinSol_Dense(x.get(), jacobian.get(), context.get()));
  const std::unique_ptr<void, FreeKinsol> memory(KINCreate(context.get()));
  NILAS_DEMAND(jacobian && linear && memory);
  Session session{equations, start, VecX(start.size()), nullptr};
  const auto demand = [](int code) { NILAS_DEMAND(code == KIN_SUCCESS); };
  demand(KINSetErrHandlerFn(memory.get(), sundials::keep_silent, nullptr));
  demand(KINInit(memory.get(), evaluate, x.get()));
  demand(KINSetUserData(memory.get(), &session));
  demand(KINSetFuncNormTol(memory.get(), settings.tolerance));
  demand(KINSetScaledStepTol(memory.get(), settings.tolerance * settings.tolerance));  // stops only at rounding
  demand(KINSetMaxNewtonStep(memory.get(), settings.longest_step));
  demand(KINSetNumMaxIters(memory.get(), settings.max_iterations));
  demand(KINSetLinearSolver(memory.get(), linear.get(), jacobian.get()));
  demand(KINSetMaxSetupCalls(memory.get(), 1));  // few unknowns: a fresh Jacobian for each iteration
  const int code = KINSol(memory.get(), x.get(), KIN_LINESEARCH, scale.get(), scale.get());
  if (session.thrown) std::rethrow_exception(session.thrown);

  NonlinearSolution solution;
  solution.x = sundials::view(x.get());
  equations(solution.x, session.f);
  solution.residual = session.f.lpNorm<Eigen::Infinity>();
  long iterations = 0;
  demand(KINGetNumNonlinSolvIters(memory.get(), &iterations));
  solution.iterations = static_cast<int>(iterations);
  solution.converged = solution.residual <= settings.accepted;
  if (!solution.converged) solution.message = name_of(code);
  return solution;
}

}  // namespace nilas::numerics
