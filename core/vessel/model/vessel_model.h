#pragma once
/// What a vessel is made of, and what its system takes and gives: plain values.
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

namespace nilas {

/// One uniaxial load cell: a point and an axis in the carriage's frame, from the joint. The axis points from vessel to
/// carriage and tension is positive: a carriage that pulls the vessel along +axis reads positive, a load of 120 N on
/// the vessel along +axis reads -120 N.
struct LoadCell {
  Vec3 point = Vec3::Zero();  ///< [m]
  Vec3 axis = Vec3::UnitX();  ///< unit
};
/// One longitudinal, two transverse (fore, aft), three vertical cells, spaced by `arm` [m]. Axes +X, +Y, +Z; their
/// stiffness does not couple the axes at the joint.
std::array<LoadCell, 6> default_cells(double arm);
/// Reads columns x_m,y_m,z_m,ax,ay,az; axes need not be unit. Throws FileError, or InputError for a wrong or singular
/// layout.
std::array<LoadCell, 6> read_cells(const std::string& csv_file);

/// Position and yaw of the carriage over time, with exact derivatives.
class CarriageMotion {
 public:
  struct State {
    Vec3 p = Vec3::Zero();  ///< of the joint point in G [m]
    double yaw = 0;         ///< [rad]
    Vec3 v = Vec3::Zero();  ///< [m/s]
    double yaw_rate = 0;    ///< [rad/s]
  };
  struct Moment {
    State now;
    State acceleration;  ///< only v [m/s^2] and yaw_rate [rad/s^2] count
  };
  /// Speed along `direction` (rad from X), reached over `ramp` seconds from t0; yaw constant.
  static CarriageMotion straight(const Vec3& start, double yaw, double speed, double direction, double ramp, double t0,
                                 RampShape shape = RampShape::linear);
  /// Natural cubic spline through rows t_s,x_m,y_m,yaw_deg of a CSV file: their differences to the first row, along the
  /// axes of G, are added to `start` and `yaw`. At rest before the first and after the last row. Throws FileError,
  /// InputError.
  static CarriageMotion path(const Vec3& start, double yaw, const std::string& csv_file);
  State at(double t) const { return moment(t, t).now; }
  /// The motion at t as the smooth stretch around the instant `within` would go on there.
  Moment moment(double t, double within) const;
  /// Instants in rising order at which speed, acceleration or its rate may jump: the ends of the stretches [s].
  std::vector<double> kinks() const;
  bool follows_path() const { return knots_ != nullptr; }
  /// First and last time of a path [s]. Throws ContractError where the motion follows none.
  std::array<double, 2> path_span() const;
  /// Of a straight motion, from X; against the carriage's heading where its speed is negative [rad].
  double direction() const { return speed_ < 0 ? direction_ + k_pi : direction_; }

 private:
  struct Knots;
  std::shared_ptr<const Knots> knots_;  ///< of a path
  Vec3 start_ = Vec3::Zero();
  double yaw_ = 0, speed_ = 0, direction_ = 0, ramp_ = 0, t0_ = 0;
  RampShape shape_ = RampShape::linear;
};

struct CarriageModel {
  CarriageMotion motion;
  Vec3 joint_V = Vec3::Zero();  ///< joint point in the vessel frame V [m]
  std::array<bool, 6> free{};   ///< surge sway heave roll pitch yaw; prismatic: heave, whatever stands here
  BalanceKind balance = BalanceKind::rigid;
  double stiffness = 0;  ///< of each cell [N/m]
  double damping = 0;    ///< of each cell [N s/m]
  std::array<LoadCell, 6> cells{};

  bool free_in_heave() const { return balance == BalanceKind::prismatic || free[2]; }
};

struct VesselModel {
  MassProperties mass;    ///< com and inertia (about com) in V
  Pose pose_V;            ///< of frame V in G at the start; on a carriage: before the carriage moves
  Vec3 v = Vec3::Zero();  ///< free vessel: velocity of the centre of mass at the start [m/s]
  Vec3 w = Vec3::Zero();  ///< free vessel [rad/s]
  bool fixed = false;
  std::optional<CarriageModel> carriage;  ///< neither fixed nor carriage: free
  bool gyroscopic = true;
  /// Share of a step's motion that follows its impulses (moreau); none: semi-implicit Euler.
  std::optional<double> theta;
  std::vector<PartModel> parts;  ///< on the hull, whose mass is the one above; gyroscopic must be true with them
  std::vector<RodModel> rods;    ///< gyroscopic must be true with them

  bool is_jointed() const { return !parts.empty() || !rods.empty(); }
};

/// Mean twist (v; w) of a body's centre of mass in G = jacobian * speeds + prescribed.
struct BodyTwist {
  MatX jacobian;                   ///< 6 x n
  Vec6 prescribed = Vec6::Zero();  ///< what the carriage imposes
};

/// The vessel's block of the contact problem for one step. Its coordinates are the mean speeds over the step,
/// (displacement / h), so a contact sees where the hull will be at the step's end, however stiff the cells are; along
/// the cells they are also the speeds at the step's end (exponential_mode.h). With theta, the displacement is that from
/// the middle pose of this step to that of the next: theta h in this step, the rest in the next.
struct VesselBlock {
  MatX mass;  ///< n x n, effective, symmetric positive definite; its inverse is the speeds' response to an impulse
  VecX f;     ///< n, mass * (mean speeds without contact)
  BodyTwist hull;
  std::vector<BodyTwist> parts;  ///< in the order of the model's parts
};

/// Where the vessel is and how it moves. Frame B of the body arrays: axes of V, origin at the centre of mass. The part
/// of the velocity that comes from the deflection of cells is the mean over the last step; with theta, between the
/// middle poses around its end.
struct VesselState {
  Pose pose;              ///< of the centre-of-mass frame
  Vec3 v = Vec3::Zero();  ///< of the centre of mass in G [m/s]
  Vec3 w = Vec3::Zero();  ///< in G [rad/s]
};

/// What the carriage did to the vessel in one step: impulse over the step divided by its length, in G. Torques about
/// the centre of mass and about the joint, the point of the carriage, both where they are at the step's end; with
/// theta, halfway between its ends.
struct CarriageLoads {
  Wrench about_com;
  Wrench about_joint;             ///< the same force
  std::array<double, 6> cells{};  ///< six-cells only: the readings that balance about_joint [N]
  /// Simbody's reaction of the joint less the load that the momenta show, about the centre of mass; nothing where only
  /// one of them is known.
  std::optional<Wrench> disagreement;
};

/// What acts on a vessel at rest beside its carriage, and the scales of it.
struct RestModel {
  /// Weight and buoyancy of hull and parts, each about its centre of mass in G, where their frames are at these poses.
  std::function<std::vector<Wrench>(const std::vector<Pose>&)> loads;
  double weight = 0;    ///< scale of the forces [N]
  double length = 1;    ///< scale of the moves [m]
  bool afloat = false;  ///< water balances heave, roll and pitch where the joint leaves them free
  double heave = 0;     ///< along a free heave, where the search begins a second time if the first fails [m]
};

/// Where a towed vessel is at rest.
struct VesselRest {
  /// What the carriage carries there, torques and readings as of a step at rest; nothing where there is no rest.
  std::optional<CarriageLoads> carried;
  /// The part that moves, where it is one that keeps the vessel from rest.
  std::optional<std::size_t> moving_part;
};

/// A part and its joint after a step.
struct PartState {
  VesselState state;  ///< frame B: the part's own axes, origin at its centre of mass
  /// What the joint, its spring and damper included, exerts on the part about the joint point, which moves with the
  /// part: impulse over the step divided by its length, in G.
  Wrench joint;
  /// hinge: angle [rad]; slider: travel [m]; ball: rotation vector in the parent's axes of V [rad]; else nothing.
  VecX coordinates;
  VecX rates;  ///< as many [rad/s, m/s]
  /// What the momenta of this part lack against its joints' loads, as means over the step [N, N m].
  double unbalanced_force = 0, unbalanced_torque = 0;
};

/// What joints and rods did in one step, for accounts of energy and momentum.
struct JointAccount {
  /// Per body, hull first: net mean load of all joints, rods and the carriage about its centre of mass, in G, in the
  /// velocity step at the pose of the contacts [N, N m].
  std::vector<Wrench> held;
  double spring_work = 0;    ///< of springs and dampers [J]
  double carriage_work = 0;  ///< in the velocity step [J]
  /// In the motion before the velocity step, and after it [J].
  struct Motion {
    double carriage = 0;  ///< work of the carriage
    double springs = 0;   ///< of what holds sprung joints and cells while the carriage changes its speed
  };
  Motion before, after;
  VecX rods;  ///< tension of each rod, positive where it pulls, mean over the step [N]
};

}  // namespace nilas
