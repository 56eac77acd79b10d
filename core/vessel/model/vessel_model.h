#pragma once
/// The model of a vessel, and the input and output of its system, as plain values.
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/choices/vessel_choices.h"
#include "core/geometry/mass_properties.h"
#include "core/vessel/model/vessel_parts.h"

namespace nilas::vessel {

/// One uniaxial load cell: a point and an axis in the carriage's frame, from the joint. The axis points from vessel to
/// carriage and tension is positive. A carriage that pulls the vessel along +axis reads positive; a load of 120 N on
/// the vessel along +axis reads -120 N.
struct LoadCell {
  Vec3 point = Vec3::Zero();  ///< [m]
  Vec3 axis = Vec3::UnitX();  ///< unit
};
/// The default layout: one longitudinal, two transverse (fore, aft) and three vertical cells, at distances of `arm`
/// [m]. Their axes are +X, +Y, +Z; their stiffness does not couple the axes at the joint.
std::array<LoadCell, 6> default_cells(double arm);
/// Reads a layout from columns x_m,y_m,z_m,ax,ay,az; axes need not be unit vectors. Points are multiplied by `scale`.
/// Throws FileError, or InputError for a wrong or singular layout.
std::array<LoadCell, 6> read_cells(const std::string& csv_file, double scale = 1);

/// Position and yaw of the carriage over time, with exact derivatives.
class CarriageMotion {
 public:
  struct State {
    Vec3 p = Vec3::Zero();  ///< joint point, frame G [m]
    double yaw = 0;         ///< [rad]
    Vec3 v = Vec3::Zero();  ///< [m/s]
    double yaw_rate = 0;    ///< [rad/s]
  };
  struct Moment {
    State now;
    State acceleration;  ///< only v [m/s^2] and yaw_rate [rad/s^2] are used
  };
  /// Straight motion with constant yaw. The speed along `direction` (angle from X [rad]) is reached over `ramp` seconds
  /// from t0.
  static CarriageMotion straight(const Vec3& start, double yaw, double speed, double direction, double ramp, double t0,
                                 RampShape shape = RampShape::linear);
  /// Motion along the natural cubic spline through rows t_s,x_m,y_m,yaw_deg of a CSV file. Differences to the first
  /// row, along the axes of G, are added to `start` and `yaw`. The carriage is at rest before the first and after the
  /// last row. Positions are multiplied by `scale` and times by its root, as Froude's law has it. Throws FileError,
  /// InputError.
  static CarriageMotion path(const Vec3& start, double yaw, const std::string& csv_file, double scale = 1);
  State at(double t) const { return moment(t, t).now; }
  /// The motion at t by the smooth stretch around the instant `within`, extrapolated where t is outside of that
  /// stretch.
  Moment moment(double t, double within) const;
  /// Instants at which speed, acceleration or its rate may jump, in rising order: the ends of the smooth stretches [s].
  std::vector<double> kinks() const;
  bool follows_path() const { return knots_ != nullptr; }
  /// First and last time of a path [s]. Throws ContractError for a straight motion.
  std::array<double, 2> path_span() const;
  /// Direction of a straight motion, from X [rad]; reversed where the speed is negative.
  double direction() const { return speed_ < 0 ? direction_ + k_pi : direction_; }

 private:
  struct Knots;
  std::shared_ptr<const Knots> knots_;  ///< null for a straight motion
  Vec3 start_ = Vec3::Zero();
  double yaw_ = 0, speed_ = 0, direction_ = 0, ramp_ = 0, t0_ = 0;
  RampShape shape_ = RampShape::linear;
};

struct CarriageModel {
  CarriageMotion motion;
  Vec3 joint_V = Vec3::Zero();  ///< joint point in the vessel frame V [m]
  std::array<bool, 6> free{};   ///< surge, sway, heave, roll, pitch, yaw; prismatic: only heave, unused
  BalanceKind balance = BalanceKind::rigid;
  double stiffness = 0;  ///< stiffness of each cell [N/m]
  double damping = 0;    ///< damping of each cell [N s/m]
  std::array<LoadCell, 6> cells{};

  bool free_in_heave() const { return balance == BalanceKind::prismatic || free[2]; }
};

struct VesselModel {
  geometry::MassProperties mass;  ///< centre of mass, and inertia about it, in V
  Pose pose_V;                    ///< pose of V in G at the start; on a carriage: before it moves
  Vec3 v = Vec3::Zero();          ///< initial velocity of a free vessel's centre of mass [m/s]
  Vec3 w = Vec3::Zero();          ///< initial angular velocity of a free vessel [rad/s]
  bool fixed = false;
  std::optional<CarriageModel> carriage;  ///< a vessel that is neither fixed nor on a carriage is free
  bool gyroscopic = true;
  /// Share of a step's motion after its impulses (Moreau); empty: semi-implicit Euler.
  std::optional<double> theta;
  std::vector<PartModel> parts;  ///< parts on the hull, whose own mass is `mass`; they require gyroscopic = true
  std::vector<RodModel> rods;    ///< rods require gyroscopic = true
  double length_unit = 1;        ///< tolerances on lengths of rods refer to it: the scale of the scene [m]

  bool is_jointed() const { return !parts.empty() || !rods.empty(); }
};

/// Mean twist (v; w) of a body's centre of mass in G = jacobian * speeds + prescribed.
struct BodyTwist {
  MatX jacobian;                   ///< 6 x n
  Vec6 prescribed = Vec6::Zero();  ///< twist that the carriage prescribes
};

/// The vessel's block of the contact problem for one step. Its coordinates are the mean speeds over the step
/// (displacement / h), so that contacts see the hull's pose at the step's end, however stiff the cells are. Along the
/// cells they are also the speeds at the step's end (exponential_mode.h). With theta, the displacement is that from the
/// middle pose of this step to that of the next: theta h in this step, the rest in the next.
struct VesselBlock {
  MatX mass;  ///< n x n, symmetric positive definite; the inverse is the speeds' response to an impulse
  VecX f;     ///< n entries: mass * (mean speeds without contact)
  BodyTwist hull;
  std::vector<BodyTwist> parts;  ///< same order as the model's parts
};

/// Pose and velocity of the vessel. Frame B of the body arrays: axes of V, origin at the centre of mass. The velocity
/// from deflection of the cells is the mean over the last step; with theta, the mean between the middle poses around
/// its end.
struct VesselState {
  Pose pose;              ///< pose of frame B
  Vec3 v = Vec3::Zero();  ///< velocity of the centre of mass, frame G [m/s]
  Vec3 w = Vec3::Zero();  ///< angular velocity, frame G [rad/s]
};

/// The carriage's load on the vessel in one step: impulse over the step divided by its length, frame G. Torques are
/// about the centre of mass and about the joint (the point of the carriage), both at the step's end; with theta,
/// halfway through the step.
struct CarriageLoads {
  Wrench about_com;
  Wrench about_joint;             ///< same force, torque about the joint
  std::array<double, 6> cells{};  ///< balance about_joint [N]; only for six-cells
  /// Difference about the centre of mass: Simbody's reaction of the joint minus the load from the momenta. Empty where
  /// only one of them is known.
  std::optional<Wrench> disagreement;
};

/// Loads on a vessel at rest, without those of its carriage, and their scales.
struct RestModel {
  /// Weight and buoyancy of hull and parts, each about its centre of mass in G, as a function of their poses.
  std::function<std::vector<Wrench>(const std::vector<Pose>&)> loads;
  double weight = 0;    ///< scale of the forces [N]
  double length = 1;    ///< scale of the displacements [m]
  bool afloat = false;  ///< true if water balances heave, roll and pitch where the joint leaves them free
  double heave = 0;     ///< heave from which the search starts again if it fails the first time [m]
};

/// The rest of a towed vessel.
struct VesselRest {
  /// The carriage's load at rest, torques and readings as for a step at rest; empty where there is no rest.
  std::optional<CarriageLoads> carried;
  /// Index of the part that keeps the vessel from rest, if it is a part.
  std::optional<std::size_t> moving_part;
};

/// A part and its joint after a step.
struct PartState {
  VesselState state;  ///< frame B has the part's own axes and its origin at the centre of mass
  /// Load of the joint on the part, spring and damper included: impulse over the step divided by its length, frame G.
  /// The torque is about the joint point, which moves with the part.
  Wrench joint;
  /// hinge: angle [rad]; slider: travel [m]; ball: rotation vector in the parent's axes of V [rad]; other joints:
  /// empty.
  VecX coordinates;
  VecX rates;  ///< rates of the coordinates [rad/s, m/s]
  /// Change of this part's momenta minus the impulses of all loads, as means over the step [N, N m].
  double unbalanced_force = 0, unbalanced_torque = 0;
};

/// Loads and works of joints and rods in one step, for accounts of energy and momentum.
struct JointAccount {
  /// Mean load of all joints, rods and the carriage on each body, hull first. About its centre of mass, frame G, in the
  /// velocity step at the pose of the contacts [N, N m].
  std::vector<Wrench> held;
  double spring_work = 0;    ///< work of springs and dampers [J]
  double carriage_work = 0;  ///< work of the carriage in the velocity step [J]
  /// Works in the motion before the velocity step, and after it [J].
  struct Motion {
    double carriage = 0;  ///< work of the carriage
    double springs = 0;   ///< work of what holds sprung joints and cells while the carriage changes its speed
  };
  Motion before, after;
  VecX rods;  ///< mean tension of each rod over the step, positive where it pulls [N]
};

}  // namespace nilas::vessel
