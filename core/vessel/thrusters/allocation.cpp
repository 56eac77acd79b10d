#include "core/vessel/thrusters/allocation.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/vessel/thrusters/actuator.h"

namespace nilas::vessel {

namespace {

/// Weight of the shortfall against that of all power. A thruster then misses its load by about a millionth of its
/// share.
constexpr double k_shortfall_weight = 1e6;
/// Weight of the square of an angle's distance from the wanted one [1/rad^2]: above that of power, below the shortfall.
constexpr double k_angle_weight = 10;
constexpr int k_sides = 16;  // of the polygon that stands for an azimuth's disc

numerics::QuadraticProgram empty_program(Eigen::Index n) {
  numerics::QuadraticProgram program;
  program.H = MatX::Zero(n, n);
  program.g = VecX::Zero(n);
  program.lower = VecX::Zero(n);
  program.upper = VecX::Zero(n);
  program.rows = MatX(0, n);
  return program;
}

/// Adds q |wanted - B x|^2, all in shares.
void add_shortfall(const MatX& B, const PlaneLoad& wanted, numerics::QuadraticProgram& program) {
  program.H += 2 * k_shortfall_weight * B.transpose() * B;
  program.g -= 2 * k_shortfall_weight * B.transpose() * wanted;
}

/// Adds the row  normal . (x_k, x_k+1) <= most.
void add_row(Eigen::Index k, const Vec2& normal, double most, numerics::QuadraticProgram& program) {
  const Eigen::Index m = program.rows.rows();
  program.rows.conservativeResize(m + 1, program.g.size());
  program.rows.row(m).setZero();
  program.rows.row(m).segment<2>(k) = normal.transpose();
  program.least.conservativeResize(m + 1);
  program.most.conservativeResize(m + 1);
  program.least[m] = -std::numeric_limits<double>::infinity();
  program.most[m] = most;
}

/// Holds the force of an azimuth, the unknowns k and k + 1, within an inscribed polygon.
void add_disc(Eigen::Index k, numerics::QuadraticProgram& program) {
  program.lower.segment<2>(k).setConstant(-1);
  program.upper.segment<2>(k).setConstant(1);
  for (int side = 0; side < k_sides; ++side)
    add_row(k, direction_of((side + 0.5) * 2 * k_pi / k_sides), std::cos(k_pi / k_sides), program);
}

/// Holds the force of a propeller with rudder ahead within the triangle of no thrust and full thrust at both largest
/// angles; at small angles its force is a little larger, by the rudder's drag.
void add_triangle(Eigen::Index k, const Thruster& thruster, numerics::QuadraticProgram& program) {
  const Vec2 corner = thruster.direction(thruster.rudder.most_angle);
  program.lower.segment<2>(k) << 0, -corner.y();
  program.upper.segment<2>(k) << 1, corner.y();
  for (const double side : {-1.0, 1.0}) {
    add_row(k, Vec2(-corner.y(), side * corner.x()), 0, program);
    add_row(k, Vec2(corner.y(), side * (1 - corner.x())), corner.y(), program);
  }
}

/// Takes the thrusts out of low to high whose force would point into a forbidden sector, whatever the rates: those
/// ahead at the angle itself, those astern opposite to it.
void forbid(const Thruster& thruster, double angle, double& low, double& high) {
  if (thruster.is_forbidden(angle)) {
    low = std::min(low, 0.0);
    high = std::min(high, 0.0);
  }
  if (thruster.is_forbidden(angle + k_pi)) {
    low = std::max(low, 0.0);
    high = std::max(high, 0.0);
  }
}

VecX solution_of(const numerics::QuadraticProgram& program) {
  const numerics::QuadraticSolution solution = solve_quadratic_program(program);
  if (!solution.converged) throw SimulationError("the thrust allocation found no solution: " + solution.message);
  return solution.x;
}

/// The rudder's angle whose deflected thrust has this direction; the deflection grows with the angle.
double rudder_angle(const Thruster& thruster, const Vec2& force) {
  double low = -thruster.rudder.most_angle, high = thruster.rudder.most_angle;
  constexpr int k_halvings = 50;  // down to rounding
  for (int k = 0; k < k_halvings; ++k) {
    const double middle = 0.5 * (low + high);
    (cross2(thruster.direction(middle), force) > 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

Allocation::Allocation(std::vector<Thruster> thrusters, const Vec3& com_V) : thrusters_(std::move(thrusters)) {
  double power = 0;
  for (const Thruster& thruster : thrusters_) power += thruster.power;
  for (const Thruster& thruster : thrusters_) {
    at_.emplace_back((thruster.at_V - com_V).head<2>());
    weights_.push_back(thruster.power / power);
    scales_ += std::max(thruster.most_ahead, thruster.most_astern) * Vec2(1, at_.back().norm());
  }
  // Thrusters at the centre of mass alone give no moment; any length is then right.
  if (scales_.y() == 0) scales_.y() = scales_.x();
}

PlaneLoad Allocation::unit_load(std::size_t k, double angle, bool ahead) const {
  const Vec2 force = thrusters_[k].direction(angle, ahead);
  return {force.x(), force.y(), cross2(at_[k], force)};
}

PlaneLoad Allocation::load_of(const std::vector<ThrusterCommand>& commands) const {
  PlaneLoad load = PlaneLoad::Zero();
  for (std::size_t k = 0; k < thrusters_.size(); ++k)
    load += commands[k].thrust * unit_load(k, commands[k].angle, commands[k].thrust > 0);
  return load;
}

numerics::QuadraticProgram Allocation::first_program(const PlaneLoad& wanted,
                                                     const std::vector<ThrusterCommand>& present,
                                                     unsigned astern) const {
  // Two unknowns per thruster, its force in shares of most_ahead; the second is zero where it cannot turn.
  const auto n = static_cast<Eigen::Index>(2 * thrusters_.size());
  numerics::QuadraticProgram program = empty_program(n);
  MatX B = MatX::Zero(3, n);
  unsigned rudder = 0;
  for (std::size_t k = 0; k < thrusters_.size(); ++k) {
    const Thruster& thruster = thrusters_[k];
    const auto x = static_cast<Eigen::Index>(2 * k);
    const bool tunnel = thruster.kind == ThrusterKind::tunnel;
    const double most = thruster.most_ahead;
    const Vec2 first = tunnel ? Vec2::UnitY() : Vec2::UnitX();
    B.col(x) = in_shares(most * PlaneLoad(first.x(), first.y(), cross2(at_[k], first)));
    if (thruster.turns()) B.col(x + 1) = in_shares(most * PlaneLoad(0, 1, at_[k].x()));
    program.H(x, x) = program.H(x + 1, x + 1) = 2 * weights_[k];
    if (!present[k].works) continue;
    program.lower[x] = -thruster.most_astern / most;
    program.upper[x] = 1;
    if (thruster.kind == ThrusterKind::azimuth) add_disc(x, program);
    if (thruster.kind != ThrusterKind::propeller_rudder) continue;
    if ((astern >> rudder++ & 1U) == 0)
      add_triangle(x, thruster, program);
    else
      program.upper[x] = 0;
  }
  add_shortfall(B, in_shares(wanted), program);
  return program;
}

std::vector<Allocation::Target> Allocation::targets(const PlaneLoad& wanted,
                                                    const std::vector<ThrusterCommand>& present) const {
  std::vector<Target> targets;
  unsigned rudders = 0;
  bool any = false;
  for (std::size_t k = 0; k < thrusters_.size(); ++k) {
    targets.push_back({present[k].angle});
    any = any || thrusters_[k].turns();
    if (thrusters_[k].kind == ThrusterKind::propeller_rudder && present[k].works) ++rudders;
  }
  if (!any) return targets;
  double least = std::numeric_limits<double>::infinity();
  VecX best;
  for (unsigned astern = 0; astern < 1U << rudders; ++astern) {
    const numerics::QuadraticProgram program = first_program(wanted, present, astern);
    const VecX x = solution_of(program);
    if (const double cost = objective(program, x); cost < least) {
      least = cost;
      best = x;
    }
  }
  // Below this share of its thrust a thruster keeps its angle, which its force would not determine.
  constexpr double k_least_thrust = 1e-3;
  for (std::size_t k = 0; k < thrusters_.size(); ++k) {
    const Vec2 force = best.segment<2>(static_cast<Eigen::Index>(2 * k));
    if (!thrusters_[k].turns() || !present[k].works || force.norm() < k_least_thrust) continue;
    const bool ahead = thrusters_[k].kind == ThrusterKind::azimuth || force.x() > 0;
    if (thrusters_[k].kind == ThrusterKind::azimuth)
      targets[k].angle = thrusters_[k].allowed_angle(std::atan2(force.y(), force.x()));
    else
      targets[k] = {ahead ? rudder_angle(thrusters_[k], force) : 0, ahead};
  }
  return targets;
}

numerics::QuadraticProgram Allocation::second_program(const PlaneLoad& wanted,
                                                      const std::vector<ThrusterCommand>& present,
                                                      const std::vector<Target>& targets, double h) const {
  // Thrusts in shares of most_ahead, then turns [rad].
  const auto n = static_cast<Eigen::Index>(thrusters_.size());
  numerics::QuadraticProgram program = empty_program(2 * n);
  MatX B = MatX::Zero(3, 2 * n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Thruster& thruster = thrusters_[i];
    const ThrusterCommand& now = present[i];
    const double most = thruster.most_ahead;
    const bool rudder = thruster.kind == ThrusterKind::propeller_rudder, ahead = targets[i].ahead;
    program.H(k, k) = 2 * weights_[i];
    program.H(n + k, n + k) = 2 * k_angle_weight;
    if (!now.works) continue;
    B.col(k) = in_shares(most * unit_load(i, now.angle, ahead));
    double& low = program.lower[k] = std::clamp(now.thrust - thruster.rate * h, -thruster.most_astern, most) / most;
    double& high = program.upper[k] = std::clamp(now.thrust + thruster.rate * h, -thruster.most_astern, most) / most;
    if (rudder && ahead) low = std::max(low, std::min(high, 0.0));
    if (rudder && !ahead) high = std::min(high, std::max(low, 0.0));
    forbid(thruster, now.angle, low, high);
    if (!thruster.turns()) continue;
    const double turn = std::min(thruster.turn_rate * h, k_pi);
    program.g[n + k] = -2 * k_angle_weight * wrapped(targets[i].angle - now.angle);
    program.lower[n + k] = -turn;
    program.upper[n + k] = turn;
    if (rudder && !(now.thrust > 0)) continue;
    constexpr double k_difference = 1e-4;  // [rad], for the derivative of the direction
    B.col(n + k) = in_shares(now.thrust / (2 * k_difference) *
                             (unit_load(i, now.angle + k_difference) - unit_load(i, now.angle - k_difference)));
  }
  add_shortfall(B, in_shares(wanted), program);
  return program;
}

AllocatedThrust Allocation::allocate(const PlaneLoad& wanted, const std::vector<ThrusterCommand>& present,
                                     double h) const {
  NILAS_DEMAND(present.size() == thrusters_.size());
  const auto n = static_cast<Eigen::Index>(thrusters_.size());
  const VecX x = solution_of(second_program(wanted, present, targets(wanted, present), h));
  AllocatedThrust out;
  out.commands = present;
  for (Eigen::Index k = 0; k < n; ++k) {
    ThrusterCommand& command = out.commands[static_cast<std::size_t>(k)];
    const Thruster& thruster = thrusters_[static_cast<std::size_t>(k)];
    command.thrust = command.works ? x[k] * thruster.most_ahead : 0;
    if (thruster.kind == ThrusterKind::azimuth) command.angle = wrapped(command.angle + x[n + k]);
    if (thruster.kind == ThrusterKind::propeller_rudder)
      command.angle = std::clamp(command.angle + x[n + k], -thruster.rudder.most_angle, thruster.rudder.most_angle);
  }
  out.given = load_of(out.commands);
  out.shortfall = wanted - out.given;
  out.saturated = in_shares(out.shortfall).norm() > k_saturated;
  return out;
}

}  // namespace nilas::vessel
