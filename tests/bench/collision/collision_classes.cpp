#include <cstdio>
#include <string_view>
#include <vector>

#include "core/base/parallel.h"
#include "tests/bench/collision/collision.h"
#include "tests/support/collision/pair_judge.h"

namespace nilas::bench {

namespace {

void print(const char* name, const char* how, const pairs::Tally& t) {
  std::printf("%-25s %-10s %7ld %8ld %6ld %7ld %7ld %6ld %8ld %6ld %9.1e %9.1e %9.1e %8ld\n", name, how, t.pairs,
              t.contacts, t.missed, t.surplus, t.wrong_normals, t.ties, t.unjudged, t.wrong_depths, t.worst_depth,
              t.worst_ulps, t.worst_surface, t.kept_axes);
}

bool is_right(const pairs::Tally& t) { return t.missed + t.surplus + t.wrong_normals + t.wrong_depths == 0; }

}  // namespace

bool class_table(int batches, int threads, NarrowPhase narrow, const char* only) {
  std::printf("%-25s %-10s %7s %8s %6s %7s %7s %6s %8s %6s %9s %9s %9s %8s\n", "class", "pair is", "pairs", "contacts",
              "missed", "surplus", "normals", "ties", "unjudged", "depths", "depth/sz", "in ulps", "place/sz", "kept");
  bool right = true;
  for (const pairs::PairClass& c : pairs::all_classes()) {
    if (only != nullptr && std::string_view(c.name) != only) continue;
    std::vector<std::array<pairs::Tally, 2>> of_batch(static_cast<std::size_t>(batches));
    parallel_for(batches, threads,
                 [&](std::ptrdiff_t k) { of_batch[k] = pairs::tally_batch(c, static_cast<int>(k), narrow); });
    std::array<pairs::Tally, 2> sums;
    for (const auto& tallies : of_batch)
      for (const std::size_t k : {0u, 1u}) sums[k] += tallies[k];
    print(c.name, "new", sums[0]);
    print(c.name, "remembered", sums[1]);
    std::fflush(stdout);
    right = right && is_right(sums[0]) && is_right(sums[1]);
  }
  return right;
}

}  // namespace nilas::bench
