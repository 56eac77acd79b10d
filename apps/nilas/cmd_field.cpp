#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "apps/nilas/commands.h"
#include "core/base/error.h"
#include "core/bodies/mass_properties.h"
#include "core/bodies/polygon.h"
#include "core/field/field.h"
#include "core/scene/read_scene.h"
#include "core/sim/world.h"

namespace nilas {

namespace {

struct FieldOptions {
  std::string spec, out = "field.geojson";
  bool json = false;
};

/// The floes that a scene would start with, in G.
FieldResult floes_of(const WorldParts& parts) {
  FieldResult field;
  field.concentration = parts.info.concentration;
  const Bodies& bodies = parts.bodies;
  for (int k = 0; k < bodies.size(); ++k) {
    const auto b = static_cast<std::size_t>(k);
    if (bodies.kind[b] != BodyKind::floe) continue;
    FieldFloe floe;
    for (const auto& x : bodies.shape[b]->outline)
      floe.outline.emplace_back((bodies.p_GB[b] + bodies.R_GB[b] * Vec3(x.x(), x.y(), 0)).head<2>());
    floe.thickness = bodies.shape[b]->thickness;
    floe.density = bodies.mass[b] / (floe.thickness * polygon_moments(floe.outline).area);
    floe.fixed = bodies.motion[b] == Motion::fixed;
    field.floes.push_back(std::move(floe));
  }
  return field;
}

nlohmann::ordered_json statistics(const FieldResult& field) {
  double area = 0, sum = 0, squares = 0, smallest = 0, largest = 0;
  for (const auto& floe : field.floes) {
    const double a = polygon_moments(floe.outline).area, size = std::sqrt(a);
    area += a;
    sum += size;
    squares += size * size;
    smallest = smallest == 0 ? size : std::min(smallest, size);
    largest = std::max(largest, size);
  }
  const auto n = static_cast<double>(std::max<std::size_t>(field.floes.size(), 1));
  const double mean = sum / n;
  return {{"floes", field.floes.size()},
          {"area_m2", area},
          {"concentration", field.concentration},
          {"size_mean_m", mean},
          {"size_sd_m", std::sqrt(std::max(0.0, squares / n - mean * mean))},
          {"size_min_m", smallest},
          {"size_max_m", largest}};
}

int make_field(const FieldOptions& options) {
  const Scene scene = read_scene(options.spec);
  if (!scene.ice) throw InputError(options.spec + ": the scene has no <ice>");
  auto logger = make_logger("warn", "");
  WarningCounts warnings(logger);
  const FieldResult field = floes_of(build_world(scene, 1, warnings));
  write_field(field, options.out);
  const auto table = statistics(field);
  if (options.json) {
    std::cout << table.dump(2) << "\n";
    return exit_done;
  }
  for (const auto& [name, value] : table.items()) std::cout << "  " << name << "  " << value << "\n";
  std::cout << "written: " << options.out << "\n";
  return exit_done;
}

}  // namespace

void add_field(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("field", "generates the ice field of a scene and writes it as a reusable file");
  auto options = std::make_shared<FieldOptions>();
  command->add_option("spec", options->spec, "scene file whose <ice> and <tank> are read")->required();
  command->add_option("--out", options->out, "GeoJSON file to write")->capture_default_str();
  command->add_flag("--json", options->json, "the statistics as JSON on stdout");
  command->callback([&action, options] { action = [options] { return make_field(*options); }; });
}

}  // namespace nilas
