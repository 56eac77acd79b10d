#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <vector>

#include "contact/detect/broad/reach.h"
#include "contact/detect/detector.h"
#include "core/base/parallel.h"
#include "tests/bench/collision/collision.h"
#include "tests/bench/moving_field.h"
#include "tests/bench/peers/floe_scene.h"

namespace nilas::bench {

namespace {

constexpr double k_step = 0.01, k_reach_share = 1.5;  // Step [s] and reach share [-] as in a simulation.
constexpr int k_first_measured = 10;

std::vector<detect::ContactPoint> detect(detect::ContactDetector& detector, const bodies::Bodies& bodies) {
  const bodies::Wrenches loads(static_cast<std::size_t>(bodies.size()));
  return detector.detect(bodies, detect::own_reach(bodies, loads, k_step, k_reach_share));
}

bool same_bits(const detect::ContactPoint& p, const detect::ContactPoint& q) {
  const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  return p.a == q.a && p.b == q.b && p.part_a == q.part_a && p.part_b == q.part_b && p.key == q.key && same(p.p, q.p) &&
         same(p.n, q.n) && same(p.gap, q.gap);
}

double wall_ms(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Computes without memory access for about `ms` on one thread, in as many pieces as a detector cuts its pairs into.
/// The result is returned so that the compiler keeps the work.
double compute_only(double ms, int threads) {
  constexpr std::ptrdiff_t k_pieces = 16;
  constexpr double k_divisions_per_ms = 2.2e5;
  const auto rounds = static_cast<long>(ms * k_divisions_per_ms / k_pieces);
  std::vector<double> results(k_pieces, 0.0);
  parallel_for(k_pieces, threads, [&](std::ptrdiff_t i) {
    double x = 1.0 + 1e-3 * static_cast<double>(i);
    for (long k = 0; k < rounds; ++k) x = 1.0 / (1.0 + x);
    results[i] = x;
  });
  double sum = 0;
  for (const double x : results) sum += x;
  return sum;
}

}  // namespace

void step_row(int floes, int steps) {
  static double last_ms = 0;
  static int last_floes = 0;
  MovingField field(floes);
  detect::ContactDetector detector;
  std::vector<double> ms;
  detect::DetectorCounts sum;
  std::size_t points = 0;
  for (int n = 0; n < k_first_measured + steps; ++n) {
    field.move_to(n * k_step);
    const double start = peers::now_ms();
    const std::size_t found = detect(detector, field.bodies()).size();
    if (n < k_first_measured) continue;
    ms.push_back(peers::now_ms() - start);
    points += found;
    sum.candidate_pairs += detector.counts().candidate_pairs;
    sum.cached_separations += detector.counts().cached_separations;
    sum.kept_axes += detector.counts().kept_axes;
    sum.fcl_queries += detector.counts().fcl_queries;
    sum.fallbacks += detector.counts().fallbacks;
  }
  const double median = peers::median(ms);
  if (last_floes == 0)
    std::printf("%7s %6s %9s %9s %9s %9s %10s %10s %6s %10s %9s\n", "floes", "conc.", "ms/step", "95 %", "pairs",
                "points", "separated", "kept axes", "FCL", "fallbacks", "exponent");
  const auto pairs = static_cast<double>(sum.candidate_pairs);
  std::printf("%7d %6.3f %9.3f %9.3f %9.0f %9.0f %8.1f %% %8.1f %% %6ld %10ld", floes, field.concentration(), median,
              peers::percentile_95(ms), pairs / steps, static_cast<double>(points) / steps,
              100 * static_cast<double>(sum.cached_separations) / pairs,
              100 * static_cast<double>(sum.kept_axes) / pairs, sum.fcl_queries, sum.fallbacks);
  if (last_floes > 0) std::printf(" %9.2f", std::log(median / last_ms) / std::log(1.0 * floes / last_floes));
  std::printf("\n");
  std::fflush(stdout);
  last_ms = median;
  last_floes = floes;
}

bool thread_table(int floes, int threads, int steps) {
  MovingField field(floes);
  detect::ContactDetector one(1), several(threads);
  std::vector<double> ms[4];
  bool same = true;
  double sink = 0, pace = 10;
  for (int n = 0; n < k_first_measured + steps; ++n) {
    field.move_to(n * k_step);
    std::vector<detect::ContactPoint> of_one, of_several;
    const double times[4] = {wall_ms([&] { of_one = detect(one, field.bodies()); }),
                             wall_ms([&] { of_several = detect(several, field.bodies()); }),
                             wall_ms([&] { sink += compute_only(pace, 1); }),
                             wall_ms([&] { sink += compute_only(pace, threads); })};
    same = same && std::equal(of_one.begin(), of_one.end(), of_several.begin(), of_several.end(), same_bits);
    pace = times[0];
    if (n < k_first_measured) continue;
    for (int k = 0; k < 4; ++k) ms[k].push_back(times[k]);
  }
  const double gain = peers::median(ms[0]) / peers::median(ms[1]), loop = peers::median(ms[2]) / peers::median(ms[3]);
  std::printf("%d floes, %d steps, medians of wall time in turn\n", floes, steps);
  std::printf("%-14s %10s %10s %9s\n", "", "1 thread", "several", "speed-up");
  std::printf("%-14s %10.2f %10.2f %9.2f\n", "loop alone", peers::median(ms[2]), peers::median(ms[3]), loop);
  std::printf("%-14s %10.2f %10.2f %9.2f   %.2f of the loop's; %s bits\n", "detection", peers::median(ms[0]),
              peers::median(ms[1]), gain, gain / loop, same ? "the same" : "OTHER");
  return same && std::isfinite(sink);
}

}  // namespace nilas::bench
