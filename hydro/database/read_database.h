#pragma once
/// Reads a hydrodynamic database in one of three forms.
#include <filesystem>
#include <optional>

#include "hydro/database/database.h"

namespace nilas::hydro {

/// What the file does not say of itself. A value that the file states as well must agree with it, except the depth.
struct DatabaseSettings {
  std::optional<double> length;   ///< WAMIT's ULEN, by which its results are divided [m]
  std::optional<double> density;  ///< of the computation [kg/m^3]
  std::optional<double> gravity;  ///< of the computation [m/s^2]
  std::optional<double>
      depth;  ///< of the computation [m], may be infinite; it goes before the file's. Without either: infinite
  std::optional<double> volume;  ///< displaced volume [m^3]
  /// Point of frame D to which the file's rotations and moments refer (WAMIT: XBODY) [m]. Default: the point that the
  /// file states; where it states none, the origin of D.
  std::optional<Vec3> reference;
};

/// Reads one of these:
///   WAMIT: any of the files .1 .2 .3 .4 .8 .9 .hst .gdf, or their stem. All of them that are there are read. They
///     have no dimensions, so length, density and gravity are needed. PER < 0 is the infinite period, PER = 0 the
///     period zero [WAMIT User Manual 7.4, 4.5]. .3 goes before .2, .9 before .8.
///   BEMIO: the HDF5 of WEC-Sim and HydroChrono, with the groups simulation_parameters and body1.
///   Capytaine: its NetCDF, in the classic form or that of HDF5.
/// The returned values are dimensional, have the conventions of Database and refer to the origin of D.
/// Throws FileError where a file cannot be read. Throws InputError that names file and line or dataset for wrong
/// content, and one that names the setting that is missing or contradicts the file.
Database read_database(const std::filesystem::path& path, const DatabaseSettings& settings = {});

/// A(infinity), which convolutions and time-domain models need. Throws InputError where the file has none: it names the
/// file and the row or dataset that is missing.
const Mat6& demand_infinite_added_mass(const Database& database);

}  // namespace nilas::hydro
