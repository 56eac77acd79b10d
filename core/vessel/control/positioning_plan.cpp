#include "core/vessel/control/positioning_plan.h"

#include <algorithm>

#include "core/base/csv.h"
#include "core/base/error.h"
#include "core/vessel/thrusters/actuator.h"

namespace nilas::vessel {

PositioningPlan PositioningPlan::hold(const Vec3& setpoint, double heading_now) {
  PositioningPlan plan;
  plan.t_ = {0};
  plan.position_ = {{setpoint.x(), setpoint.y(), heading_now + wrapped(setpoint.z() - heading_now)}};
  return plan;
}

PositioningPlan PositioningPlan::path(const std::string& csv_file, double heading_now, double scale) {
  const CsvTable table = read_csv(csv_file, {"t_s", "x_m", "y_m", "heading_deg"});
  PositioningPlan plan;
  double heading = heading_now;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    const double t = std::sqrt(scale) * row[0];
    if (i > 0 && !(t > plan.t_.back()))
      throw InputError(csv_file + ":" + std::to_string(table.lines[i]) + ": t_s must grow from row to row");
    heading += wrapped(row[3] * k_deg - heading);
    plan.t_.push_back(t);
    plan.position_.emplace_back(scale * row[1], scale * row[2], heading);
  }
  return plan;
}

PositioningPlan::Target PositioningPlan::at(double t) const {
  if (t < t_.front()) return {position_.front(), Vec3::Zero()};
  if (t >= t_.back()) return {position_.back(), Vec3::Zero()};
  const auto i = static_cast<std::size_t>(std::upper_bound(t_.begin(), t_.end(), t) - t_.begin());
  const Vec3 rate = (position_[i] - position_[i - 1]) / (t_[i] - t_[i - 1]);
  return {position_[i - 1] + (t - t_[i - 1]) * rate, rate};
}

std::vector<Vec2> PositioningPlan::way() const {
  constexpr std::size_t k_most = 100;
  const std::size_t stride = 1 + (position_.size() - 1) / k_most;
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < position_.size(); k += stride) points.emplace_back(position_[k].head<2>());
  if (points.size() > 1) points.back() = position_.back().head<2>();
  return points;
}

}  // namespace nilas::vessel
