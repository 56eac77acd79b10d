/// Speed-up of several threads inside a single large island, compared with that of a loop that only computes.
/// usage: bench_threads SIZE THREADS ROUNDS     SIZE: approximate number of contacts
///
/// A fixed number of iterations starts from zero impulses. Wall times are the best of the rounds, with one and several
/// threads in turn. The impulses must agree to the bit.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>

#include "contact/registry.h"
#include "core/base/parallel.h"
#include "tests/bench/channel.h"

namespace {

using namespace nilas;

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Independent work without memory access: its speed-up is the largest that threads can have here. The result is
/// returned so that the compiler keeps the work.
double spin(int threads) {
  constexpr std::ptrdiff_t k_items = 2000;
  constexpr int k_rounds = 20000;
  std::vector<double> results(k_items, 0.0);
  parallel_for(k_items, threads, [&](std::ptrdiff_t i) {
    double x = 1.0 + 1e-3 * static_cast<double>(i);
    for (int k = 0; k < k_rounds; ++k) x = 1.0 / (1.0 + x);
    results[i] = x;
  });
  double sum = 0;
  for (const double x : results) sum += x;
  return sum;
}

/// Best times with one and with several threads.
struct Times {
  double one = std::numeric_limits<double>::infinity(), several = one;
  double speed_up() const { return one / several; }
};

Times compare(int rounds, int threads, const std::function<void(int)>& work) {
  Times times;
  for (int k = 0; k < rounds; ++k) {
    times.one = std::min(times.one, seconds_of([&] { work(1); }));
    times.several = std::min(times.several, seconds_of([&] { work(threads); }));
  }
  return times;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: bench_threads SIZE THREADS ROUNDS\n");
    return 2;
  }
  const int threads = std::atoi(argv[2]), rounds = std::atoi(argv[3]);
  const contact::ContactProblem problem = bench::channel(std::atoi(argv[1]));
  double sink = 0;
  const Times loop = compare(rounds, threads, [&](int n) { sink += spin(n); });
  std::printf("%d contacts, %d threads, best of %d\n", problem.num_contacts(), threads, rounds);
  std::printf("%-14s %10s %10s %9s %14s %s\n", "solver", "1 ms", "n ms", "speed-up", "over the loop's", "same bits");
  std::printf("%-14s %10.1f %10.1f %9.2f %14.2f\n", "loop alone", 1e3 * loop.one, 1e3 * loop.several, loop.speed_up(),
              1.0);
  bool same = std::isfinite(sink);
  for (const char* name : {"nsgs", "eg", "eg-order-free", "apgd"}) {
    VecX r[2];
    const Times times = compare(rounds, threads, [&](int n) {
      const auto solver = contact::find_solver(name).make({.tolerance = 1e-12, .max_iterations = 600, .threads = n});
      r[n > 1 ? 1 : 0] = solver->solve(problem, {}).r;
    });
    same = same && r[0] == r[1];
    std::printf("%-14s %10.1f %10.1f %9.2f %14.2f %s\n", name, 1e3 * times.one, 1e3 * times.several, times.speed_up(),
                times.speed_up() / loop.speed_up(), r[0] == r[1] ? "yes" : "NO");
  }
  return same ? 0 : 1;
}
