/// The packed scene on Nilas, and the file from which the peers read the same scene.
/// usage: bench_packed write FLOES FOLDER     makes FOLDER/packed-FLOES.{xml,geojson,txt}
///        bench_packed run FOLDER FLOES SWEEPS [TOLERANCE [FRICTION [SOLVER]]]
///            sweeps of pgs on pyramids; 0: SOLVER (auto) on the exact cone to TOLERANCE (1e-6 m/s), with FRICTION
///            (0.15) everywhere; cold: the same from zero impulses in every step
///        bench_packed load FOLDER FLOES SWEEPS [TOLERANCE [FRICTION [SOLVER]]]
///            the same runs, whose steps are all solved a second time to 1e-8 m/s: how far the hull load of a step is
///            off
/// The environment variable THREADS sets the number of threads, 1 by default.
#include <malloc.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/field/field.h"
#include "core/output/loads/step_load.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/bench/peers/floe_scene.h"

namespace {

using namespace nilas;
namespace fs = std::filesystem;

constexpr double k_thickness = 0.05, k_size = 0.46, k_concentration = 0.85, k_current = 0.1, k_hull_speed = 0.3;
constexpr double k_length = 6, k_bow = 1, k_beam = 1, k_keel = -0.35, k_deck = 0.15;

struct Basin {
  double x1 = 0, half_width = 0;
};

/// The hull's stem stands 1.5 m inside the ice, which fills the basin from x = 0.
constexpr double k_stem = 1.5;

Basin basin_for(int floes) {
  const double area = floes * k_size * k_size / k_concentration;
  const double width = std::max(4.0, std::sqrt(area / 2));
  return {(area + k_stem * k_beam) / width, 0.5 * width};
}

field::FieldResult make_floes(const Basin& basin) {
  field::PackedSpec spec;
  spec.low = {0, -basin.half_width};
  spec.high = {basin.x1, basin.half_width};
  spec.concentration = k_concentration;
  spec.mean = k_size;
  spec.sd = 0.08;
  spec.min = 0.3;
  spec.max = 0.7;
  spec.vertices_min = 5;
  spec.vertices_max = 8;
  spec.seed = 11;
  const double b = 0.5 * k_beam;
  spec.keep_out = {
      {{k_stem - k_length, -b}, {k_stem - k_bow, -b}, {k_stem, 0}, {k_stem - k_bow, b}, {k_stem - k_length, b}}};
  spec.keep_out_margin = 0.01;
  return field::pack_field(spec);
}

void write_scene(const fs::path& file, const Basin& basin, const std::string& field) {
  std::ofstream out(file);
  const double lead = k_length;  // The walls start behind the hull.
  out << "<scene version=\"1\" name=\"" << file.stem().string() << "\">\n"
      << "  <time step=\"0.01\" start=\"0\" end=\"2.4\"/>\n"
      << "  <contact law=\"pyramid\" solver=\"pgs\" tolerance=\"0\" max_iterations=\"50\" "
         "stabilisation=\"split-impulse\"\n"
      << "           detection=\"discrete\" integrator=\"semi-implicit-euler\">\n"
      << "    <friction between=\"* *\" static=\"0.15\" kinetic=\"0.15\"/>\n  </contact>\n"
      << "  <water density=\"1005\"><current velocity=\"" << k_current << " 0 0\"/></water>\n"
      << "  <hydro><buoyancy/><drag form=\"1\" skin=\"0.005\"/></hydro>\n"
      << "  <vessel name=\"ship\" position=\"" << k_stem - k_length << " 0 " << k_keel << "\">\n"
      << "    <hull generate=\"wedge\" length=\"" << k_length << "\" beam=\"" << k_beam << "\" draught=\"" << -k_keel
      << "\" depth=\"" << k_deck - k_keel << "\" bow_length=\"" << k_bow << "\" triangles=\"600\"/>\n"
      << "    <mass value=\"1500\"/>\n    <carriage speed=\"" << k_hull_speed
      << "\"><force_balance kind=\"rigid\"/></carriage>\n"
      << "  </vessel>\n"
      << "  <ice density=\"920\" thickness=\"" << k_thickness << "\"><field kind=\"file\" file=\"" << field
      << "\"/></ice>\n";
  const double w = basin.half_width, middle = 0.5 * (basin.x1 - lead), length = basin.x1 + lead + 1;
  const auto wall = [&](const char* name, double sx, double sy, double x, double y) {
    out << "  <body name=\"" << name << "\" shape=\"box\" fixed=\"true\" material=\"wall\" size=\"" << sx << " " << sy
        << " 1\" position=\"" << x << " " << y << " 0\"/>\n";
  };
  wall("port", length, 0.2, middle, w + 0.1);
  wall("starboard", length, 0.2, middle, -w - 0.1);
  wall("end", 0.2, 2 * w, basin.x1 + 0.1, 0);
  wall("start", 0.2, 2 * w, -lead - 0.1, 0);
  out << "</scene>\n";
}

void write_for_peers(const fs::path& file, const Basin& basin, const field::FieldResult& field) {
  std::ofstream out(file);
  out.precision(17);
  out << k_thickness << " " << -k_length << " " << basin.x1 << " " << -basin.half_width << " " << basin.half_width
      << " " << k_current << "\n"
      << k_stem - k_length << " " << k_length << " " << k_bow << " " << k_beam << " " << k_keel << " " << k_deck << " "
      << k_hull_speed << "\n"
      << field.floes.size() << "\n";
  for (const auto& floe : field.floes) {
    out << floe.outline.size();
    for (const auto& p : floe.outline) out << " " << p.x() << " " << p.y();
    out << "\n";
  }
}

int write(int floes, const fs::path& folder) {
  fs::create_directories(folder);
  const Basin basin = basin_for(floes);
  const field::FieldResult field = make_floes(basin);
  const std::string stem = "packed-" + std::to_string(floes);
  field::write_field(field, folder / (stem + ".geojson"));
  write_scene(folder / (stem + ".xml"), basin, stem + ".geojson");
  write_for_peers(folder / (stem + ".txt"), basin, field);
  std::fprintf(stderr, "%s: %zu floes, concentration %.3f\n", stem.c_str(), field.floes.size(), field.concentration);
  return 0;
}

struct Asked {
  std::string floes, sweeps, tolerance = "1e-6", friction = "0.15", solver = "auto";

  bool cold() const { return sweeps == "cold"; }
  bool exact() const { return cold() || sweeps == "0"; }
};

/// The scene as asked for, in which so many steps are solved a second time.
scene::Scene scene_for(const fs::path& folder, const Asked& asked, int load_checks) {
  const bool cold = asked.cold(), exact = asked.exact();
  scene::Overrides changes{{"contact/@max_iterations", exact ? "1000" : asked.sweeps},
                           {"output/@load_checks", std::to_string(load_checks)},
                           {"contact/friction/@static", asked.friction},
                           {"contact/friction/@kinetic", asked.friction}};
  if (exact)
    changes.insert(
        changes.end(),
        {{"contact/@solver", asked.solver}, {"contact/@law", "coulomb"}, {"contact/@tolerance", asked.tolerance}});
  if (cold) changes.emplace_back("contact/@warm_start", "false");
  return scene::read_scene(folder / ("packed-" + asked.floes + ".xml"), changes);
}

int threads() {
  const char* const asked = std::getenv("THREADS");
  return asked != nullptr ? std::stoi(asked) : 1;
}

std::string engine_of(const Asked& asked) {
  std::string engine = asked.cold() ? "nilas-cold" : asked.exact() ? "nilas-" + asked.solver : "nilas";
  if (asked.exact() && asked.tolerance != Asked{}.tolerance) engine += "-" + asked.tolerance;
  if (asked.friction != Asked{}.friction) engine += "-friction-" + asked.friction;
  if (threads() > 1) engine += "-threads-" + std::to_string(threads());
  return engine;
}

int run(const fs::path& folder, const Asked& asked) {
  const bool exact = asked.exact();
  const scene::Scene scene = scene_for(folder, asked, 0);
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(scene, threads(), warnings);
  std::vector<peers::Parts> window;
  std::vector<double> natural_maps;
  double contacts = 0, penetration = 0;
  int missed = 0;
  for (int n = 0; n < peers::k_last_measured; ++n) {
    const double t0 = peers::now_ms();
    const sim::StepRecord record = simulation.step();
    const double total = peers::now_ms() - t0;
    if (n < peers::k_first_measured) continue;
    const auto ms = [&](sim::Phase phase) { return record.ms[static_cast<std::size_t>(phase)]; };
    window.push_back(
        {ms(sim::Phase::detection),
         ms(sim::Phase::assembly) + ms(sim::Phase::solver) + ms(sim::Phase::integration) + ms(sim::Phase::output),
         ms(sim::Phase::hydro), total});
    natural_maps.push_back(record.residuals.natural_map_m_s);
    contacts += record.contacts;
    if (exact && !(record.residuals.law_map_m_s <= std::stod(asked.tolerance))) ++missed;
    penetration = std::max(penetration, record.penetration_max);
  }
  peers::print_row(engine_of(asked).c_str(), static_cast<std::size_t>(simulation.info().floes),
                   exact ? 0 : std::stoi(asked.sweeps), window, contacts / static_cast<double>(window.size()),
                   penetration / k_thickness, natural_maps, missed);
  return 0;
}

/// Prints engine, floes, sweeps, steps checked, steps whose second solution did not succeed, mean load [N], and the
/// median and 95th percentile of the error over that.
int load(const fs::path& folder, const Asked& asked) {
  const scene::Scene scene = scene_for(folder, asked, peers::k_last_measured);
  WarningCounts warnings(make_logger("off", ""));
  sim::Simulation simulation(scene, threads(), warnings);
  output::StepLoads loads;
  for (int n = 0; n < peers::k_last_measured; ++n) loads.add(simulation.step());
  const output::StepLoadError error =
      loads.error(simulation.info(), {0, 0, peers::k_first_measured, peers::k_last_measured, ""});
  std::printf("%s,%d,%d,%ld,%ld,%.4g,%.4g,%.4g\n", engine_of(asked).c_str(), simulation.info().floes,
              asked.exact() ? 0 : std::stoi(asked.sweeps), error.checked, error.unsolved, error.mean, error.median,
              error.p95);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int k_keep_bytes = 1 << 28;  // The program itself sets the same value.
  mallopt(M_TRIM_THRESHOLD, k_keep_bytes);
  mallopt(M_MMAP_THRESHOLD, k_keep_bytes);
  const std::string mode = argc > 1 ? argv[1] : "";
  if (mode == "write" && argc == 4) return write(std::stoi(argv[2]), argv[3]);
  if ((mode == "run" || mode == "load") && argc >= 5 && argc <= 8) {
    Asked asked{argv[3], argv[4]};
    if (argc > 5) asked.tolerance = argv[5];
    if (argc > 6) asked.friction = argv[6];
    if (argc > 7) asked.solver = argv[7];
    return mode == "run" ? run(argv[2], asked) : load(argv[2], asked);
  }
  std::fprintf(
      stderr,
      "usage: bench_packed write FLOES FOLDER | run|load FOLDER FLOES SWEEPS [TOLERANCE [FRICTION [SOLVER]]]\n");
  return 2;
}
