#pragma once
/// The motion of an actuator towards its command, exact over steps of any size.

namespace nilas::vessel {

/// The value after h [s] of  dx/dt = clamp((command - x) / lag, -rate, rate)  from x, for a constant command. A lag of
/// 0 follows at once, or at `rate` [unit of x per s], which may be infinite. Exact: far from the command x moves at
/// `rate`, within rate * lag of it by an exponential.
double follow_command(double x, double command, double lag, double rate, double h);

/// The angle after h [s] that turns from `angle` to `command` the shortest way, at most at `rate` [rad/s]; in (-pi,
/// pi].
double turn_towards(double angle, double command, double rate, double h);

/// The equal angle in (-pi, pi].
double wrapped(double angle);

}  // namespace nilas::vessel
