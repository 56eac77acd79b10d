#pragma once
/// Thrust allocation: commands to the thrusters that give a wanted load at the least power.
#include <vector>

#include "core/base/math.h"
#include "core/numerics/quadratic_program.h"
#include "core/vessel/thrusters/thruster.h"

namespace nilas::vessel {

/// A load in the horizontal plane: force along the vessel's x and y [N], moment about z through the centre of mass [N
/// m].
using PlaneLoad = Vec3;

/// What the allocation knows of one thruster when it is called.
struct ThrusterCommand {
  double thrust = 0;  ///< present command, without losses [N]
  double angle = 0;   ///< present command [rad]
  bool works = true;
};

struct AllocatedThrust {
  std::vector<ThrusterCommand> commands;    ///< new commands; those of thrusters that do not work: no thrust
  PlaneLoad given = PlaneLoad::Zero();      ///< load of these commands
  PlaneLoad shortfall = PlaneLoad::Zero();  ///< wanted - given: the slack of the quadratic program
  bool saturated = false;                   ///< the shortfall exceeds k_saturated of what all thrusters give
};

/// Share of the largest force and moment of all thrusters from which a shortfall counts as saturation.
constexpr double k_saturated = 1e-3;

/// Minimises, with T_i the thrust, P_i the power at full thrust T_max, and s the shortfall in shares of the largest
/// force and moment of all thrusters,
///   sum w_i (T_i / T_max,i)^2 + q |s|^2,   w_i = P_i / sum P,  q = 1e6,
/// within limits and rates of thrust. Two programs are solved in each call [Fossen 2011, 12.3; Johansen, Fossen, Berge
/// 2004; for rudders Johansen, Fuglseth, Toendel, Fossen 2008]:
///   1. Where thrusters turn: both components of each azimuth within an inscribed polygon of 16 sides, and of each
///      propeller with rudder within the triangle that its rudder spans ahead, or astern with the rudder amidships (all
///      combinations are tried). Rates are left out. Its solution gives the wanted angles; those in forbidden sectors
///      move to the nearest edge.
///   2. Thrusts and turns about the present angles, to first order: B(a) T + B'(a) T_now da. Turns are limited by turn
///      rates and cost q_a (da - wanted)^2. An azimuth gives no thrust whose force points into a forbidden sector.
/// `given` is computed with the new angles, so the error of the first order appears in `shortfall`.
class Allocation {
 public:
  /// `com_V`: centre of mass, frame V [m].
  Allocation(std::vector<Thruster> thrusters, const Vec3& com_V);

  /// `h`: time over which rates act [s]. Throws SimulationError where a program has no solution.
  AllocatedThrust allocate(const PlaneLoad& wanted, const std::vector<ThrusterCommand>& present, double h) const;
  /// Load of thrusts and angles, without speed of advance.
  PlaneLoad load_of(const std::vector<ThrusterCommand>& commands) const;
  /// Load of unit thrust of one thruster at an angle.
  PlaneLoad unit_load(std::size_t k, double angle, bool ahead = true) const;
  /// Largest force [N] and moment [N m] if all thrusters that work pull one way: scales, not limits.
  Vec2 scales() const { return scales_; }
  const std::vector<Thruster>& thrusters() const { return thrusters_; }

 private:
  /// What the first program asks of one thruster.
  struct Target {
    double angle = 0;   ///< [rad]
    bool ahead = true;  ///< propeller with rudder: whether it works ahead
  };
  std::vector<Target> targets(const PlaneLoad& wanted, const std::vector<ThrusterCommand>& present) const;
  /// The first program. Bit m of `astern`: the m-th propeller with rudder that works goes astern.
  numerics::QuadraticProgram first_program(const PlaneLoad& wanted, const std::vector<ThrusterCommand>& present,
                                           unsigned astern) const;
  numerics::QuadraticProgram second_program(const PlaneLoad& wanted, const std::vector<ThrusterCommand>& present,
                                            const std::vector<Target>& targets, double h) const;
  /// The load in shares of the scales.
  PlaneLoad in_shares(const PlaneLoad& load) const {
    return {load.x() / scales_.x(), load.y() / scales_.x(), load.z() / scales_.y()};
  }

  std::vector<Thruster> thrusters_;
  std::vector<Vec2> at_;  ///< points from the centre of mass, axes of the vessel [m]
  std::vector<double> weights_;
  Vec2 scales_ = Vec2::Zero();
};

}  // namespace nilas::vessel
