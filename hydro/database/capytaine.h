#pragma once
/// The NetCDF files of Capytaine.
#include <filesystem>

#include "hydro/database/reference_point.h"

namespace nilas::hydro {

/// Reads a dataset with the dimensions radiating_dof, influenced_dof and wave_direction [rad], one of omega, freq,
/// period, wavenumber and wavelength, and `complex` for real and imaginary parts. Modes are found by their names,
/// Surge to Yaw. Capytaine's quantities are Re(x exp(-i w t)), so loads are conjugated. Frequencies whose values are
/// not numbers are left out, with a note. w = 0 and w = infinity give the limits of the added mass. The file's
/// rotation_center is the reference, where it has one. Throws FileError, and InputError with the variable.
UnmovedDatabase read_capytaine(const std::filesystem::path& path);

}  // namespace nilas::hydro
