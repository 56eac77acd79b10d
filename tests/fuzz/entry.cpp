/// The entry of one libFuzzer program. NILAS_FUZZ_TARGET is the function that reads the bytes.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "tests/fuzz/targets.h"

namespace {

double slowest = 0;  // [s]

/// Processor time of this process, which does not count that others have the machine [s].
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  constexpr double k_nano = 1e-9;
  return static_cast<double>(now.tv_sec) + k_nano * static_cast<double>(now.tv_nsec);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  std::atexit([] { std::fprintf(stderr, "slowest input: %.6f s\n", slowest); });
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const double begin = processor_seconds();
  nilas::fuzz::NILAS_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  const double took = processor_seconds() - begin;
  if (took > slowest) slowest = took;
  constexpr double k_too_slow = 10;  // [s]
  if (took > k_too_slow) {
    std::fprintf(stderr, "the input took %.1f s of processor time\n", took);
    std::abort();
  }
  return 0;
}
