/// Cost of packing over the size of the field, and the concentration reached: polygons at 95 %, the same as cells of a
/// power diagram, and equal squares at 98 %.
/// usage: bench_field SIZE ...     SIZE: approximate number of floes; prints a table and growth exponents of the CPU
/// time
#include "core/field/field.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <vector>

namespace {

using namespace nilas;

struct Kind {
  const char* name;
  std::function<field::FieldResult(int floes)> make;
};

field::PackedSpec polygons(int floes) {
  field::PackedSpec spec;
  spec.concentration = 0.95;
  spec.overlap_tolerance = 0;
  const double area = floes * (spec.mean * spec.mean + spec.sd * spec.sd) / spec.concentration;
  spec.high = {std::sqrt(1.5 * area), std::sqrt(area / 1.5)};
  return spec;
}

/// Squares of 0.99 of the pitch at which a whole number of them fills the region.
field::PackedSpec squares(int floes) {
  field::PackedSpec spec;
  spec.concentration = 0.98;
  spec.overlap_tolerance = 0;
  spec.shape = FloeShape::square;
  spec.distribution = SizeDistribution::fixed;
  spec.mean = 0.99;
  const double side = std::round(std::sqrt(floes));
  spec.high = {side, side};
  return spec;
}

void measure(const Kind& kind, const std::vector<int>& sizes) {
  double last_floes = 0, last_seconds = 0;
  for (const int size : sizes) {
    const std::clock_t start = std::clock();
    const field::FieldResult field = kind.make(size);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const auto floes = static_cast<double>(field.floes.size());
    std::printf("%-22s %7.0f  %.4f  %8.2f", kind.name, floes, field.concentration, seconds);
    if (last_floes > 0) std::printf("  %.2f", std::log(seconds / last_seconds) / std::log(floes / last_floes));
    std::printf("\n");
    std::fflush(stdout);
    last_floes = floes;
    last_seconds = seconds;
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<int> sizes;
  for (int k = 1; k < argc; ++k) sizes.push_back(std::atoi(argv[k]));
  if (sizes.empty()) sizes = {1000, 3000, 10000};
  std::printf("field                    floes  conc.   seconds  exponent\n");
  measure({"packed polygons", [](int floes) { return field::pack_field(polygons(floes)); }}, sizes);
  measure({"voronoi", [](int floes) { return field::voronoi_field(polygons(floes)); }}, sizes);
  measure({"packed equal squares", [](int floes) { return field::pack_field(squares(floes)); }}, sizes);
  return 0;
}
