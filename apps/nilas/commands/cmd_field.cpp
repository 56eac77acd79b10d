#include <algorithm>
#include <iostream>

#include "apps/nilas/commands/commands.h"
#include "apps/nilas/commands/scene_flags.h"
#include "apps/nilas/reports/field_picture.h"
#include "apps/nilas/reports/field_report.h"
#include "core/base/error.h"
#include "core/output/text/phase_progress.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/build/build_world.h"

namespace nilas::commands {

namespace {

struct FieldOptions {
  SceneFlags scene;
  std::string out = "field.geojson", picture;
  int threads = 1;
  bool no_picture = false, json = false, quiet = false;
};

/// All floes of a scene as one field. Its concentration is the share of ice in all water in which fields of free floes
/// were laid out.
field::FieldResult as_one_field(const sim::WorldParts& parts, const std::vector<FieldReport>& reports) {
  field::FieldResult all;
  for (const sim::PlannedIce& ice : parts.ice)
    for (const auto& one : ice.floes) {
      all.floes.push_back(one.floe);
      all.floes.back().fixed = one.fixed;
    }
  for (const sim::PlannedIce& ice : parts.ice)
    all.weak_lines.insert(all.weak_lines.end(), ice.weak_lines.begin(), ice.weak_lines.end());
  double ice_area = 0, free_area = 0;
  for (const FieldReport& report : reports) {
    all.worst_overlap = std::max(all.worst_overlap, report.deepest_overlap);
    if (report.concentration <= 0) continue;
    all.concentration = report.concentration;
    ice_area += report.area;
    free_area += report.area / report.concentration;
  }
  if (reports.size() > 1 && free_area > 0) all.concentration = ice_area / free_area;
  return all;
}

std::string picture_file(const FieldOptions& options) {
  if (options.no_picture) return "";
  if (!options.picture.empty()) return options.picture;
  return std::filesystem::path(options.out).replace_extension(".png").string();
}

int make_field(const FieldOptions& options) {
  const scene::Scene scene = read_flagged_scene(options.scene);
  if (!scene.ice) throw InputError(options.scene.file + ": the scene has no <ice>");
  const auto logger = make_logger("warn", "");
  WarningCounts warnings(logger);
  output::PhaseProgress progress(std::cerr, output::phase_style(options.quiet, options.json), "laying out the ice");
  progress.make_room_for(*logger);
  const sim::WorldParts parts = sim::build_world(scene, options.threads, warnings);
  progress.next("measuring the ice");
  const std::vector<FieldReport> reports = field_reports(scene, parts);
  const field::FieldResult all = as_one_field(parts, reports);
  field::write_field(all, options.out);
  const std::string picture = reports.empty() ? "" : picture_file(options);
  if (!picture.empty()) progress.next("drawing " + picture);
  if (!picture.empty()) draw_field(picture, scene.name, parts.ice, reports);
  progress.end();
  if (options.json) {
    nlohmann::ordered_json json{{"scene", scene.name}, {"file", options.out}, {"floes", all.floes.size()}};
    if (!picture.empty()) json["picture"] = picture;
    double area = 0;
    for (const auto& report : reports) area += report.area;
    json["area_m2"] = area;
    json["concentration"] = all.concentration;
    json["worst_overlap_m"] = all.worst_overlap;
    json["fields"] = nlohmann::ordered_json::array();
    for (const auto& report : reports) json["fields"].push_back(report_json(report));
    json["notes"] = scene.notes;
    std::cout << json.dump(2) << "\n";
    return exit_done;
  }
  for (const auto& report : reports) std::cout << report_text(report) << "\n";
  for (const auto& note : scene.notes) std::cout << "note: " << note << "\n";
  std::cout << "written: " << options.out << (picture.empty() ? "" : ", " + picture) << "\n";
  return exit_done;
}

}  // namespace

void add_field(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "field", "Generates the ice of a scene, writes it to a reusable file, draws a picture and prints statistics.");
  auto options = std::make_shared<FieldOptions>();
  command
      ->add_option("spec", options->scene.file,
                   "Generates the ice of the scene in this XML file. The vessel is kept free of ice.")
      ->required();
  add_value_flags(*command, options->scene);
  command->add_option("--out", options->out, "Writes the ice to this GeoJSON file.")->capture_default_str();
  auto* picture =
      command->add_option("--picture", options->picture,
                          "Draws the picture into this PNG file with gnuplot. The default is the name of the "
                          "GeoJSON file with .png.");
  picture->check([](const std::string& file) {
    return std::filesystem::path(file).extension() == ".png" ? "" : "'" + file + "': must end in .png";
  });
  command->add_flag("--no-picture", options->no_picture, "Draws no picture.")->excludes(picture);
  command
      ->add_option("--threads", options->threads,
                   "Computes on this many threads, at least 1. The results do not depend on the number.")
      ->check(at_least(1))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Prints the statistics as JSON on standard output.");
  command->add_flag("--quiet", options->quiet, "Prints no progress.");
  command->callback([&action, options] { action = [options] { return make_field(*options); }; });
}

}  // namespace nilas::commands
