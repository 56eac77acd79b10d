#include "core/vessel/thrusters/thruster.h"

#include <algorithm>
#include <cmath>

#include "core/base/csv.h"
#include "core/base/error.h"
#include "core/vessel/thrusters/actuator.h"

namespace nilas::vessel {

ThrustLoss ThrustLoss::read(const std::string& csv_file, double scale) {
  const CsvTable table = read_csv(csv_file, {"speed_m_s", "thrust_share"});
  std::vector<std::pair<double, double>> rows;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const double speed = std::sqrt(scale) * table.rows[i][0], share = table.rows[i][1];
    const std::string place = csv_file + ":" + std::to_string(table.lines[i]) + ": ";
    if (!(share >= 0 && share <= 1))
      throw InputError(place + "found thrust_share " + std::to_string(share) + "; allowed: 0 to 1");
    if (!rows.empty() && !(speed > rows.back().first)) throw InputError(place + "speed_m_s must rise from row to row");
    if (!rows.empty() && share > rows.back().second)
      throw InputError(place + "thrust_share must not rise with the speed of advance");
    rows.emplace_back(speed, share);
  }
  return ThrustLoss(std::move(rows));
}

double ThrustLoss::share(double speed) const {
  if (rows_.empty()) return 1;
  const auto above = std::upper_bound(rows_.begin(), rows_.end(), speed,
                                      [](double v, const std::pair<double, double>& row) { return v < row.first; });
  if (above == rows_.begin()) return rows_.front().second;
  if (above == rows_.end()) return rows_.back().second;
  const auto below = above - 1;
  const double s = (speed - below->first) / (above->first - below->first);
  return below->second + s * (above->second - below->second);
}

double Thruster::limited(double thrust) const { return std::clamp(thrust, -most_astern, most_ahead); }

double Thruster::saturation(double thrust) const {
  const double limit = thrust >= 0 ? most_ahead : most_astern;
  return thrust == 0 ? 0 : std::abs(thrust) / limit;
}

double Thruster::power_at(double thrust) const {
  constexpr double k_exponent = 1.5;  // power n^3, thrust n^2
  return power * std::pow(std::abs(thrust) / most_ahead, k_exponent);
}

/// How far an angle lies beyond `from`, in [0, 2 pi).
static double beyond(double angle, double from) {
  const double rest = std::fmod(angle - from, 2 * k_pi);
  return rest < 0 ? rest + 2 * k_pi : rest;
}

bool Thruster::is_forbidden(double angle) const {
  // An angle at an edge, which rounding may put on either side, is allowed.
  constexpr double k_edge = 1e-9;  // [rad]
  return std::any_of(forbidden.begin(), forbidden.end(), [&](const auto& sector) {
    const double inside = beyond(angle, sector.first), width = beyond(sector.second, sector.first);
    return inside > k_edge && inside < width - k_edge;
  });
}

double Thruster::allowed_angle(double angle) const {
  for (const auto& [from, to] : forbidden)
    if (const double inside = beyond(angle, from), width = beyond(to, from); inside > 0 && inside < width)
      return wrapped(inside < 0.5 * width ? from : to);
  return angle;
}

Vec2 Thruster::direction(double angle, bool ahead) const {
  switch (kind) {
    case ThrusterKind::tunnel:
      return Vec2::UnitY();
    case ThrusterKind::azimuth:
      return direction_of(angle);
    case ThrusterKind::propeller:
      return Vec2::UnitX();
    case ThrusterKind::propeller_rudder:
      // At zero advance the rudder's force is proportional to the thrust.
      return ahead ? Vec2(Vec2::UnitX() + rudder_force(rudder, angle, 1, 0, 0)) : Vec2(Vec2::UnitX());
  }
  return Vec2::Zero();
}

ThrusterState advanced(const Thruster& thruster, const ThrusterState& state, double thrust_command,
                       double angle_command, double t0, double h) {
  const double working = thruster.fails_at ? std::clamp(*thruster.fails_at - t0, 0.0, h) : h;
  ThrusterState next = state;
  if (thruster.kind == ThrusterKind::azimuth)
    next.angle = turn_towards(state.angle, angle_command, thruster.turn_rate, working);
  if (thruster.kind == ThrusterKind::propeller_rudder) {
    const double most = thruster.rudder.most_angle;
    next.angle = follow_command(state.angle, std::clamp(angle_command, -most, most), 0, thruster.turn_rate, working);
  }
  next.thrust = follow_command(state.thrust, thruster.limited(thrust_command), thruster.lag, thruster.rate, working);
  if (working < h) next.thrust = follow_command(next.thrust, 0, thruster.lag, thruster.rate, h - working);
  return next;
}

double remaining_share(const Thruster& thruster, double thrust, double advance) {
  double share = 1;
  if (!thruster.loss_over_speed.empty()) {
    share = thruster.loss_over_speed.share(advance);
  } else if (thruster.free_speed && thrust != 0) {
    constexpr double k_linear = 1.0 / 3, k_quadratic = 2.0 / 3;  // Juva and Riska
    const double v = advance / (*thruster.free_speed * std::sqrt(std::abs(thrust) / thruster.most_ahead));
    share = std::clamp(1 - k_linear * v - k_quadratic * v * std::abs(v), 0.0, 1.0);
  }
  return share * (1 - thruster.loss);
}

Vec2 thruster_force(const Thruster& thruster, const ThrusterState& state, const Vec2& through_water) {
  const bool steers = thruster.kind == ThrusterKind::propeller_rudder;
  const Vec2 axis = steers ? Vec2(Vec2::UnitX()) : thruster.direction(state.angle);
  const double advance = through_water.dot(axis) * (state.thrust < 0 ? -1 : 1);
  const double thrust = state.thrust * remaining_share(thruster, state.thrust, advance);
  if (!steers) return thrust * axis;
  return thrust * axis + rudder_force(thruster.rudder, state.angle, thrust, through_water.x(), through_water.y());
}

}  // namespace nilas::vessel
