/// The pre-sawn scenes to their ends on both hull meshes of the paper whose tests they follow, each with perturbed runs
/// whose pieces are moved by up to a micrometre. The tables show the penetration of hull and sheets, and whether the
/// mean load depends on the mesh.
/// usage: bench_presawn [TWINS] [THREADS]
#include "tests/support/presawn.h"

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/bench/twins.h"

namespace {

using namespace nilas;
using namespace nilas::bench;

constexpr double k_moved = 1e-6, k_thickness = 0.04;  // [m]

struct Course {
  /// Largest penetration by the contact search, and depths in hull and sheets by the oracle [m].
  double penetration = 0, in_hull = 0, in_sheets = 0;
  double load = 0, port = 0, starboard = 0, side = 0;  ///< Mean forces from the first contact on [N].
};

/// Runs a scene. The depths are measured in every step of the unperturbed field, and every 0.05 s of a perturbed one.
Course run(char letter, int triangles, std::uint64_t seed) {
  const scene::Scene scene = test::presawn(letter, seed, k_moved, triangles);
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(scene, 1, warnings);
  const test::PresawnOverlap overlap(simulation);
  const long look = seed == 0 ? 1 : std::lround(0.05 / scene.time.step);
  Course course;
  long loaded = 0;
  for (const long steps = std::lround(scene.time.end / scene.time.step); simulation.steps() < steps;) {
    const sim::StepRecord record = simulation.step();
    const sim::VesselRecord& vessel = *record.vessel;
    course.penetration = std::max(course.penetration, record.penetration_max);
    if (loaded > 0 || !vessel.contact.force.isZero(0)) {
      ++loaded;
      course.load += vessel.contact.force.x();
      course.side += vessel.contact.force.y();
      course.port += vessel.contact_port.x();
      course.starboard += vessel.contact_starboard.x();
    }
    if (record.step % look != 0) continue;
    const auto depth = overlap.measure();
    course.in_hull = std::max(course.in_hull, depth.hull);
    course.in_sheets = std::max(course.in_sheets, depth.sheets);
  }
  for (double* mean : {&course.load, &course.port, &course.starboard, &course.side})
    *mean /= static_cast<double>(std::max(loaded, 1L));
  return course;
}

template <class Value>
double worst(const std::vector<Course>& courses, const Value& value) {
  double most = 0;
  for (const auto& course : courses) most = std::max(most, value(course));
  return 100 * most / k_thickness;
}

Mean report(char letter, int triangles, const std::vector<Course>& courses) {
  const Mean load = mean_of(courses, [](const Course& c) { return c.load; });
  const Mean sides = mean_of(courses, [](const Course& c) { return c.port - c.starboard; });
  const Mean side = mean_of(courses, [](const Course& c) { return c.side; });
  std::printf("| %c | %d | %zu | %.2f %% | %.2f %% | %.2f %% | %.3f +- %.3f | %.3f +- %.3f | %.3f +- %.3f |\n", letter,
              triangles, courses.size(), worst(courses, [](const Course& c) { return c.penetration; }),
              worst(courses, [](const Course& c) { return c.in_hull; }),
              worst(courses, [](const Course& c) { return c.in_sheets; }), load.value, load.error, sides.value,
              sides.error, side.value, side.error);
  std::fflush(stdout);
  return load;
}

}  // namespace

int main(int argc, char** argv) {
  const int twins = argc > 1 ? std::atoi(argv[1]) : 7, threads = argc > 2 ? std::atoi(argv[2]) : 2;
  std::printf(
      "| case | triangles | runs | penetration | in the hull | in the sheets | mean Fx [N] | port - starboard Fx "
      "[N] | mean Fy [N] |\n|---|---|---|---|---|---|---|---|---|\n");
  std::string differences;
  for (const char letter : {'a', 'b', 'c'}) {
    std::vector<Mean> loads;
    for (const int triangles : {6000, 18000}) {
      loads.push_back(report(letter, triangles, with_twins(twins, threads, [&](std::uint64_t twin) {
                               return run(letter, triangles, twin);
                             })));
    }
    // The factor makes the quotients percentages.
    const double scale = 0.005 * std::abs(loads[0].value + loads[1].value);
    char line[128];
    std::snprintf(line, sizeof line, "%c: load of the two meshes differs by %.2f +- %.2f %%\n", letter,
                  std::abs(loads[1].value - loads[0].value) / scale,
                  std::hypot(loads[0].error, loads[1].error) / scale);
    differences += line;
  }
  std::printf("\n%s", differences.c_str());
}
