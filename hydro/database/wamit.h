#pragma once
/// WAMIT's result files [WAMIT User Manual 7.4, chapter 4].
#include <filesystem>

#include "hydro/database/database.h"

namespace nilas::hydro {

/// By what WAMIT divides its results.
struct WamitScale {
  double length = 0, density = 0, gravity = 0;  ///< ULEN [m], [kg/m^3], [m/s^2]
};

/// Reads all files of a stem. With L = ULEN, and k counting the modes of rotation among i and j:
///   .1       A = rho L^(3+k) a, B = rho L^(3+k) w b
///   .3, .2   X = rho g L^(2+k) x
///   .4       translations x, rotations x / L
///   .9, .8   F = rho g L^(1+k) f; of equal pairs of headings only
///   .hst     C = rho g L^(2+k) c
/// The result refers to the origin of the file's modes. Throws FileError and InputError as read_database() does.
Database read_wamit(const std::filesystem::path& file_or_stem, const WamitScale& scale);

/// Writes .1, .3, .hst, and .4 and .9 where the database has them, with seven digits like WAMIT's own. Values refer to
/// the origin of D. Throws FileError.
void write_wamit(const Database& database, const std::filesystem::path& stem, const WamitScale& scale);

/// The length and gravity that a .gdf file states on its second line; throws InputError with its line.
WamitScale wamit_geometry_scale(const std::filesystem::path& file);

}  // namespace nilas::hydro
