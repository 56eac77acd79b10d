/// Tables and text files of users.
#include "core/base/csv.h"
#include "core/choices/manoeuvring_choices.h"
#include "core/vessel/mooring/moordyn_file.h"
#include "hydro/manoeuvring/ship_file.h"
#include "tests/fuzz/targets.h"

namespace nilas::fuzz {

void tables(std::string_view bytes) {
  const std::string file = file_with("table.csv", bytes).string();
  read_or_refuse([&] { read_csv(file, {"stretch_m", "tension_N"}); });
  read_or_refuse([&] { csv_columns(file, {"time_s", "x_m"}); });
  read_or_refuse([&] { csv_records(file); });
}

void ship(std::string_view bytes) {
  if (bytes.empty()) return;
  const auto choice = static_cast<unsigned char>(bytes.front());
  const auto model = (choice & 1U) != 0 ? ManoeuvringModel::mmg : ManoeuvringModel::derivatives;
  const auto propulsion = (choice & 2U) != 0 ? PropulsionKind::open_water : PropulsionKind::thrust_curve;
  const std::string file = file_with("ship.csv", bytes.substr(1)).string();
  constexpr double k_gravity = 9.81;
  read_or_refuse([&] { hydro::read_ship(file, model, propulsion, k_gravity); });
}

void moordyn(std::string_view bytes) {
  const std::string file = file_with("lines.txt", bytes).string();
  read_or_refuse([&] { vessel::moordyn_water(file); });
}

}  // namespace nilas::fuzz
