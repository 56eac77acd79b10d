#pragma once
/// The HDF5 form of BEMIO, the reader of WEC-Sim, which HydroChrono uses too.
#include <filesystem>

#include "hydro/database/reference_point.h"

namespace nilas::hydro {

/// Reads the groups simulation_parameters and body1 of one body with six modes. With simulation_parameters/scaled = 0
/// the file holds A / rho, B / (rho w), X / (rho g) and C / (rho g); with 1 it holds them with dimensions. Modes refer
/// to properties/cg, which is also the centre of gravity. Throws FileError, and InputError with the dataset.
UnmovedDatabase read_bemio(const std::filesystem::path& path);

/// Writes that form with scaled = 0; modes then refer to the centre of gravity of the database, or to the origin of D
/// where it has none. Throws InputError where the database lacks what the form cannot leave out: A(infinity), wave
/// excitation, stiffness, volume. Throws FileError.
void write_bemio(const Database& database, const std::filesystem::path& path);

}  // namespace nilas::hydro
