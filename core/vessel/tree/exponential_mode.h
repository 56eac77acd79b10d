#pragma once
/// One step of a damped oscillator that is exact however stiff the oscillator is.

namespace nilas::vessel {

/// The step of x'' + 2 zeta omega x' + omega^2 x = p in the speed v = (x - x of the step before) / h:
///
///   v+ = decay v + response h (p - omega^2 x),    x+ = x + h v+                                                  (1)
///
/// With z1, z2 = omega h (zeta +- sqrt(zeta^2 - 1)), the exponents of the exact solution over h,
///
///   decay = exp(-(z1 + z2)),    response = (1 - exp(-z1)) / z1 * (1 - exp(-z2)) / z2.                              (2)
///
/// Then free motion passes through the exact x at every step (both exponentials are roots of (1)), a constant p leads
/// to x = p / omega^2 with v = 0 exactly, and (v+ - v)/h is the acceleration averaged over two steps with the weights
/// of a triangle. For omega = 0 (1) is the semi-implicit Euler step of a free body: decay = response = 1. `response` is
/// positive: (1 - exp(-z)) / z is for real z, and for a conjugate pair (2) is the square of its modulus; only without
/// damping would it vanish, where a period is a whole fraction of the step. That the numerical damping below excludes.
///
/// A motion with fewer than two steps per period cannot be told from its samples x. From four steps per period down the
/// damping ratio is therefore at least s^2, s = (omega h - pi/2) / (pi/2) bounded to [0, 1]: critical from two steps
/// per period on. Loads averaged over a step hardly hold that oscillation; their mean is untouched.
///
/// An exact difference scheme in the sense of Mickens, "Nonstandard Finite Difference Models of Differential Equations"
/// (1994).
struct ExponentialMode {
  double decay = 1;     ///< range [0, 1]
  double response = 1;  ///< range (0, 1]: displacement over the step / h, per impulse and mass
};

/// The step coefficients of a mode. `omega`: undamped angular frequency [rad/s], >= 0. `damping_time`: that of a
/// damping proportional to the stiffness, 2 zeta omega = damping_time omega^2 [s], >= 0. `h`: step [s], > 0.
ExponentialMode exponential_mode(double omega, double damping_time, double h);

/// Smallest permitted damping ratio of a mode with omega h = a: 0 up to pi/2, 1 from pi on.
double least_damping_ratio(double a);

}  // namespace nilas::vessel
