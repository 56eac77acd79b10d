#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "apps/nilas/commands/commands.h"
#include "apps/nilas/commands/scene_flags.h"
#include "apps/nilas/reports/check_equilibrium.h"
#include "apps/nilas/reports/check_mooring.h"
#include "apps/nilas/reports/check_periods.h"
#include "contact/detect/detector.h"
#include "core/output/loads/run_statistics.h"
#include "core/output/text/console.h"
#include "core/output/text/phase_progress.h"
#include "core/sim/build/build_world.h"
#include "core/sim/world/world.h"

namespace nilas::commands {

namespace {

struct CheckOptions {
  SceneFlags scene;
  bool json = false, quiet = false;
};

struct Estimate {
  int bodies = 0, contacts = 0;
  double memory_MB = 0;
  double statistics_MB = 0;  ///< of statistics.bin
};

/// Estimates the contacts, which are those within one per cent of the mean bounding radius of floes, and the memory of
/// bodies, contacts and, at the end, of the series that a statistic is made of.
Estimate estimate(const sim::WorldParts& parts, long steps) {
  double radius = 0;
  std::size_t bytes = 0;
  const bodies::Bodies& bodies = parts.bodies;
  for (std::size_t b = 0; b < bodies.shape.size(); ++b) {
    const geometry::Shape& shape = *bodies.shape[b];
    if (bodies.kind[b] == bodies::BodyKind::floe) radius += shape.bounding_radius / std::max(parts.info.floes, 1);
    constexpr std::size_t k_bytes_per_vertex = 400;  // vertices, faces, adjacency and the narrow phase's copy
    for (const auto& part : shape.parts) bytes += k_bytes_per_vertex * part.vertices.size();
    bytes += shape.surface.triangles.size() * sizeof(std::array<int, 3>) + shape.surface.vertices.size() * sizeof(Vec3);
  }
  Estimate e;
  e.bodies = bodies.size();
  detect::ContactDetector detector;
  constexpr double k_touching_share = 0.01;
  e.contacts = static_cast<int>(detector.detect(bodies, k_touching_share * radius + 1e-6).size());
  constexpr std::size_t k_bytes_per_body = 2000, k_bytes_per_contact = 2000;
  bytes += static_cast<std::size_t>(e.bodies) * k_bytes_per_body +
           static_cast<std::size_t>(e.contacts) * k_bytes_per_contact;
  const std::size_t numbers = output::RunStatistics::numbers_per_step(parts.info);
  constexpr std::size_t k_series = 4;  // a load, its sizes in order, its sums, and that across
  bytes += std::min(k_series, numbers) * sizeof(double) * static_cast<std::size_t>(steps);
  e.memory_MB = static_cast<double>(bytes) / 1e6;
  e.statistics_MB = static_cast<double>(sizeof(double) * numbers) * static_cast<double>(steps) / 1e6;
  return e;
}

int check(const CheckOptions& options) {
  constexpr std::size_t k_indent = 2, k_reason = 29;
  const scene::Scene scene = read_flagged_scene(options.scene);
  const auto logger = make_logger(options.json ? "off" : "warn", "");
  WarningCounts warnings(logger);
  output::PhaseProgress progress(std::cerr, output::phase_style(options.quiet, options.json), "building the scene");
  progress.make_room_for(*logger);
  sim::WorldParts parts = sim::build_world(scene, 1, warnings);
  progress.next("finding the contacts at the start");
  const long steps = scene::number_of_steps(scene.time);
  const Estimate e = estimate(parts, steps);
  if (scene.vessel) progress.next("finding how the vessel floats");
  const auto equilibrium = vessel_equilibrium(scene, parts);
  const PeriodsReport periods = natural_periods_report(scene, parts);
  const auto mooring = mooring_report(parts);
  progress.end();
  if (options.json) {
    auto modules = nlohmann::ordered_json::object();
    for (const auto& [name, why] : parts.info.modules) modules[name] = why;
    nlohmann::ordered_json result{{"scene", scene.name},
                                  {"valid", true},
                                  {"modules", modules},
                                  {"not_built", parts.info.not_built},
                                  {"notes", scene.notes},
                                  {"derived_defaults", scene.derived},
                                  {"warnings", sim::warning_texts(parts.info)},
                                  {"bodies", e.bodies},
                                  {"floes", parts.info.floes},
                                  {"contacts_estimated", e.contacts},
                                  {"memory_MB_estimated", e.memory_MB},
                                  {"statistics_MB", e.statistics_MB}};
    if (equilibrium) result["equilibrium"] = equilibrium->json;
    result["natural_periods"] = periods.json;
    if (mooring) result["mooring"] = mooring->json;
    std::cout << result.dump(2) << "\n";
    return exit_done;
  }
  for (const auto& text : sim::warning_texts(parts.info))
    std::cout << output::wrapped("warning: " + text, k_indent) << "\n";
  std::cout << fmt::format("{}: valid\n\nrequired by the scene:\n", scene.file.string());
  for (const auto& [name, why] : parts.info.modules)
    std::cout << fmt::format("  {:<26} {}\n", name, output::wrapped(why, k_reason));
  std::cout << "not asked for, so not built:\n ";
  for (const auto& name : parts.info.not_built) std::cout << " " << name;
  std::cout << "\n";
  for (const auto* notes : {&scene.notes, &scene.derived})
    for (const auto& note : *notes) std::cout << output::wrapped("note: " + note, k_indent) << "\n";
  if (equilibrium) std::cout << equilibrium->text;
  std::cout << periods.text;
  if (mooring) std::cout << mooring->text;
  std::cout << fmt::format("\n{} bodies ({} floes), about {} contacts, about {:.0f} MB, {} steps of {} s\n", e.bodies,
                           parts.info.floes, e.contacts, std::ceil(e.memory_MB), steps, scene.time.step);
  if (e.statistics_MB > 0)
    std::cout << fmt::format("{:.3g} MB of numbers for the statistics in the run folder\n", e.statistics_MB);
  return exit_done;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("check", "Validates a scene without running it and states what it requires.");
  auto options = std::make_shared<CheckOptions>();
  add_scene_flags(*command, options->scene);
  command->add_flag("--json", options->json, "Prints the result as JSON on standard output.");
  command->add_flag("--quiet", options->quiet, "Prints no progress.");
  command->callback([&action, options] { action = [options] { return check(*options); }; });
}

}  // namespace nilas::commands
