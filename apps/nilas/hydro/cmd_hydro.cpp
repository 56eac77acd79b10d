#include <filesystem>
#include <iostream>
#include <vector>

#include "apps/nilas/commands/commands.h"
#include "apps/nilas/hydro/database_picture.h"
#include "apps/nilas/hydro/database_report.h"
#include "core/base/error.h"
#include "core/choices/database_files.h"
#include "core/output/text/console.h"
#include "hydro/database/bemio.h"
#include "hydro/database/read_database.h"
#include "hydro/database/response.h"
#include "hydro/database/wamit.h"
#include "hydro/radiation/retardation.h"

namespace nilas::commands {

namespace {

namespace fs = std::filesystem;

struct HydroOptions {
  std::string file, out, picture;
  hydro::DatabaseSettings settings;
  std::optional<double> mass;
  std::vector<double> reference, cog, radii;
  double out_length = 1;
  bool complete = false, json = false;
};

/// Three numbers of an option; nothing where it was not given.
std::optional<Vec3> point_of(const std::vector<double>& numbers) {
  if (numbers.empty()) return std::nullopt;
  return Vec3(numbers[0], numbers[1], numbers[2]);
}

/// The rigid-body mass that the flags state. Its default is that of the displaced water.
std::optional<Mat6> mass_of(const HydroOptions& options, const hydro::Database& database) {
  const auto radii = point_of(options.radii);
  if (!radii) {
    if (options.mass) throw InputError("nilas hydro: found --mass without --radii; allowed: both, with --cog");
    return std::nullopt;
  }
  const auto cog = options.cog.empty() ? database.centre_of_gravity : point_of(options.cog);
  if (!cog) throw InputError("nilas hydro: found --radii without --cog; allowed: both");
  if (!options.mass && !database.volume)
    throw InputError(
        "nilas hydro: found --radii without --mass; the displaced volume is not known, so allowed: with "
        "--mass or --volume");
  return hydro::rigid_mass(options.mass ? *options.mass : database.density * *database.volume, *cog, *radii);
}

/// Converts the database to the form that the name of the file asks for.
void write_database(const hydro::Database& database, const HydroOptions& options) {
  const fs::path out = options.out;
  const bool is_bemio = out.extension() == ".h5" || out.extension() == ".hdf5";
  const fs::path stem = is_wamit_file(out) ? fs::path(out).replace_extension() : out;
  for (const fs::path& input : database_files(options.file)) {
    std::error_code ignored;
    const fs::path beside = is_bemio ? out : fs::path(stem.string() + input.extension().string());
    if (fs::equivalent(input, beside, ignored))
      throw InputError("nilas hydro: --out " + options.out + " would replace " + input.string() +
                       "; allowed: another name");
  }
  if (is_bemio) return hydro::write_bemio(database, out);
  hydro::write_wamit(database, stem, {options.out_length, database.density, database.gravity});
}

int hydro_command(const HydroOptions& options) {
  hydro::DatabaseSettings settings = options.settings;
  settings.reference = point_of(options.reference);
  hydro::Database database = hydro::read_database(options.file, settings);
  if (options.complete) database = hydro::with_infinite_added_mass(std::move(database));
  if (const auto cog = point_of(options.cog)) database.centre_of_gravity = cog;
  const std::optional<Mat6> mass = mass_of(options, database);
  const hydro::SelfCheck check = hydro::check_database(database, mass);
  nlohmann::ordered_json report = database_report(database, check, mass);
  if (!options.out.empty()) write_database(database, options);
  if (!options.picture.empty()) draw_database(database, options.picture);
  if (!options.out.empty()) report["written"] = options.out;
  if (!options.picture.empty()) report["picture"] = options.picture;
  if (options.json)
    std::cout << report.dump(2) << "\n";
  else
    std::cout << database_text(report);
  for (const char* kind : {"warnings", "faults"})
    for (const auto& text : report[kind])
      std::cerr << output::wrapped((kind[0] == 'f' ? "fault: " : "warning: ") + text.get<std::string>(), 2) << "\n";
  for (const std::string& file : {options.out, options.picture})
    if (!options.json && !file.empty()) std::cout << "written: " << file << "\n";
  return report["faults"].empty() ? exit_done : exit_numerics;
}

void add_computation_flags(CLI::App& command, HydroOptions& options) {
  hydro::DatabaseSettings& settings = options.settings;
  command
      .add_option("--length", settings.length, "States the length ULEN by which the results of WAMIT are divided [m].")
      ->check(above(0));
  command
      .add_option("--density", settings.density,
                  "States the density of the water in the computation [kg/m^3]. WAMIT's files need it.")
      ->check(above(0));
  command
      .add_option("--gravity", settings.gravity,
                  "States the gravity in the computation [m/s^2]. WAMIT's files need it.")
      ->check(above(0));
  command
      .add_option("--depth", settings.depth,
                  "States the depth of the water in the computation [m], or inf. It goes before that of the file.")
      ->check(above(0));
  command.add_option("--volume", settings.volume, "States the displaced volume [m^3], where the file does not.")
      ->check(above(0));
  constexpr int k_coordinates = 3;
  command
      .add_option("--reference", options.reference,
                  "States the point to which rotations and moments of the file refer [m], with z from the still water.")
      ->expected(k_coordinates);
  command
      .add_option("--mass", options.mass,
                  "States the mass of the body [kg]. The default is that of the displaced water.")
      ->check(above(0));
  command.add_option("--cog", options.cog, "States the centre of gravity [m], with z from the still water.")
      ->expected(k_coordinates);
  command
      .add_option("--radii", options.radii,
                  "States the radii of gyration about the axes through the origin at the still water [m], as WAMIT's "
                  ".frc does. They give natural periods and a comparison of motions.")
      ->expected(k_coordinates);
}

}  // namespace

void add_hydro(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("hydro", "Reads a hydrodynamic database, checks it against itself, prints and converts it.");
  auto options = std::make_shared<HydroOptions>();
  command
      ->add_option("file", options->file,
                   "Reads this database: one of WAMIT's result files or their common stem, an HDF5 file of BEMIO, or a "
                   "NetCDF file of Capytaine.")
      ->required();
  add_computation_flags(*command, *options);
  command->add_flag("--complete", options->complete,
                    "Adds the added mass at infinite frequency by Ogilvie's relation to a database that lacks it.");
  command->add_option("--out", options->out,
                      "Writes the database to this file: in the form of BEMIO if it ends in .h5, else as files of "
                      "WAMIT with this stem.");
  command->add_option("--out-length", options->out_length, "Divides the results for WAMIT by this length ULEN [m].")
      ->check(above(0))
      ->capture_default_str();
  command->add_option("--picture", options->picture, "Draws the database into this PNG file with gnuplot.")
      ->check([](const std::string& file) {
        return fs::path(file).extension() == ".png" ? "" : "'" + file + "': must end in .png";
      });
  command->add_flag("--json", options->json, "Prints the report as JSON on standard output.");
  command->callback([&action, options] { action = [options] { return hydro_command(*options); }; });
}

}  // namespace nilas::commands
