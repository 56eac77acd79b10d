#pragma once
/// One thruster: what it can do, its state, and its force.
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/math.h"
#include "core/choices/thruster_choices.h"
#include "core/vessel/thrusters/rudder.h"

namespace nilas::vessel {

/// Share of the thrust that remains, over the speed of advance: rows of speed [m/s] and share, speeds rising, shares
/// not rising. Linear between rows, constant outside of them.
class ThrustLoss {
 public:
  ThrustLoss() = default;
  /// Reads columns speed_m_s,thrust_share, speeds times the root of `scale`. Throws FileError, or InputError
  /// "file:line: ..." where speeds do not rise, shares rise, or a share is outside of 0 to 1.
  static ThrustLoss read(const std::string& csv_file, double scale = 1);
  explicit ThrustLoss(std::vector<std::pair<double, double>> rows) : rows_(std::move(rows)) {}
  bool empty() const { return rows_.empty(); }
  double share(double speed) const;

 private:
  std::vector<std::pair<double, double>> rows_;
};

struct Thruster {
  std::string name;
  ThrusterKind kind = ThrusterKind::tunnel;
  Vec3 at_V = Vec3::Zero();  ///< point where its force acts, frame V [m]
  double most_ahead = 0;     ///< largest thrust in its positive direction [N]
  double most_astern = 0;    ///< largest thrust in the opposite direction, as a positive number [N]
  double lag = 0;            ///< time constant of the thrust [s]
  double rate = std::numeric_limits<double>::infinity();       ///< largest rate of the thrust [N/s]
  double turn_rate = std::numeric_limits<double>::infinity();  ///< of an azimuth or a rudder [rad/s]
  /// Azimuth: sectors into which its force must not point, from, to [rad]; they do not overlap.
  std::vector<std::pair<double, double>> forbidden;
  double power = 0;                  ///< at most_ahead [W]
  double loss = 0;                   ///< share of the thrust lost to ventilation or ice, 0 to 1
  std::optional<double> free_speed;  ///< speed of advance without thrust at full power [m/s]
  ThrustLoss loss_over_speed;        ///< replaces free_speed
  std::optional<double> fails_at;    ///< from this time on it gives nothing [s]
  Rudder rudder;                     ///< propeller_rudder only

  bool turns() const { return kind == ThrusterKind::azimuth || kind == ThrusterKind::propeller_rudder; }
  bool works(double t) const { return !fails_at || t < *fails_at; }
  /// The command within the limits of the thrust.
  double limited(double thrust) const;
  /// |thrust| as a share of the limit in its direction.
  double saturation(double thrust) const;
  /// P = power (|thrust| / most_ahead)^1.5 [W], as the law of propellers n^3 against n^2.
  double power_at(double thrust) const;
  /// Whether this direction of an azimuth's force lies in a forbidden sector, edges excluded.
  bool is_forbidden(double angle) const;
  /// The nearest angle outside of all forbidden sectors.
  double allowed_angle(double angle) const;
  /// Force of unit thrust without speed of advance, in the vessel's x and y axes. It is of unit length except with a
  /// rudder. A rudder does nothing where the thrust is `ahead` = false.
  Vec2 direction(double angle, bool ahead = true) const;
};

/// What changes in a run.
struct ThrusterState {
  double thrust = 0;  ///< without losses [N]
  double angle = 0;   ///< azimuth: direction of the thrust; rudder: its angle [rad]
};

/// The state after h [s] from t0 under constant commands. A thruster that fails within this time loses its thrust by
/// its lag from then on, and its azimuth or rudder stops.
ThrusterState advanced(const Thruster& thruster, const ThrusterState& state, double thrust_command,
                       double angle_command, double t0, double h);

/// Share of the thrust that remains at a speed of advance along the thrust [m/s]. Without a table and with free_speed
/// v_0 it is 1 - s/3 - 2/3 s |s| between 0 and 1, with s = advance / (v_0 sqrt(|thrust| / most_ahead)): the free speed
/// goes with the rate of revolutions [Juva, Riska 2002, the form for full power]. The constant `loss` comes on top.
double remaining_share(const Thruster& thruster, double thrust, double advance);

/// Force in the vessel's x and y axes [N]. `through_water`: velocity of its point through the water, same axes [m/s].
Vec2 thruster_force(const Thruster& thruster, const ThrusterState& state, const Vec2& through_water);

}  // namespace nilas::vessel
