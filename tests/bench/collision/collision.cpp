/// Correctness, speed, growth and thread scaling of contact search.
/// usage: bench_collision classes BATCHES THREADS nilas|fcl|nilas-alone [CLASS] |
///                        peers PAIRS ROUNDS | steps STEPS FLOES ... | threads FLOES THREADS STEPS
#include "tests/bench/collision/collision.h"

#include <cstdio>
#include <cstdlib>
#include <string>

int main(int argc, char** argv) {
  using namespace nilas::bench;
  const std::string table = argc > 1 ? argv[1] : "";
  const auto number = [&](int k) { return std::atoi(argv[k]); };
  if (table == "classes" && (argc == 5 || argc == 6)) {
    const std::string name = argv[4];
    const nilas::NarrowPhase narrow = name == "fcl"           ? nilas::NarrowPhase::fcl
                                      : name == "nilas-alone" ? nilas::NarrowPhase::nilas_alone
                                                              : nilas::NarrowPhase::nilas;
    return class_table(number(2), number(3), narrow, argc == 6 ? argv[5] : nullptr) ? 0 : 1;
  }
  if (table == "peers" && argc == 4) return peer_table(number(2), number(3)) ? 0 : 1;
  if (table == "threads" && argc == 5) return thread_table(number(2), number(3), number(4)) ? 0 : 1;
  if (table == "steps" && argc > 3) {
    for (int k = 3; k < argc; ++k) step_row(number(k), number(2));
    return 0;
  }
  std::fprintf(stderr,
               "usage: bench_collision classes BATCHES THREADS nilas|fcl|nilas-alone [CLASS] | peers PAIRS ROUNDS | "
               "steps STEPS FLOES ... | "
               "threads FLOES THREADS STEPS\n");
  return 2;
}
