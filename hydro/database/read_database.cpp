#include "hydro/database/read_database.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/choices/database_files.h"
#include "core/hdf5/hdf5_file.h"
#include "hydro/database/bemio.h"
#include "hydro/database/capytaine.h"
#include "hydro/database/labelled_file.h"
#include "hydro/database/reference_point.h"
#include "hydro/database/wamit.h"

namespace nilas::hydro {

namespace fs = std::filesystem;

namespace {

std::string with_unit(double value, const char* unit) {
  std::ostringstream text;
  text << value << ' ' << unit;
  return text.str();
}

double needed(const std::optional<double>& value, const char* name, const fs::path& file) {
  if (!value)
    throw InputError(file.string() + ": the " + name +
                     " of the computation is missing; WAMIT's results have no dimensions, so length (ULEN), density "
                     "and gravity must be given");
  if (!(*value > 0) || !std::isfinite(*value))
    throw InputError(file.string() + ": found the " + std::string(name) + " " + with_unit(*value, "") +
                     "; allowed: a finite number > 0");
  return *value;
}

/// Refuses a setting that the file contradicts; a thousandth is beyond the digits in which constants are written.
void demand_agreement(const std::string& file, const char* name, const std::optional<double>& given, double stated,
                      const char* unit) {
  constexpr double k_agreement = 1e-3;
  if (given && std::abs(*given - stated) > k_agreement * std::abs(stated))
    throw InputError(file + ": states the " + name + " " + with_unit(stated, unit) + ", but " +
                     with_unit(*given, unit) + " was given");
}

Database wamit_database(const fs::path& path, const DatabaseSettings& settings) {
  const WamitScale scale{needed(settings.length, "length", path), needed(settings.density, "density", path),
                         needed(settings.gravity, "gravity", path)};
  for (const fs::path& file : database_files(path)) {
    if (file.extension() != ".gdf" && file.extension() != ".GDF") continue;
    const WamitScale stated = wamit_geometry_scale(file);
    demand_agreement(file.string(), "length", scale.length, stated.length, "m");
    demand_agreement(file.string(), "gravity", scale.gravity, stated.gravity, "m/s^2");
  }
  return about_origin(read_wamit(path, scale), settings.reference.value_or(Vec3::Zero()));
}

/// A file that states its own constants: those that were given must agree.
Database self_contained_database(const fs::path& path, const DatabaseSettings& settings) {
  const auto read = [&] {
    if (is_classic_netcdf(path)) return read_capytaine(path);
    const hdf5::Hdf5Reader file(path);  // throws where it is no HDF5
    if (file.has("simulation_parameters")) return read_bemio(path);
    if (file.has("added_mass")) return read_capytaine(path);
    throw InputError(path.string() +
                     ": is no hydrodynamic database; allowed: WAMIT's files, HDF5 of BEMIO with the group "
                     "simulation_parameters, NetCDF of Capytaine with the variable added_mass");
  };
  if (settings.length)
    throw InputError(path.string() + ": a length was given, but only WAMIT's results are divided by one");
  auto [database, reference] = read();
  demand_agreement(database.source, "density", settings.density, database.density, "kg/m^3");
  demand_agreement(database.source, "gravity", settings.gravity, database.gravity, "m/s^2");
  if (database.volume) demand_agreement(database.source, "volume", settings.volume, *database.volume, "m^3");
  if (!reference && !settings.reference)
    database.notes.push_back(
        "The file does not state the point to which rotations refer; it is taken for the origin at the still water.");
  const std::optional<Vec3> point = settings.reference ? settings.reference : reference;
  return about_origin(database, point.value_or(Vec3::Zero()));
}

/// A depth that is given goes before that of the file: files are known that state one but were computed in deep water.
void set_depth(Database& database, const std::optional<double>& depth) {
  if (!depth) return;
  if (!(*depth > 0))
    throw InputError(database.source + ": found the depth " + with_unit(*depth, "m") + "; allowed: a number > 0");
  if (database.depth && *database.depth != *depth)
    database.notes.push_back("The file states the depth " + with_unit(*database.depth, "m") + "; " +
                             (std::isfinite(*depth) ? with_unit(*depth, "m") : "deep water") + " is taken, as given.");
  database.depth = std::isfinite(*depth) ? depth : std::nullopt;
}

/// Frequencies and headings must rise, and every table must have their numbers.
void demand_order(const Database& database) {
  const auto rising = [](const std::vector<double>& values) {
    return std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
  };
  if (database.frequency.empty() || !rising(database.frequency) || database.frequency.front() <= 0)
    throw InputError(database.source + ": the frequencies do not rise from above 0");
  if (!rising(database.heading)) throw InputError(database.source + ": the wave headings do not rise");
}

}  // namespace

Database read_database(const fs::path& path, const DatabaseSettings& settings) {
  std::error_code ignored;
  const bool is_stem = !fs::exists(path, ignored) && fs::exists(path.string() + ".1", ignored);
  if (!is_stem) demand_there(path, "hydrodynamic database");
  const fs::path file = is_stem ? fs::path(path.string() + ".1") : path;
  Database database = is_wamit_file(file) ? wamit_database(file, settings) : self_contained_database(file, settings);
  demand_order(database);
  set_depth(database, settings.depth);
  if (settings.volume) database.volume = settings.volume;
  return database;
}

const Mat6& demand_infinite_added_mass(const Database& database) {
  if (!database.added_mass_infinite)
    throw InputError(
        database.source +
        ": has no added mass at infinite frequency, which a model in the time domain needs; WAMIT writes "
        "it as rows with PER = 0, Capytaine for omega = inf, BEMIO as added_mass/inf_freq; or `nilas hydro "
        "FILE --complete --out NEW.h5` adds it by Ogilvie's relation");
  return *database.added_mass_infinite;
}

}  // namespace nilas::hydro
