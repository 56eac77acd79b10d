/// Separate timings of the stages of a step, on grids of touching floes: detection, water, assembly with solve. And of
/// the sums whose bits do not depend on the order of their terms, beside a plain sum.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "contact/assemble.h"
#include "contact/detect/detector.h"
#include "contact/registry.h"
#include "core/base/order_free_sum.h"
#include "core/base/random.h"
#include "hydro/modules.h"

namespace {

using namespace nilas;

/// n x n square floes that overlap by 1 mm, so that every neighbour is a contact.
bodies::Bodies touching_grid(int n) {
  constexpr double k_size = 0.5, k_thickness = 0.05, k_overlap = 1e-3, k_density = 920;
  const double half = 0.5 * k_size;
  const auto shape = std::make_shared<const geometry::Shape>(
      geometry::prism_shape({{-half, -half}, {half, -half}, {half, half}, {-half, half}}, k_thickness));
  const geometry::MassProperties mass = geometry::prism_properties(shape->outline, k_thickness, k_density);
  bodies::Bodies bodies;
  for (int i = 0; i < n * n; ++i) {
    bodies::BodySpec spec;
    spec.kind = bodies::BodyKind::floe;
    spec.material = "ice";
    spec.shape = shape;
    spec.mass = mass.mass;
    spec.inertia_B = mass.inertia;
    spec.pose.p = {(k_size - k_overlap) * (i % n), (k_size - k_overlap) * (i / n), -0.02};
    spec.v = {0.1 * ((i * 7) % 5 - 2), 0.1 * ((i * 11) % 5 - 2), 0};
    bodies.add(spec);
  }
  return bodies;
}

void detect(benchmark::State& state) {
  const bodies::Bodies bodies = touching_grid(static_cast<int>(state.range(0)));
  detect::ContactDetector detector;
  for (auto _ : state) benchmark::DoNotOptimize(detector.detect(bodies, 1e-3));
  state.SetItemsProcessed(state.iterations() * bodies.size());
}
/// Detection by a new detector, without memory.
void detect_at_first(benchmark::State& state) {
  const bodies::Bodies bodies = touching_grid(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(detect::ContactDetector().detect(bodies, 1e-3));
  state.SetItemsProcessed(state.iterations() * bodies.size());
}
BENCHMARK(detect_at_first)->Arg(16)->Arg(32)->Arg(64)->Unit(benchmark::kMillisecond);
BENCHMARK(detect)->Arg(16)->Arg(32)->Arg(64)->Unit(benchmark::kMillisecond);

void water(benchmark::State& state) {
  const bodies::Bodies bodies = touching_grid(static_cast<int>(state.range(0)));
  const auto buoyancy = hydro::make_buoyancy({}, 1), drag = hydro::make_drag({}, {}, 1);
  bodies::Wrenches loads(static_cast<std::size_t>(bodies.size()));
  for (auto _ : state) {
    buoyancy->add_forces(bodies, 0, loads);
    drag->add_forces(bodies, 0, loads);
  }
  state.SetItemsProcessed(state.iterations() * bodies.size());
}
BENCHMARK(water)->Arg(16)->Arg(32)->Arg(64)->Unit(benchmark::kMillisecond);

/// Assembly and solve. Arguments: floes along a side, sweeps.
void solve(benchmark::State& state) {
  const bodies::Bodies bodies = touching_grid(static_cast<int>(state.range(0)));
  contact::FrictionTable friction;
  friction.add("ice", "ice", {0.3, 0.3, 0});
  const auto points = detect::ContactDetector().detect(bodies, 1e-3);
  contact::AssemblySettings settings;
  settings.h = 0.01;
  settings.law = Law::pyramid;
  const bodies::Wrenches loads(static_cast<std::size_t>(bodies.size()));
  contact::SolverSettings sweeps;
  sweeps.tolerance = 0;
  sweeps.max_iterations = static_cast<int>(state.range(1));
  const auto solver = contact::find_solver("pgs").make(sweeps);
  for (auto _ : state) {
    const contact::AssembledContacts contacts =
        contact::assemble(bodies, loads, points, friction.resolve(bodies.materials), settings, {});
    benchmark::DoNotOptimize(solver->solve(contacts.problem, {}));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int>(points.size()) * state.range(1));
}
BENCHMARK(solve)->Args({32, 10})->Args({32, 50})->Args({32, 200})->Unit(benchmark::kMillisecond);

class PlainSum {
 public:
  void add(double x) { sum_ += x; }
  double value() const { return sum_; }

 private:
  double sum_ = 0;
};

/// Terms without rounding errors of their order, as in OrderFreeSum, but with three units of the grid instead of four
/// and a value that is rounded twice: what rounding once costs is the difference.
class ThreeUnitSum {
 public:
  void add(double x) {
    if (!(std::abs(x) < k_limit)) high_ = x - x;  // the grid of the product is lifted here
    const double high = (k_high + x) - k_high, rest = x - high, middle = (k_middle + rest) - k_middle;
    high_ += high;
    middle_ += middle;
    low_ += (k_low + (rest - middle)) - k_low;
  }
  double value() const { return high_ + (middle_ + low_); }

 private:
  static constexpr double k_high = 0x1.8p52, k_middle = 0x1.8p20, k_low = 0x1.8p-12, k_limit = 0x1p31;
  double high_ = 0, middle_ = 0, low_ = 0;
};

/// Sums of as many terms; a contact has some four points, a step some thousand contacts.
template <class Sum>
void sum(benchmark::State& state) {
  RandomStream random(1, "terms");
  std::vector<double> terms(static_cast<std::size_t>(state.range(0)));
  for (double& term : terms) term = 1e3 * random.normal();
  for (auto _ : state) {
    Sum all;
    for (const double term : terms) all.add(term);
    benchmark::DoNotOptimize(all.value());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(sum<PlainSum>)->Arg(4)->Arg(64)->Arg(4096);
BENCHMARK(sum<ThreeUnitSum>)->Arg(4)->Arg(64)->Arg(4096);
BENCHMARK(sum<OrderFreeSum>)->Arg(4)->Arg(64)->Arg(4096);

}  // namespace
