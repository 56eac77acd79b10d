#pragma once
/// The picture of a hydrodynamic database.
#include <filesystem>

#include "hydro/database/database.h"

namespace nilas::commands {

/// Draws added mass and damping of each mode over the frequency, and the modulus of its wave excitation for up to three
/// headings, into a PNG file. Throws output::PlotError if gnuplot is missing.
void draw_database(const hydro::Database& database, const std::filesystem::path& picture);

}  // namespace nilas::commands
