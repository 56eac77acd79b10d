#pragma once
/// The hydrodynamic databases of tests/data/hydro, and the settings that they need.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "hydro/database/read_database.h"
#include "hydro/database/response.h"

namespace nilas::test {

inline const std::filesystem::path k_hydro_data = std::filesystem::path(NILAS_SOURCE_DIR) / "tests/data/hydro";

/// The FPSO of MSS: run_fpso.m and fpso.out state its constants.
inline hydro::DatabaseSettings fpso_settings() {
  hydro::DatabaseSettings settings;
  settings.length = 1;
  settings.density = 1025;
  settings.gravity = 9.81;
  settings.volume = 97960.9;
  return settings;
}
inline std::filesystem::path fpso_file() { return k_hydro_data / "mss/fpso.1"; }
inline hydro::Database fpso() { return hydro::read_database(fpso_file(), fpso_settings()); }
/// rho V, and the radii of its file .frc about the origin; the centre of gravity is above that of buoyancy.
inline Mat6 fpso_mass() { return hydro::rigid_mass(1025 * 97960.9, {0.788631, 0, -1}, {16.3, 54, 54}); }

/// The hemisphere of WEC-Sim, radius 5 m in water of 50 m; its modes refer to a point 2 m below the still water.
inline hydro::DatabaseSettings sphere_settings() {
  hydro::DatabaseSettings settings;
  settings.length = 1;
  settings.density = 1000;
  settings.gravity = 9.81;
  settings.depth = 50;
  settings.reference = Vec3(0, 0, -2);
  return settings;
}
inline hydro::Database sphere() { return hydro::read_database(k_hydro_data / "wec-sim/sphere.1", sphere_settings()); }

inline std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace nilas::test
