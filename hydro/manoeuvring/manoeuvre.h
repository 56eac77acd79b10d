#pragma once
/// Scripted manoeuvres: what they ask of rudder and propeller, and what is measured.
#include <memory>
#include <string>
#include <vector>

#include "core/base/state.h"
#include "core/bodies/module.h"
#include "core/choices/manoeuvring_choices.h"
#include "hydro/manoeuvring/vessel_in_plane.h"

namespace nilas::hydro {

/// What rudder and propeller are asked for.
struct SteeringOrders {
  double rudder = 0;  ///< positive with the trailing edge to starboard [rad]
  double rps = 0;     ///< [1/s]
};

/// A manoeuvre after its start. Ways are those through the water: the current carries the track with it.
class Manoeuvre {
 public:
  virtual ~Manoeuvre() = default;
  /// Takes the vessel at time t [s], the end of a substep of length h [s], and returns the orders from then on.
  /// `present`: those that hold. The first call is the start of the manoeuvre.
  virtual SteeringOrders go_on(const VesselInPlane& now, double t, double h, const SteeringOrders& present) = 0;
  virtual std::vector<bodies::RunFigure> figures() const = 0;
  virtual void save(StateWriter out) const = 0;
  virtual void restore(const StateReader& in) = 0;
};

/// Facts that all manoeuvres need.
struct ManoeuvreFrame {
  double length = 1;            ///< L of the ship [m]
  Vec2 current = Vec2::Zero();  ///< [m/s]
};

/// The vessel relative to the start of a manoeuvre: along the heading then and to starboard of it, through the water.
class ManoeuvreTrack {
 public:
  explicit ManoeuvreTrack(const ManoeuvreFrame& frame) : frame_(frame) {}
  bool has_begun() const { return begun_ != 0; }
  void go_on(const VesselInPlane& now, double t, double h);

  double start() const { return t0_; }               ///< [s]
  double time() const { return time_; }              ///< since the start [s]
  double approach_speed() const { return speed0_; }  ///< [m/s]
  double turned() const { return turned_; }          ///< change of heading, positive to starboard, without bound [rad]
  double ahead() const { return ahead_; }            ///< [m]
  double aside() const { return aside_; }            ///< to starboard [m]
  double way() const { return way_; }                ///< length of the track [m]
  double length() const { return frame_.length; }

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  ManoeuvreFrame frame_;
  double begun_ = 0, t0_ = 0, speed0_ = 0, yaw_ = 0;
  double time_ = 0, turned_ = 0, ahead_ = 0, aside_ = 0, way_ = 0;
  Vec2 origin_ = Vec2::Zero(), axis_ = Vec2::UnitX();
};

/// The rudder stays amidships.
std::unique_ptr<Manoeuvre> make_straight(const ManoeuvreFrame& frame);

/// The rudder is laid to `angle` [rad], positive to starboard. Advance and transfer are those where the heading has
/// changed by 90 degrees, the tactical diameter is the transfer at 180 degrees; places between two substeps are
/// interpolated. After 360 degrees come the diameter 2 U/r, drift angle and speed of the steady turn.
std::unique_ptr<Manoeuvre> make_turning_circle(const ManoeuvreFrame& frame, double angle);

/// The rudder is laid to `angle` [rad], and to the other side each time the heading has changed by `heading` [rad] to
/// the rudder's side. An overshoot is how far the heading goes on after that.
std::unique_ptr<Manoeuvre> make_zigzag(const ManoeuvreFrame& frame, double angle, double heading);

/// Orders of heading [rad, from X towards Y] and speed through the water [m/s] that hold from a time on.
struct CourseOrder {
  double t = 0, heading = 0, speed = 0;
};
/// Reads a CSV file with the columns t_s,heading_deg,speed_m_s. Times and speeds are multiplied by the root of `scale`,
/// as Froude's law has it. Throws FileError and InputError as read_csv(), and
/// where times do not rise or a speed is negative.
std::vector<CourseOrder> read_course_orders(const std::string& file, double scale = 1);

/// Gains of the autopilot. With e the heading error, wanted less actual, and r the yaw rate, both to port,
///   rudder = -(heading_gain e - yaw_rate_gain r + integral of e / heading_time heading_gain)
///   rps = rps_per_speed (V + speed_gain (V - u + integral of (V - u) / speed_time))
/// The integrals rest where rudder or propeller is at its limit and they would push it further.
struct AutopilotGains {
  double heading_gain = 2;   ///< rudder angle over heading error [-]
  double yaw_rate_gain = 0;  ///< rudder angle over yaw rate [s]
  double heading_time = 0;   ///< [s]
  double speed_gain = 0;     ///< [-]
  double speed_time = 0;     ///< [s]
  double rps_per_speed = 0;  ///< rate of revolutions over speed in open water [1/m]
  double max_rudder = 0;     ///< [rad]
  double max_rps = 0;        ///< [1/s]
};
/// An autopilot for heading and speed. `orders`: at least one, times rising.
std::unique_ptr<Manoeuvre> make_course(const ManoeuvreFrame& frame, std::vector<CourseOrder> orders,
                                       const AutopilotGains& gains);

}  // namespace nilas::hydro
