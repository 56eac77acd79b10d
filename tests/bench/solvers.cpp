/// Accuracy against time of every solver on stored contact problems, each at decreasing tolerances, all in one run.
/// usage: bench_solvers LIMIT_S PROBLEM.hdf5 ...   prints CSV rows without a header (tests/bench/run.sh has it)
///
/// Each run is a process of its own that is killed after LIMIT_S seconds, so that a peer that hangs or crashes costs no
/// more. The time is that of the solve alone, the least of up to five where it is short. The residual is that of
/// `measure`.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>

#include "contact/fclib/fclib_io.h"
#include "contact/peers/siconos.h"
#include "contact/registry.h"
#include "tests/bench/run_apart.h"

namespace {

using namespace nilas;

constexpr double k_short_run = 0.05;  // [s]
constexpr int k_repeats = 5;
/// Residual below which no smaller tolerance is tried, since the table ends there [m/s].
constexpr double k_enough = 1e-10;
constexpr int k_iterations = 1000000;

struct Run {
  double seconds = 0, natural_map = 0;
  int iterations = 0;
  contact::SolveStatus status = contact::SolveStatus::numerical_error;
};

struct Subject {
  std::string name;
  std::vector<double> rungs;
  std::function<std::unique_ptr<solvers::ContactSolver>(double rung)> make;
};

std::vector<Subject> subjects() {
  const std::vector<double> ours{1e-2, 1e-4, 1e-6, 1e-8, 1e-10}, theirs{1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16};
  std::vector<Subject> all;
  for (const char* name : {"auto", "newton", "ipm", "admm", "nsgs", "apgd", "eg", "pgs"})
    all.push_back({name, ours, [name](double rung) {
                     return contact::find_solver(name).make({.tolerance = rung, .max_iterations = k_iterations});
                   }});
  for (const contact::SiconosMethod method : {contact::SiconosMethod::nsgs, contact::SiconosMethod::nsn_ac,
                                              contact::SiconosMethod::prox, contact::SiconosMethod::admm}) {
    const contact::SiconosSettings settings{.shared = {.max_iterations = k_iterations}, .method = method};
    all.push_back({contact::SiconosSolver(settings).name(), theirs, [settings](double rung) {
                     contact::SiconosSettings own = settings;
                     own.relative_tolerance = rung;
                     return std::make_unique<contact::SiconosSolver>(own);
                   }});
  }
  return all;
}

Run time_solver(const contact::FclibProblem& file, const solvers::ContactSolver& solver) {
  using Clock = std::chrono::steady_clock;
  Run run;
  for (int repeat = 0; repeat < k_repeats; ++repeat) {
    contact::ContactSolution solution;
    const auto start = Clock::now();
    std::visit([&](const auto& problem) { solution = solver.solve(problem, VecX()); }, file.problem);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (repeat == 0) {
      run = {seconds, 0, solution.iterations, solution.status};
      std::visit([&](const auto& problem) { run.natural_map = contact::measure(problem, solution.r).natural_map_m_s; },
                 file.problem);
    }
    run.seconds = std::min(run.seconds, seconds);
    if (seconds > k_short_run) break;
  }
  return run;
}

void climb(const std::string& name, const contact::FclibProblem& file, const Subject& subject, double limit) {
  for (const double rung : subject.rungs) {
    Run run;
    const auto solve = [&] { return time_solver(file, *subject.make(rung)); };
    const bool done = bench::run_apart(limit * (1 + k_repeats * k_short_run), solve, run) && run.seconds <= limit;
    std::printf("%s,%d,%d,%s,%.0e,%s,%d,%.6g,%.4g\n", name.c_str(), file.num_contacts(), file.num_velocities(),
                subject.name.c_str(), rung, done ? contact::to_string(run.status) : "time_limit", run.iterations,
                done ? run.seconds : limit, done ? run.natural_map : HUGE_VAL);
    std::fflush(stdout);
    if (!done || run.natural_map <= k_enough) return;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: bench_solvers LIMIT_S PROBLEM.hdf5 ...\n");
    return 2;
  }
  const double limit = std::atof(argv[1]);
  for (int k = 2; k < argc; ++k) {
    const std::filesystem::path path = argv[k];
    const contact::FclibProblem file = contact::read_fclib(path);
    for (const Subject& subject : subjects()) climb(path.stem().string(), file, subject, limit);
    std::fprintf(stderr, "%s: done\n", path.stem().c_str());
  }
  return 0;
}
