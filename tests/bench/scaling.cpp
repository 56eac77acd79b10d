/// Cost of each solver over the number of contacts: a heavy vessel driven into a channel of floes.
/// usage: bench_scaling LIMIT_S TOLERANCE SIZE ...     SIZE: approximate number of contacts; prints a table and
/// exponents
///
/// The problems are those of tests/bench/channel.h. Each run is a process of its own. Memory is the largest of the
/// process, with the problem.
#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include "contact/registry.h"
#include "tests/bench/channel.h"
#include "tests/bench/run_apart.h"

namespace {

using namespace nilas;

struct Run {
  double seconds = 0, law_map = 0;
  contact::SolveStatus status = contact::SolveStatus::numerical_error;
};

Run solve(const contact::ContactProblem& problem, const std::string& name, double tolerance) {
  const auto solver = contact::find_solver(name).make({.tolerance = tolerance, .max_iterations = 1000000});
  const auto start = std::chrono::steady_clock::now();
  const contact::ContactSolution solution = solver->solve(problem, {});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {seconds, contact::measure(problem, solution.r).law_map_m_s, solution.status};
}

/// Slope of log seconds over log contacts by least squares.
double exponent(const std::vector<std::pair<double, double>>& points) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [contacts, seconds] : points) {
    x += std::log(contacts);
    y += std::log(seconds);
    xx += std::log(contacts) * std::log(contacts);
    xy += std::log(contacts) * std::log(seconds);
  }
  const auto n = static_cast<double>(points.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: bench_scaling LIMIT_S TOLERANCE SIZE ...\n");
    return 2;
  }
  const double limit = std::atof(argv[1]), tolerance = std::atof(argv[2]);
  std::vector<contact::ContactProblem> problems;
  for (int k = 3; k < argc; ++k) problems.push_back(bench::channel(std::atoi(argv[k])));
  std::printf("vessel in a channel of floes, cold start, law_map_m_s <= %g, at most %g s\n", tolerance, limit);
  std::printf("%-10s %9s %10s %10s %12s %10s\n", "solver", "contacts", "ms", "us/contact", "law_map_m_s", "MB");
  for (const char* name : {"pgs", "nsgs", "eg", "apgd", "admm", "newton", "ipm", "auto"}) {
    std::vector<std::pair<double, double>> points;
    for (const contact::ContactProblem& problem : problems) {
      Run run;
      double peak = 0;
      const int contacts = problem.num_contacts();
      const bool done = bench::run_apart(
          limit, [&] { return solve(problem, name, tolerance); }, run, &peak);
      if (!done) {
        std::printf("%-10s %9d %10s\n", name, contacts, "time limit");
        std::fflush(stdout);
        break;
      }
      std::printf("%-10s %9d %10.2f %10.2f %12.2g %10.0f  %s\n", name, contacts, 1e3 * run.seconds,
                  1e6 * run.seconds / contacts, run.law_map, 1e-6 * peak, contact::to_string(run.status));
      std::fflush(stdout);
      if (run.status == contact::SolveStatus::converged) points.emplace_back(contacts, run.seconds);
    }
    if (points.size() > 1) std::printf("%-10s exponent %.2f\n", name, exponent(points));
  }
  return 0;
}
