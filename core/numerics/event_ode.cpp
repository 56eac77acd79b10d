#include "core/numerics/event_ode.h"

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <limits>

#include "core/numerics/sundials_objects.h"

namespace nilas::numerics {

namespace {

struct Session {
  EventOde ode;
  VecX y, dy, g;
  std::exception_ptr thrown;  ///< exceptions must not pass through C code
};

template <class Call>
int guarded(Session& session, const Call& call) {
  try {
    call();
  } catch (...) {
    session.thrown = std::current_exception();
    return -1;
  }
  return 0;
}

int derivative(double t, N_Vector y, N_Vector dy, void* data) {
  auto& session = *static_cast<Session*>(data);
  return guarded(session, [&] {
    session.y = sundials::view(y);
    session.ode.derivative(t, session.y, session.dy);
    sundials::view(dy) = session.dy;
  });
}

int events(double t, N_Vector y, double* g, void* data) {
  auto& session = *static_cast<Session*>(data);
  return guarded(session, [&] {
    session.y = sundials::view(y);
    session.ode.events(t, session.y, session.g);
    Eigen::Map<VecX>(g, session.g.size()) = session.g;
  });
}

struct FreeCvode {
  void operator()(void* memory) const { CVodeFree(&memory); }
};
struct FreeNonlinear {
  void operator()(SUNNonlinearSolver solver) const { SUNNonlinSolFree(solver); }
};

std::string name_of(int code) {
  const std::unique_ptr<char, decltype(&std::free)> name(CVodeGetReturnFlagName(code), &std::free);
  return name.get();
}

/// Why CVODE stopped, in words where there are any that help, and with its own name.
std::string reason_of(int code, long max_steps) {
  switch (code) {
    case CV_TOO_MUCH_WORK:
      return fmt::format("more than {} steps were needed at this accuracy ({})", max_steps, name_of(code));
    case CV_ERR_FAILURE:
    case CV_CONV_FAILURE:
      return fmt::format("even the shortest step misses the accuracy ({})", name_of(code));
    default:
      return name_of(code);
  }
}

void demand(int code) { NILAS_DEMAND(code == CV_SUCCESS); }

void watch_events(void* memory, int count) {
  if (count == 0) return;
  demand(CVodeRootInit(memory, count, events));
  std::vector<int> falling(static_cast<std::size_t>(count), -1);
  demand(CVodeSetRootDirection(memory, falling.data()));
  demand(CVodeSetNoInactiveRootWarn(memory));
}

std::vector<int> found_events(void* memory, int count) {
  std::vector<int> flags(static_cast<std::size_t>(count)), found;
  demand(CVodeGetRootInfo(memory, flags.data()));
  for (int k = 0; k < count; ++k)
    if (flags[k] != 0) found.push_back(k);
  return found;
}

}  // namespace

struct OdeSolution::Implementation {
  Implementation(EventOde ode, const OdeSettings& settings, double t0, const VecX& y)
      : session{std::move(ode), y, VecX(y.size()), VecX(), nullptr},
        t(t0),
        max_steps(settings.max_steps),
        state(sundials::copy(y, context)),
        absolute(sundials::copy(settings.absolute, context)),
        corrector(SUNNonlinSol_FixedPoint(state.get(), 0, context.get())),
        memory(CVodeCreate(CV_ADAMS, context.get())) {
    NILAS_DEMAND(y.size() > 0 && settings.absolute.size() == y.size() && corrector && memory);
    session.g.resize(session.ode.num_events);
    demand(CVodeSetErrHandlerFn(memory.get(), sundials::keep_silent, nullptr));
    demand(CVodeInit(memory.get(), derivative, t0, state.get()));
    demand(CVodeSVtolerances(memory.get(), settings.relative, absolute.get()));
    demand(CVodeSetUserData(memory.get(), &session));
    demand(CVodeSetNonlinearSolver(memory.get(), corrector.get()));
    demand(CVodeSetMaxNumSteps(memory.get(), settings.max_steps));
    if (settings.longest_step > 0) demand(CVodeSetMaxStep(memory.get(), settings.longest_step));
    watch_events(memory.get(), session.ode.num_events);
  }

  Session session;
  double t;  ///< time reached [s]
  long max_steps;
  sundials::Context context;
  sundials::Vector state, absolute;
  std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, FreeNonlinear> corrector;
  std::unique_ptr<void, FreeCvode> memory;
};

OdeSolution::OdeSolution(EventOde ode, const OdeSettings& settings, double t0, const VecX& y)
    : implementation_(std::make_unique<Implementation>(std::move(ode), settings, t0, y)) {}
OdeSolution::~OdeSolution() = default;
OdeSolution::OdeSolution(OdeSolution&&) noexcept = default;
OdeSolution& OdeSolution::operator=(OdeSolution&&) noexcept = default;

OdeStop OdeSolution::follow(double t1, VecX& y) {
  Implementation& own = *implementation_;
  Session& session = own.session;
  y = sundials::view(own.state.get());
  // what is left of a step after an event may be below the spacing of its times
  constexpr double k_least_spacings = 100;
  const double spacing = std::numeric_limits<double>::epsilon() * std::max(std::abs(own.t), std::abs(t1));
  if (t1 - own.t < k_least_spacings * spacing) {
    session.ode.derivative(own.t, y, session.dy);
    y += (t1 - own.t) * session.dy;
    return {t1, {}};
  }
  const int code = CVode(own.memory.get(), t1, own.state.get(), &own.t, CV_NORMAL);
  if (session.thrown) std::rethrow_exception(session.thrown);
  y = sundials::view(own.state.get());
  if (code == CV_ROOT_RETURN) return {own.t, found_events(own.memory.get(), session.ode.num_events)};
  if (code != CV_SUCCESS)
    throw SimulationError(
        fmt::format("the integrator stopped {:g} s after its start: {}", own.t, reason_of(code, own.max_steps)));
  return {t1, {}};
}

}  // namespace nilas::numerics
