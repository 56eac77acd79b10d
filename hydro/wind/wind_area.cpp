#include "hydro/wind/wind_area.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/csv.h"
#include "core/base/error.h"

namespace nilas::hydro {

const BlendermannRow& blendermann_row(BlendermannShip ship) {
  // Blendermann (1994), by way of Fossen (2021), table 10.1, and blendermann94.m of the toolbox MSS. For the drilling
  // vessel, of which the source has a range, the middle.
  static constexpr std::array<BlendermannRow, num_choices<BlendermannShip>()> rows{{
      {0.95, 0.55, 0.60, 0.80, 1.2},   // car carrier
      {0.85, 0.65, 0.55, 0.40, 1.7},   // cargo vessel, loaded
      {0.85, 0.55, 0.50, 0.40, 1.4},   // cargo vessel, containers on deck
      {0.90, 0.55, 0.55, 0.40, 1.4},   // container ship, loaded
      {0.85, 0.60, 0.65, 0.65, 1.1},   // destroyer
      {0.90, 0.60, 0.80, 0.55, 1.7},   // diving support vessel
      {1.00, 0.85, 0.925, 0.10, 1.7},  // drilling vessel
      {0.90, 0.45, 0.50, 0.80, 1.1},   // ferry
      {0.95, 0.70, 0.70, 0.40, 1.1},   // fishing vessel
      {0.70, 0.60, 0.65, 0.50, 1.1},   // tanker of liquefied natural gas
      {0.90, 0.55, 0.80, 0.55, 1.2},   // offshore supply vessel
      {0.90, 0.40, 0.40, 0.80, 1.2},   // passenger liner
      {0.85, 0.55, 0.65, 0.60, 1.4},   // research vessel
      {0.90, 0.55, 0.60, 0.60, 1.1},   // speed boat
      {0.70, 0.90, 0.55, 0.40, 3.1},   // tanker, loaded
      {0.70, 0.75, 0.55, 0.40, 2.2},   // tanker, in ballast
      {0.85, 0.55, 0.55, 0.65, 1.1},   // tender
  }};
  return rows.at(static_cast<std::size_t>(ship));
}

WindCoefficientTable::WindCoefficientTable(const std::string& csv_file) {
  constexpr double k_astern = 180;  // [deg]
  const CsvTable table = read_csv(csv_file, {"angle_deg", "cx", "cy", "cn"});
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const auto& row = table.rows[k];
    if (k == 0 ? row[0] != 0 : !(row[0] > table.rows[k - 1][0]))
      throw InputError(csv_file + ":" + std::to_string(table.lines[k]) +
                       ": angle_deg must begin at 0 and grow from row to row");
    angle_.push_back(row[0] * k_deg);
    values_.emplace_back(row[1], row[2], row[3]);
  }
  if (table.rows.back()[0] != k_astern)
    throw InputError(csv_file + ":" + std::to_string(table.lines.back()) + ": angle_deg must end at 180");
}

WindCoefficients WindCoefficientTable::at(double angle) const {
  const auto above = std::upper_bound(angle_.begin() + 1, angle_.end() - 1, angle) - angle_.begin();
  const auto k = static_cast<std::size_t>(above);
  const double share = std::clamp((angle - angle_[k - 1]) / (angle_[k] - angle_[k - 1]), 0.0, 1.0);
  const Vec3 c = values_[k - 1] + share * (values_[k] - values_[k - 1]);
  return {c[0], c[1], c[2], 1};
}

namespace {

/// Blendermann's formulas for an angle from 0 to pi.
WindCoefficients blendermann(const WindArea& area, double angle) {
  constexpr double k_arm = 0.18;  // how the centre of the load moves with the angle [L/rad]
  const BlendermannRow& row = blendermann_row(area.ship);
  const double along = angle <= k_pi / 2 ? row.ahead : row.astern;
  const double cross = std::sin(2 * angle);
  const double d = 1 - 0.5 * row.delta * (1 - along * area.frontal / area.lateral / row.across) * cross * cross;
  const double CX = -along * std::cos(angle) / d, CY = row.across * std::sin(angle) / d;
  return {CX, CY, (area.centroid / area.length - k_arm * (angle - k_pi / 2)) * CY, row.kappa};
}

}  // namespace

WindCoefficients wind_coefficients(const WindArea& area, double angle) {
  WindCoefficients c;
  switch (area.model) {
    case WindAreaModel::blendermann:
      c = blendermann(area, std::abs(angle));
      break;
    case WindAreaModel::coefficients:
      c = area.table->at(std::abs(angle));
      break;
  }
  if (angle < 0) {
    c.CY = -c.CY;
    c.CN = -c.CN;
  }
  return c;
}

}  // namespace nilas::hydro
