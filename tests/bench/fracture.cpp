/// Cost of the tables of ice mechanics: construction, and one call after that.
/// usage: bench_fracture
#include <chrono>
#include <cstdio>

#include "fracture/bend/edge_load.h"
#include "fracture/bend/wedge.h"
#include "fracture/split/splitting_lefm.h"

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class Make>
void print_construction(const char* name, const Make& make) {
  const auto start = std::chrono::steady_clock::now();
  make();
  std::printf("%-44s %8.2f ms\n", name, 1e3 * seconds_since(start));
}

/// Times calls spread over arguments from 1e-3 to 0.8, so that no result can be reused.
template <class Call>
void print_call(const char* name, const Call& call) {
  constexpr int calls = 1000000;
  double sum = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < calls; ++k) sum += call(1e-3 + k * (0.799 / calls));
  std::printf("%-44s %8.1f ns   (sum %g)\n", name, 1e9 * seconds_since(start) / calls, sum);
}

}  // namespace

int main() {
  using namespace nilas;
  print_construction("EdgeLoad", [] { const fracture::EdgeLoad load(0.3); });
  print_construction("WedgeTable", [] { const fracture::WedgeTable table(fracture::TipLoad::pressure); });
  print_construction("SplittingTable", [] { const fracture::SplittingTable table; });
  const fracture::EdgeLoad edge(0.3);
  const fracture::WedgeTable wedge(fracture::TipLoad::pressure);
  const fracture::SplittingTable splitting;
  print_call("EdgeLoad::stress_factor", [&](double x) { return edge.stress_factor(x); });
  print_call("wedge_failure_load", [&](double x) { return fracture::wedge_failure_load(wedge, x, 0.8, 1, 5e5); });
  print_call("bending_radius", [&](double x) { return fracture::bending_radius(wedge, x, 14); });
  print_call("SplittingTable::H", [&](double x) { return splitting.H(x, 2 * x); });
  print_call("splitting_force, short starter", [&](double x) {
    return fracture::splitting_force(splitting, {100, 200 * x + 20, 1, 115e3}, 0.2);
  });
}
