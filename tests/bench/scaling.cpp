/// What each solver costs as the number of contacts grows: a heavy vessel driven into a channel of floes.
/// usage: bench_scaling LIMIT_S TOLERANCE SIZE ...     SIZE: about so many contacts; prints a table and exponents
///
/// Floes of 1e2 to 1e6 kg stand in rows across the channel, two contact points to each neighbour and to the walls;
/// three pairs of ten touch, the others have a gap of up to 0.2 m, twice what the hull closes in the step. A hull of
/// 1e7 kg at 2 m/s leans on the whole first row. Each run is a process of its own; memory is the most that the process
/// held, problem included.
#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include "contact/registry.h"
#include "tests/bench/run_apart.h"
#include "tests/support/problem_factory.h"

namespace {

using namespace nilas;

constexpr double k_step = 0.05, k_friction = 0.3, k_hull_mass = 1e7, k_hull_speed = 2, k_touching = 0.3;
constexpr double k_largest_gap = 0.2;  // [m]
constexpr int k_length_over_width = 2;
constexpr double k_reach = 0.35;  ///< of a pair's points from its middle [floe sizes]

struct Run {
  double seconds = 0, law_map = 0;
  SolveStatus status = SolveStatus::numerical_error;
};

/// Rows x columns of square floes of 1 m from the hull on; block 0 is the hull.
ContactProblem channel(int size) {
  const int columns = std::max(2, static_cast<int>(std::sqrt(size / 4.0 / k_length_over_width)));
  const int rows = std::max(2, size / (4 * columns));
  RandomStream random(7, "channel");
  ContactProblem problem;
  problem.h = k_step;
  std::vector<test::TestBody> bodies;
  const auto add = [&](double mass, const Vec3& p, const Vec3& v, double radius) {
    test::TestBody body;
    body.mass = mass;
    body.inertia = mass * radius * radius / 6 * Vec3(1, 1, 2).asDiagonal();
    body.p = p;
    body.v = v;
    bodies.push_back(body);
    test::add_body(problem, body);
  };
  add(k_hull_mass, Vec3(-1, 0.5 * columns, 0), Vec3(k_hull_speed, 0, 0), columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      add(std::pow(10.0, random.uniform(2, 6)), Vec3(i, j, 0), 0.05 * test::random_vector(random), 1);
  const auto touch = [&](int a, int b, const Vec3& middle, const Vec3& n) {
    const double gap = random.uniform() < k_touching ? 0 : random.uniform(0, k_largest_gap);
    const Vec3 along(-k_reach * n.y(), k_reach * n.x(), 0);
    for (const double side : {-1.0, 1.0}) {
      const int c = test::add_contact(problem, bodies, a, b, middle + side * along, test::frame_of(n), k_friction);
      problem.w[3 * c] = gap / k_step;
    }
  };
  const auto floe = [&](int i, int j) { return 1 + i * columns + j; };
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const Vec3 p(i, j, 0);
      touch(i == 0 ? 0 : floe(i - 1, j), floe(i, j), p - Vec3(0.5, 0, 0), Vec3::UnitX());
      touch(j == 0 ? -1 : floe(i, j - 1), floe(i, j), p - Vec3(0, 0.5, 0), Vec3::UnitY());
      if (j + 1 == columns) touch(floe(i, j), -1, p + Vec3(0, 0.5, 0), Vec3::UnitY());
    }
  return problem;
}

Run solve(const ContactProblem& problem, const std::string& name, double tolerance) {
  const auto solver = find_solver(name).make({.tolerance = tolerance, .max_iterations = 1000000});
  const auto start = std::chrono::steady_clock::now();
  const ContactSolution solution = solver->solve(problem, {});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {seconds, measure(problem, solution.r).law_map_m_s, solution.status};
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
  std::vector<ContactProblem> problems;
  for (int k = 3; k < argc; ++k) problems.push_back(channel(std::atoi(argv[k])));
  std::printf("vessel in a channel of floes, cold start, law_map_m_s <= %g, at most %g s\n", tolerance, limit);
  std::printf("%-10s %9s %10s %10s %12s %10s\n", "solver", "contacts", "ms", "us/contact", "law_map_m_s", "MB");
  for (const char* name : {"pgs", "nsgs", "eg", "apgd", "admm", "newton", "ipm", "auto"}) {
    std::vector<std::pair<double, double>> points;
    for (const ContactProblem& problem : problems) {
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
                  1e6 * run.seconds / contacts, run.law_map, 1e-6 * peak, to_string(run.status));
      std::fflush(stdout);
      points.emplace_back(contacts, run.seconds);
    }
    if (points.size() > 1) std::printf("%-10s exponent %.2f\n", name, exponent(points));
  }
  return 0;
}
