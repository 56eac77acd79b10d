/// Counts thin plates at 100 thicknesses per step that pass through fixed plates as thin, alone and in crowds.
/// usage: bench_thin_plates FLIGHTS PAIRS_PER_SCENE [CONTACT_ATTRIBUTES]
#include "tests/support/collision/thin_plates.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  using namespace nilas;
  if (argc < 3) return std::fprintf(stderr, "usage: bench_thin_plates FLIGHTS PAIRS_PER_SCENE [ATTRIBUTES]\n"), 2;
  const long flights = std::atol(argv[1]), per_scene = std::atol(argv[2]);
  RandomStream random(26, "thin plates");
  plates::Tally sum;
  while (sum.flights < flights) {
    std::vector<plates::Flight> crowd;
    for (long k = 0; k < per_scene; ++k) crowd.push_back(plates::draw(random));
    if (const char* only = std::getenv("ONLY"); only && std::atol(only) != sum.flights) {
      sum.flights += per_scene;
      continue;
    }
    const plates::Tally tally = plates::fly(crowd, argc > 3 ? argv[3] : "");
    if (tally.passed + tally.refused + tally.warnings > 0)
      std::fprintf(stderr, "scene from flight %ld: passed %ld refused %ld warnings %ld\n", sum.flights, tally.passed,
                   tally.refused, tally.warnings);
    sum += tally;
  }
  std::printf(
      "%ld flights in scenes of %ld: %ld passed, %ld refused, %ld warnings, %.2f parts per step\n", sum.flights,
      per_scene, sum.passed, sum.refused, sum.warnings,
      static_cast<double>(sum.parts) / (4.0 * static_cast<double>(sum.flights) / static_cast<double>(per_scene)));
}
