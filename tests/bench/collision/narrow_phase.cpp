/// Loads, penetration and time of shipped scenes with each narrow phase. FCL's contacts are also judged step by step by
/// the exact search at the poses of the default run.
/// usage: bench_narrow_phase SECONDS SCENE.xml ...
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "contact/detect/broad/fast_pairs.h"
#include "contact/detect/detector.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"

namespace {

using namespace nilas;

/// The deepest point of each pair of convex pieces.
std::vector<detect::ContactPoint> deepest_of_pairs(std::vector<detect::ContactPoint> points) {
  const auto pair = [](const detect::ContactPoint& c) { return std::tuple(c.a, c.b, c.part_a, c.part_b); };
  std::stable_sort(points.begin(), points.end(), [&](const detect::ContactPoint& p, const detect::ContactPoint& q) {
    return std::tuple(pair(p), p.gap) < std::tuple(pair(q), q.gap);
  });
  points.erase(
      std::unique(points.begin(), points.end(),
                  [&](const detect::ContactPoint& p, const detect::ContactPoint& q) { return pair(p) == pair(q); }),
      points.end());
  return points;
}

struct Judgement {
  long contacts = 0, missed = 0, surplus = 0, wrong_normals = 0, wrong_depths = 0;
  double worst_depth = 0;  ///< Largest error of a depth over the thinner body's width [-].

  /// Compares two sets of contacts. Gaps below a hundredth of the thinner body's width count as contacts.
  void add(const std::vector<detect::ContactPoint>& exact, const std::vector<detect::ContactPoint>& fcl,
           const std::vector<double>& width) {
    constexpr double k_right_depth = 1e-6, k_margin = 1e-2;
    const double k_wrong_normal = std::cos(8 * k_deg);
    const auto thin = [&](const detect::ContactPoint& c) { return std::min(width[c.a], width[c.b]); };
    const auto names = [](const detect::ContactPoint& c) { return std::tuple(c.a, c.b, c.part_a, c.part_b); };
    std::size_t k = 0;
    for (const detect::ContactPoint& truth : exact) {
      for (; k < fcl.size() && names(fcl[k]) < names(truth); ++k)
        surplus += fcl[k].gap < 0.99 * k_margin * thin(fcl[k]);
      const bool found = k < fcl.size() && names(fcl[k]) == names(truth);
      if (truth.gap < k_margin * thin(truth)) {
        ++contacts;
        missed += !found;
      }
      if (!found) continue;
      const double error = std::abs(fcl[k].gap - truth.gap) / thin(truth);
      wrong_depths += error > k_right_depth;
      wrong_normals += fcl[k].n.dot(truth.n) < k_wrong_normal;
      worst_depth = std::max(worst_depth, error);
      ++k;
    }
  }
};

struct Run {
  double load = 0, side = 0, penetration = 0, detection_ms = 0, step_ms = 0;
  long steps = 0;
  detect::DetectorCounts counts;
  Judgement fcl;
};

Run run(const std::string& file, double seconds, const std::string& narrow, bool judge) {
  const scene::Scene scene = scene::read_scene(file, {{"contact/@narrow_phase", narrow}});
  WarningCounts warnings{make_logger("off", "")};
  sim::Simulation simulation(scene, 1, warnings);
  detect::ContactDetector exact(1, NarrowPhase::nilas_alone), fcl(1, NarrowPhase::fcl);
  const bool crushes = scene.fracture && scene.fracture->crushing;
  const int vessel = simulation.vessel_index();
  const detect::PairFilter crushed = [&](int a, int b) { return crushes && (a == vessel || b == vessel); };
  Run out;
  const double end = scene.time.start + seconds;
  while (simulation.time() < end - 0.5 * scene.time.step && simulation.end_of_course().empty()) {
    const sim::StepRecord record = simulation.step();
    ++out.steps;
    out.counts += record.detection;
    out.penetration = std::max(out.penetration, record.penetration_max);
    out.detection_ms += record.ms[static_cast<std::size_t>(sim::Phase::detection)];
    for (const double ms : record.ms) out.step_ms += ms;
    if (record.vessel) {
      out.load -= record.vessel->ice.head<2>().dot(record.vessel->course);
      out.side += record.vessel->ice.head<2>().dot(sim::to_port(record.vessel->course));
    }
    if (!judge) continue;
    const std::vector<double> width = detect::smallest_widths(simulation.bodies());
    double widest = 0;  // of what is a margin to somebody
    for (const double w : width) widest = std::max(widest, std::isfinite(w) ? w : 0);
    const double margin = 1e-2 * std::min(widest, 1.0);
    out.fcl.add(deepest_of_pairs(exact.detect(simulation.bodies(), margin, crushed)),
                deepest_of_pairs(fcl.detect(simulation.bodies(), margin, crushed)), width);
  }
  const auto steps = static_cast<double>(out.steps);
  for (double* sum : {&out.load, &out.side, &out.detection_ms, &out.step_ms}) *sum /= steps;
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return std::fprintf(stderr, "usage: bench_narrow_phase SECONDS SCENE.xml ...\n"), 2;
  std::printf("%-15s %-12s %10s %9s %10s %9s %8s %7s %7s %7s\n", "scene", "narrow phase", "load [N]", "side [N]",
              "depth [m]", "detect ms", "step ms", "kept %", "FCL %", "corr. %");
  std::vector<std::pair<std::string, Judgement>> judged;
  for (int k = 2; k < argc; ++k) {
    const std::string name = std::filesystem::path(argv[k]).stem().string();
    for (const std::string narrow : {"nilas", "nilas-alone", "fcl"}) {
      const Run r = run(argv[k], std::atof(argv[1]), narrow, false);
      const double pairs = 0.01 * static_cast<double>(std::max(r.counts.candidate_pairs, 1L));
      std::printf("%-15s %-12s %10.4g %9.3g %10.2e %9.3f %8.3f %7.3f %7.3f %7.3f\n", name.c_str(), narrow.c_str(),
                  r.load, r.side, r.penetration, r.detection_ms, r.step_ms,
                  static_cast<double>(r.counts.kept_axes + r.counts.cached_separations) / pairs,
                  static_cast<double>(r.counts.by_fcl) / pairs, static_cast<double>(r.counts.corrected) / pairs);
      std::fflush(stdout);
    }
    judged.emplace_back(name, run(argv[k], std::atof(argv[1]), "nilas", true).fcl);
  }
  std::printf("\nFCL's contacts as they are, at the poses of the default run:\n%-15s %10s %8s %8s %8s %8s %12s\n",
              "scene", "contacts", "missed", "surplus", "normals", "depths", "depth/width");
  for (const auto& [name, j] : judged)
    std::printf("%-15s %10ld %8ld %8ld %8ld %8ld %12.1e\n", name.c_str(), j.contacts, j.missed, j.surplus,
                j.wrong_normals, j.wrong_depths, j.worst_depth);
}
