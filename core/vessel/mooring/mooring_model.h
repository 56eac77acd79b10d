#pragma once
/// Mooring lines between a hull and the sea bed as plain values, and their loads at a pose of the hull.
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/math.h"
#include "core/vessel/mooring/catenary.h"

namespace nilas::vessel {

/// A weightless line that pulls along the straight line between its ends. Its tension follows from its stretch, the
/// distance of its ends minus its length.
struct SpringLine {
  /// One row: a tension at a stretch.
  struct Point {
    double stretch = 0;  ///< [m]
    double tension = 0;  ///< [N]
  };
  double length = 0;         ///< unstretched length [m]
  std::vector<Point> curve;  ///< two rows at least; the stretch rises, the tension is >= 0 and does not fall

  /// Linear between the rows. It is zero before the first row; the last slope goes on behind the last.
  double tension(double stretch) const;
  /// Its derivative [N/m]. At a row it is that of the stretch below.
  double slope(double stretch) const;
};
/// A curve of two slopes: `stiffness` up to the stretch `knee`, `second` beyond it [N/m, m].
SpringLine bilinear_spring(double length, double stiffness, double knee, double second);
/// Reads a curve from the columns stretch_m,tension_N. By Froude's law, `scale` multiplies its stretches, and its cube
/// the tensions; the length is taken as it is. Throws FileError, or InputError where it is no such curve.
SpringLine tabulated_spring(double length, const std::string& csv_file, double scale = 1);

struct MooringLine {
  std::string name;
  Vec3 fairlead_B = Vec3::Zero();  ///< frame B of the hull; on a turret, at its angle 0 [m]
  Vec3 anchor = Vec3::Zero();      ///< frame G [m]
  std::variant<CatenaryLine, SpringLine> form;
  double damping = 0;                ///< tension per speed at which the fairlead draws the line out [N s/m]
  std::optional<double> break_load;  ///< the line breaks where its tension reaches this [N]
  std::optional<double> break_time;  ///< the line breaks at this time [s]
  bool on_turret = false;
};

/// A turret turns without inertia about the hull's vertical axis through `at_B`. It follows its lines until their
/// moment about that axis is within the friction.
struct Turret {
  Vec3 at_B = Vec3::Zero();  ///< frame B [m]
  double friction = 0;       ///< moment of Coulomb friction, 0: free [N m]
};

struct MooringModel {
  std::vector<MooringLine> lines;
  std::optional<Turret> turret;
  std::optional<double> bed;  ///< height of the level sea bed in G; empty: the lines meet no bed [m]
};

/// What a mooring remembers.
struct MooringState {
  std::vector<char> broken;  ///< one entry per line
  double turret_angle = 0;   ///< of the turret on the hull, about the hull's z axis [rad]
};

/// Pose and velocity of the hull's frame B, as Bodies has them.
struct HullMotion {
  Pose pose;
  Vec3 v = Vec3::Zero();  ///< of the centre of mass [m/s]
  Vec3 w = Vec3::Zero();  ///< in G [rad/s]
};

/// The pull of a line at rest on its fairlead, in G.
struct LineForce {
  Vec3 on_fairlead = Vec3::Zero();  ///< [N]
  Mat3 stiffness = Mat3::Zero();    ///< minus the derivative of the force by the fairlead's place [N/m]
  double fairlead_tension = 0;      ///< [N]
  double anchor_tension = 0;        ///< [N]
  double strain = 0;                ///< greatest strain of a catenary; stretch by length of a spring [-]

  double tension() const { return std::max(fairlead_tension, anchor_tension); }
};
/// The height at which the axis of a line rests on a bed at this height, half a diameter above it [m]; empty where
/// there is no bed, and for a line that meets none: a spring or a buoyant line.
std::optional<double> axis_on_bed(const MooringLine& line, std::optional<double> bed);
/// An anchor below axis_on_bed() holds its end of the line there. Throws SimulationError where the fairlead is below
/// it.
LineForce line_force(const MooringLine& line, std::optional<double> bed, const Vec3& fairlead);

/// The turret's angle at a pose, from that of the state. It stays where the moment of its lines is within the friction.
/// Otherwise it turns as that moment does, until the moment equals the friction. This is the implicit law of a slider
/// with dry friction. Throws SimulationError where the lines have no such balance.
double turret_angle(const MooringModel& model, const MooringState& state, const Pose& pose);

/// Loads of all lines that are not broken.
struct MooringLoads {
  Wrench on_hull;                ///< about the hull's centre of mass, in G
  std::vector<double> tensions;  ///< of each line, damping included: the greater of both ends [N]
};
/// Loads with the turret at `state.turret_angle`. Damping adds c times the speed of the fairlead against the pull to
/// the tension, which does not fall below zero. A slack spring has none. A fairlead on the turret has the velocity of
/// the hull without its turning about the turret's axis.
MooringLoads mooring_loads(const MooringModel& model, const MooringState& state, const HullMotion& hull);

/// Minus the derivative of the loads at rest by small motions (translation; rotation) of the centre of mass, in G.
/// A turret without friction follows. With friction it stays on the hull.
Mat6 mooring_stiffness(const MooringModel& model, const MooringState& state, const Pose& pose);

/// Minus the derivative of the loads by small velocities (translation; rotation) of the centre of mass, in G, of lines
/// that are all under tension and all on the hull: the most that their damping can be.
Mat6 mooring_damping(const MooringModel& model, const MooringState& state, const Pose& pose);

}  // namespace nilas::vessel
