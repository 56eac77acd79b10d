/// Hydrodynamic databases.
#include "hydro/database/read_database.h"
#include "hydro/database/self_check.h"
#include "tests/fuzz/targets.h"

namespace nilas::fuzz {

static bool is_classic(std::string_view bytes) { return bytes.starts_with("CDF"); }

void bem_hdf5(std::string_view bytes) {
  if (is_classic(bytes)) return;
  const auto file = file_with("database.h5", bytes);
  read_or_refuse([&] { hydro::read_database(file); });
}

void bem_netcdf(std::string_view bytes) {
  if (!is_classic(bytes)) return;
  const auto file = file_with("database.nc", bytes);
  read_or_refuse([&] { hydro::read_database(file); });
}

void bem_wamit(std::string_view bytes) {
  constexpr std::string_view k_mark = "== ";
  std::filesystem::path first;
  for (const char* ending : {".1", ".3", ".2", ".4", ".8", ".9", ".hst", ".gdf"}) {
    const std::string head = std::string(k_mark) + ending + "\n";
    const std::size_t at = bytes.find(head);
    if (at == std::string_view::npos) {
      std::filesystem::remove(file_with(std::string("body") + ending, ""));
      continue;
    }
    const std::string_view rest = bytes.substr(at + head.size());
    const auto file = file_with(std::string("body") + ending, rest.substr(0, rest.find(k_mark)));
    if (first.empty()) first = file;
  }
  if (first.empty()) return;
  hydro::DatabaseSettings settings;
  settings.length = 1;
  settings.density = 1025;
  settings.gravity = 9.81;
  read_or_refuse([&] { hydro::read_database(first, settings); });
}

}  // namespace nilas::fuzz
