/// Towing through level ice: mean load against Lindqvist's formula at several thicknesses and speeds, and its
/// convergence over steps and hull meshes. Every row has perturbed runs whose ship starts up to a tenth of a millimetre
/// off the middle. The last table compares a field of broken floes with and without breaking.
/// usage: bench_level_ice loads|steps|meshes|field [TWINS] [THREADS] [FOLDER of the picture that loads draws]
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "core/base/random.h"
#include "core/hull/hull.h"
#include "core/output/text/plot.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "fracture/bend/resistance.h"
#include "tests/bench/twins.h"

namespace {

using namespace nilas;
using namespace nilas::bench;

constexpr double k_moved = 1e-4;  // [m]
constexpr long k_quarters = 4;
constexpr double k_measured = 1.5;  // Distance over which the load is measured, once the bow is in the ice [m].

struct Setting {
  double thickness = 0.04, speed = 0.3, step = 0.01;
  int triangles = 6000;
};

struct Course {
  double load = 0, peak = 0;        ///< Mean and largest force against the motion [N].
  double radius = 0;                ///< Mean R_bending [m].
  double events = 0, floes = 0;     ///< Numbers of the whole run.
  double fastest = 0;               ///< Speed of the fastest floe [m/s].
  double ms = 0, ms_breaking = 0;   ///< Mean time of a step.
  double ms_break = 0;              ///< Additional time of a step in which ice breaks.
  std::vector<double> floes_over;   ///< Numbers of floes at every quarter of the scene's time, from its start on.
  double imbalance = 0, scale = 0;  ///< Largest energy error, and energy put in [J].
};

double aside(std::uint64_t twin) {
  RandomStream random(twin, "level-ice");
  return twin == 0 ? 0 : random.uniform(-k_moved, k_moved);
}

scene::Scene scene_of(const Setting& setting, std::uint64_t twin) {
  const auto text = [](double x) { return std::to_string(x); };
  scene::Scene scene = scene::read_scene(std::string(NILAS_SOURCE_DIR) + "/apps/scenes/level-ice.xml",
                                         {{"ice/@thickness", text(setting.thickness)},
                                          {"vessel/carriage/@speed", text(setting.speed)},
                                          {"time/@step", text(setting.step)}});
  scene.vessel->position.y() += aside(twin);
  scene.vessel->hull.clear();
  scene.vessel->generate = {HullKind::icebreaker, {{"triangles", setting.triangles}}};
  return scene;
}

double speed_of_fastest_floe(const bodies::Bodies& bodies) {
  double fastest = 0;
  for (std::size_t b = 0; b < bodies.id.size(); ++b)
    if (bodies.kind[b] == bodies::BodyKind::floe) fastest = std::max(fastest, bodies.v_GB[b].norm());
  return fastest;
}

/// Runs to the scene's end, or until the ship has moved this distance in the ice.
Course run(const scene::Scene& scene, double way_in_ice, double way_before_load) {
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(scene, 1, warnings);
  const double start = simulation.bodies().p_GB[simulation.vessel_index()].x();
  const auto begun = std::chrono::steady_clock::now();
  Course course;
  long measured = 0, steps = 0;
  double first_touch = -1;
  const long last = std::lround((scene.time.end - scene.time.start) / scene.time.step);
  double ms_with_breaks = 0;
  long steps_with_breaks = 0;
  course.floes_over = {static_cast<double>(simulation.info().floes)};
  for (double way = 0; steps < last && (first_touch < 0 || way < first_touch + way_in_ice); ++steps) {
    const sim::StepRecord record = simulation.step();
    way = simulation.bodies().p_GB[simulation.vessel_index()].x() - start;
    const double against = -record.vessel->contact.force.x();
    if (first_touch < 0 && against > 0) first_touch = way;
    course.peak = std::max(course.peak, against);
    if (first_touch >= 0 && way >= first_touch + way_before_load) {
      course.load += against;
      ++measured;
    }
    if (!record.broken.empty()) {
      ms_with_breaks += record.ms[static_cast<std::size_t>(sim::Phase::fracture)];
      ++steps_with_breaks;
    }
    if ((steps + 1) * k_quarters >= static_cast<long>(course.floes_over.size()) * last)
      course.floes_over.push_back(record.floes);
    for (const fracture::FractureEvent& event : record.broken) {
      course.events += 1;
      course.radius += event.radius;
    }
    course.fastest = std::max(course.fastest, speed_of_fastest_floe(simulation.bodies()));
    course.ms_breaking += record.ms[static_cast<std::size_t>(sim::Phase::fracture)];
    course.imbalance = std::max(course.imbalance, std::abs(record.ledger.imbalance));
    course.scale = 0;
    for (const double work : record.ledger.works) course.scale += std::abs(work);
  }
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begun;
  course.load /= static_cast<double>(std::max(measured, 1L));
  if (steps > steps_with_breaks && course.events > 0) {
    const double without = (course.ms_breaking - ms_with_breaks) / static_cast<double>(steps - steps_with_breaks);
    course.ms_break = (ms_with_breaks - static_cast<double>(steps_with_breaks) * without) / course.events;
  }
  course.radius /= std::max(course.events, 1.0);
  course.floes = static_cast<double>(simulation.bodies().size());
  course.ms = took.count() / static_cast<double>(steps);
  course.ms_breaking /= static_cast<double>(steps);
  return course;
}

double lindqvist(const scene::Scene& scene, const Setting& setting) {
  const hull::HullForm form = hull::hull_form("icebreaker", {});
  fracture::LevelIce ice;
  ice.thickness = setting.thickness;
  ice.flexural_strength = scene.fracture->flexural_strength;
  ice.youngs_modulus = scene.ice->youngs_modulus;
  ice.poisson = scene.ice->poisson;
  ice.density = scene.ice->density;
  ice.water_density = scene.water->density;
  ice.friction = 0.1;
  return fracture::lindqvist_resistance({form.length, form.beam, form.draught, form.stem_angle, form.entrance_angle},
                                        ice, setting.speed)
      .total;
}

void print_rest(const std::vector<Course>& courses) {
  const auto mean = [&](auto value) { return mean_of(courses, value).value; };
  std::printf(" %.0f | %.3f | %.0f | %.0f | %.2f | %.1e | %.1f | %.2f |\n",
              mean([](const Course& c) { return c.peak; }), mean([](const Course& c) { return c.radius; }),
              mean([](const Course& c) { return c.events; }), mean([](const Course& c) { return c.floes; }),
              mean([](const Course& c) { return c.fastest; }),
              mean([](const Course& c) { return c.imbalance / c.scale; }), mean([](const Course& c) { return c.ms; }),
              mean([](const Course& c) { return c.ms_breaking; }));
  std::fflush(stdout);
}

constexpr const char* k_rest_of_head =
    " peak [N] | R_bending [m] | breaks | bodies | fastest floe [m/s] | energy error | ms per step | of these crushing "
    "and breaking |\n";

struct Point {
  Setting setting;
  Mean load;           // [N]
  double formula = 0;  // Lindqvist [N]
};

/// Draws loads over speed, one colour per thickness. Bars are standard errors, lines the formula.
void draw_loads(const std::filesystem::path& folder, const std::vector<Point>& points) {
  std::map<double, std::string> data;
  for (const Point& p : points)
    data[p.setting.thickness] += fmt::format("{} {} {} {}\n", p.setting.speed, p.load.value, p.load.error, p.formula);
  std::string script =
      "set terminal pngcairo size 900,600\nset output 'level-ice.png'\nset xlabel 'speed [m/s]'\n"
      "set ylabel 'mean resistance in level ice [N]'\nset key top left\nset xrange [0:*]\nset yrange [0:*]\n"
      "set offsets 0, 0.05, 10, 0\n";
  std::string lines;
  int colour = 0;
  for (const auto& [thickness, rows] : data) {
    ++colour;
    script += fmt::format("$h{} << EOD\n{}EOD\n", colour, rows);
    lines += fmt::format(
        "{}$h{} using 1:2:3 with yerrorbars pt 7 lc {} title '{:.0f} mm', "
        "$h{} using 1:4 with lines lc {} title '{:.0f} mm, Lindqvist'",
        lines.empty() ? "plot " : ", ", colour, colour, 1000 * thickness, colour, colour, 1000 * thickness);
  }
  output::plot(folder, script + lines + "\n");
  std::printf("\npicture: %s\n", (folder / "level-ice.png").c_str());
}

std::vector<Point> level_ice(const std::vector<Setting>& rows, int twins, int threads) {
  std::vector<Point> points;
  std::printf("| h [mm] | v [m/s] | step [s] | triangles | mean load [N] | Lindqvist [N] | ratio |%s", k_rest_of_head);
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  const double bow = hull::hull_form("icebreaker", {}).bow_length;
  for (const Setting& row : rows) {
    const std::vector<Course> courses =
        with_twins(twins, threads, [&](std::uint64_t twin) { return run(scene_of(row, twin), bow + k_measured, bow); });
    const Mean load = mean_of(courses, [](const Course& c) { return c.load; });
    const double formula = lindqvist(scene_of(row, 0), row);
    std::printf("| %g | %g | %g | %d | %.1f +- %.1f | %.1f | %.2f |", 1000 * row.thickness, row.speed, row.step,
                row.triangles, load.value, load.error, formula, load.value / formula);
    print_rest(courses);
    points.push_back({row, load, formula});
  }
  return points;
}

/// Prints a row for the seed's scene with ice that may not break, and one with ice that may.
void broken_field(int twins, int threads) {
  std::printf("| breakable | floes over time | ms that a break adds | mean load [N] |%s", k_rest_of_head);
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const char* breakable : {"false", "true"}) {
    const std::vector<Course> courses = with_twins(twins, threads, [&](std::uint64_t twin) {
      scene::Scene scene = scene::read_scene(std::string(NILAS_SOURCE_DIR) + "/apps/scenes/metrikin-2014.xml",
                                             {{"ice/field/@breakable", breakable}});
      scene.vessel->position.y() += aside(twin);
      return run(scene, 1e9, 0);
    });
    const Mean load = mean_of(courses, [](const Course& c) { return c.load; });
    std::string floes;
    for (std::size_t k = 0; k < courses.front().floes_over.size(); ++k)
      floes += fmt::format("{}{:.0f}", k == 0 ? "" : ", ",
                           mean_of(courses, [&](const Course& c) { return c.floes_over[k]; }).value);
    std::printf("| %s | %s | %.2f | %.1f +- %.1f |", breakable, floes.c_str(),
                mean_of(courses, [](const Course& c) { return c.ms_break; }).value, load.value, load.error);
    print_rest(courses);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string table = argc > 1 ? argv[1] : "loads";
  const int twins = argc > 2 ? std::atoi(argv[2]) : 2, threads = argc > 3 ? std::atoi(argv[3]) : 2;
  std::vector<Setting> rows;
  if (table == "loads")
    for (const double thickness : {0.03, 0.04, 0.05})
      for (const double speed : {0.2, 0.4}) rows.push_back({.thickness = thickness, .speed = speed});
  if (table == "steps")
    for (const double step : {0.02, 0.01, 0.005, 0.0025}) rows.push_back({.step = step});
  if (table == "meshes")
    for (const int triangles : {2000, 6000, 18000}) rows.push_back({.triangles = triangles});
  if (!rows.empty()) {
    const std::vector<Point> points = level_ice(rows, twins, threads);
    if (table == "loads") draw_loads(argc > 4 ? argv[4] : ".", points);
  } else if (table == "field") {
    broken_field(twins, threads);
  } else {
    std::fprintf(stderr, "level_ice knows the tables loads, steps, meshes and field\n");
    return 2;
  }
}
