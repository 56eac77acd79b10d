#include "hydro/flow/current_tables.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/csv.h"
#include "core/base/error.h"

namespace nilas::hydro {

VelocityTable::VelocityTable(std::vector<double> x, std::vector<Vec2> values)
    : x_(std::move(x)), values_(std::move(values)) {
  NILAS_DEMAND(!x_.empty() && x_.size() == values_.size());
  NILAS_DEMAND(std::adjacent_find(x_.begin(), x_.end(), std::greater_equal<>()) == x_.end());
}

Vec2 VelocityTable::at(double x) const {
  const auto above = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin());
  if (above == 0) return values_.front();
  if (above == x_.size()) return values_.back();
  const double share = (x - x_[above - 1]) / (x_[above] - x_[above - 1]);
  return values_[above - 1] + share * (values_[above] - values_[above - 1]);
}

Vec2 VelocityTable::greatest() const {
  return *std::max_element(values_.begin(), values_.end(),
                           [](const Vec2& a, const Vec2& b) { return a.norm() < b.norm(); });
}

namespace {

/// Reads a table; `may_fall`: its rows may also stand in falling order. `unit` and `speed` multiply coordinates and
/// velocities.
VelocityTable read_velocities(const std::string& csv_file, const std::string& coordinate, bool may_fall, double unit,
                              double speed) {
  CsvTable table = read_csv(csv_file, {coordinate, "u_m_s", "v_m_s"});
  auto& rows = table.rows;
  const bool falls = may_fall && rows.size() > 1 && rows[1][0] < rows[0][0];
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (!(falls ? rows[k][0] < rows[k - 1][0] : rows[k][0] > rows[k - 1][0]))
      throw InputError(csv_file + ":" + std::to_string(table.lines[k]) + ": " + coordinate + " must " +
                       (falls ? "fall" : "grow") + " from row to row" +
                       (may_fall && !falls ? ", or fall in all of them" : ""));
  if (falls) std::reverse(rows.begin(), rows.end());
  std::vector<double> x;
  std::vector<Vec2> values;
  for (const auto& row : rows) {
    x.push_back(unit * row[0]);
    values.emplace_back(speed * row[1], speed * row[2]);
  }
  return {std::move(x), std::move(values)};
}

}  // namespace

VelocityTable read_current_profile(const std::string& csv_file, double scale) {
  return read_velocities(csv_file, "z_m", true, scale, std::sqrt(scale));
}

VelocityTable read_current_series(const std::string& csv_file, double scale) {
  return read_velocities(csv_file, "t_s", false, std::sqrt(scale), std::sqrt(scale));
}

}  // namespace nilas::hydro
