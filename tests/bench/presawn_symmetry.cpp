/// The pre-sawn scenes are their own images in the plane y = 0. For each solver the table shows from when on the two
/// sides differ, in which stage of a step first, and by how much. The growth of a perturbation larger than rounding is
/// measured as well.
/// usage: bench_presawn_symmetry [END] [SOLVER[=TOLERANCE] ...]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/support/mirror_images.h"
#include "tests/support/presawn.h"

namespace {

using namespace nilas;

constexpr int k_looks_per_second = 20;

/// One run to its end.
struct Course {
  double differs_from = -1;  ///< Time of the first difference [s]; below 0 when there is none.
  std::string stage;         ///< First stage that differs.
  std::vector<double> size;  ///< Largest asymmetry of a position since the start, at each sample [m].
  long steps = 0, misses = 0;
  double seconds = 0;
  Vec3 load = Vec3::Zero();  ///< Mean contact force on the ship [N].

  double at(double t) const {
    const auto look = static_cast<std::size_t>(std::lround(t * k_looks_per_second));
    return size.at(std::min(look, size.size()) - 1);
  }
};

struct Setting {
  std::string solver;
  double tolerance = 1e-6;
};

Course run(char letter, const Setting& setting, double end, double moved) {
  scene::Scene scene = moved > 0 ? test::presawn(letter, 1, moved) : test::shipped_presawn(letter);
  scene.contact.solver = choice_named<SolverName>(setting.solver);
  scene.contact.tolerance = setting.tolerance;
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(scene, 1, warnings);
  const double near = 1e-3;  // Larger than the perturbation of the pieces.
  const test::MirrorImages images(simulation.bodies(), near);
  Course course;
  course.steps = std::lround(end / scene.time.step);
  const long look = std::lround(1 / (k_looks_per_second * scene.time.step));
  double worst = 0;
  for (long k = 1; k <= course.steps; ++k) {
    const sim::StepRecord record = simulation.step();
    for (const double ms : record.ms) course.seconds += 1e-3 * ms;
    course.misses += record.solver_short ? 1 : 0;
    course.load += record.vessel->contact.force / static_cast<double>(course.steps);
    const test::StepAsymmetry found = images.measure(simulation);
    worst = std::max(worst, found.poses);
    if (course.differs_from < 0 && !found.none()) {
      course.differs_from = record.t;
      course.stage = found.first_stage();
    }
    if (k % look == 0) course.size.push_back(worst);
  }
  return course;
}

void report(char letter, const Setting& setting, double end) {
  const Course course = run(letter, setting, end, 0);
  char from[32] = "never";
  if (course.differs_from >= 0) std::snprintf(from, sizeof from, "%.3f s", course.differs_from);
  std::printf("| %c | %s | %.0e | %s | %s |", letter, setting.solver.c_str(), setting.tolerance, from,
              course.stage.c_str());
  for (const double t : {3.0, 4.0, 5.0, 6.0, 8.0, 10.0})
    if (t <= end) std::printf(" %.1e |", course.at(t));
  std::printf(" %.3f | %.3f | %ld of %ld | %.1f |\n", course.load.x(), course.load.y(), course.misses, course.steps,
              course.seconds);
  std::fflush(stdout);
}

/// Time in which the asymmetry grows e-fold while it is small, from a line through the logarithms of the samples [s].
double growth_time(const Course& course, double from, double to) {
  double n = 0, t = 0, y = 0, tt = 0, ty = 0;
  for (std::size_t k = 0; k < course.size.size(); ++k) {
    if (course.size[k] < from || course.size[k] > to) continue;
    const double time = static_cast<double>(k + 1) / k_looks_per_second, value = std::log(course.size[k]);
    n += 1;
    t += time;
    y += value;
    tt += time * time;
    ty += time * value;
  }
  return (n * tt - t * t) / (n * ty - t * y);
}

/// Reports the growth for pieces moved by up to a nanometre, at a tolerance at which the solver adds next to no error.
void report_growth(char letter, double end) {
  constexpr double k_moved = 1e-9, k_small = 2 * k_moved, k_large = 1e-4;
  const Course course = run(letter, {"newton-order-free", 1e-10}, end, k_moved);
  std::printf("| %c |", letter);
  for (const double t : {2.0, 3.0, 4.0, 5.0, 6.0})
    if (t <= end) std::printf(" %.1e |", course.at(t));
  std::printf(" %.2f s | %ld of %ld |\n", growth_time(course, k_small, k_large), course.misses, course.steps);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const double end = argc > 1 ? std::atof(argv[1]) : 10;
  std::vector<Setting> settings;
  for (int i = 2; i < argc; ++i) {
    const std::string text = argv[i];
    const auto sign = text.find('=');
    settings.push_back({text.substr(0, sign)});
    if (sign != std::string::npos) settings.back().tolerance = std::atof(text.c_str() + sign + 1);
  }
  if (settings.empty()) settings = {{"auto"}, {"nsgs"}, {"newton"}, {"newton", 1e-10}, {"newton-order-free"}};
  std::printf("| case | solver | tolerance [m/s] | differs from | first in |");
  for (const int t : {3, 4, 5, 6, 8, 10})
    if (t <= end) std::printf(" %d s [m] |", t);
  std::printf(" mean Fx [N] | mean Fy [N] | steps above tolerance | computing [s] |\n");
  for (const char letter : {'a', 'b', 'c'})
    for (const Setting& setting : settings) report(letter, setting, end);
  std::printf("\nPieces moved by up to 1e-9 m, newton-order-free at 1e-10 m/s:\n| case |");
  for (const int t : {2, 3, 4, 5, 6})
    if (t <= end) std::printf(" %d s [m] |", t);
  std::printf(" grows e-fold in | steps above tolerance |\n");
  for (const char letter : {'a', 'b', 'c'}) report_growth(letter, std::min(end, 6.0));
}
