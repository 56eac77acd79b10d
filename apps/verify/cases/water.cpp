/// Family I: water that moves with bodies, and waves that they make.
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <complex>

#include "apps/verify/families.h"
#include "apps/verify/scene_changes.h"

namespace nilas::verify {

namespace {

constexpr double k_hull_mass = 500, k_hull_yaw_inertia = 300;  // of hull-in-water.xml and oblique-tow.xml [kg, kg m^2]

/// The floe's added mass in heave is that of a disc of its area, wet on one side: 4/3 rho a^3.
std::vector<Quantity> heaving_disc(const Setting& s) {
  constexpr double k_water = 1025, k_area = 16, k_offset = 0.02, k_end = 5;
  const double t = s["thickness"], mass = s["density"] * k_area * t, radius = std::sqrt(k_area / k_pi);
  const double added = 4.0 / 3 * k_water * std::pow(radius, 3);
  const double omega = std::sqrt(k_water * k_gravity * k_area / (mass + added)),
               rest = t * (0.5 - s["density"] / k_water);
  Trial run =
      s.trial({{"ice/@density", text(s["density"])}, {"ice/@thickness", text(t)}, {"ice/floe[1]/@z", text(k_offset)}});
  double x = k_offset, v = 0, worst = 0;
  for (long k = 0; k < s.steps(k_end); ++k) {
    run.step();
    x += (1 - s.theta()) * s.h() * v;
    v -= s.h() * omega * omega * x;
    x += s.theta() * s.h() * v;
    worst = std::max(worst, std::abs(run.body("floe").p.z() - rest - x));
  }
  return {{"largest error of the heave in 5 s [m]", worst, 0, k_offset},
          {"heave after 5 s [m]", run.body("floe").p.z() - rest, x, k_offset}};
}

scene::Overrides added_mass(const Setting& s) {
  return {{"hydro/added_mass/@matrix", text(s["surge"]) + " " + text(s["sway"]) + " 900 50 300 " + text(s["yaw"])}};
}

/// Kirchhoff's equations in the plane: the momentum of body and water stays P, and the angle f of P to the hull's x
/// axis turns as a pendulum, (2 f)'' = k sin 2 f with k = (M2 - M1) P^2 / (M1 M2 I). With s0 = cos f0 the hull, at
/// first without spin, has turned by asin(s0 cd(sqrt(k) t, s0)) - asin(s0).
std::vector<Quantity> free_hull(const Setting& s) {
  const double m1 = k_hull_mass + s["surge"], m2 = k_hull_mass + s["sway"], inertia = k_hull_yaw_inertia + s["yaw"];
  const Vec3 start(0.7, 0.4, 0), momentum(m1 * start.x(), m2 * start.y(), 0);
  Trial run = s.trial(added_mass(s) + scene::Overrides{{"vessel/@velocity", text(start)}});
  const long n = s.steps(10);
  run.run(n);
  const double first = momentum.x() / momentum.norm();
  const double rate = std::sqrt((m2 - m1) / (m1 * m2 * inertia)) * momentum.norm();
  double cn = 0, dn = 0;
  boost::math::jacobi_elliptic(first, rate * static_cast<double>(n) * s.h(), &cn, &dn);
  const double yaw = std::asin(first * cn / dn) - std::asin(first);
  const BodyState hull = run.body("hull");
  const Vec3 along = hull.q * Vec3::UnitX(), across = hull.q * Vec3::UnitY();
  const Vec3 at_end = m1 * hull.v.dot(along) * along + m2 * hull.v.dot(across) * across;
  return {{"yaw after 10 s [rad]", std::atan2(along.y(), along.x()), yaw, 1},
          {"change of the momentum of hull and water [N s]", (at_end - momentum).norm(), 0, momentum.norm()}};
}

std::vector<Quantity> oblique_tow(const Setting& s) {
  constexpr double k_ramp = 2;
  const double angle = 30 * k_deg, speed = s["speed"], u = speed * std::cos(angle), v = -speed * std::sin(angle);
  Trial run = s.trial(added_mass(s) + scene::Overrides{{"vessel/carriage/@speed", text(speed)}});
  run.run(s.steps(0.5 * k_ramp));
  // On the ramp the water takes A a in the hull's axes; only its part along the tow is looked at.
  const double along = std::pow(std::cos(angle), 2) * s["surge"] + std::pow(std::sin(angle), 2) * s["sway"];
  const double on_ramp = run.last().vessel->carriage->about_com.force.x();
  run.run(s.steps(k_ramp));
  return {{"tow force on the ramp [N]", on_ramp, (k_hull_mass + along) * speed / k_ramp},
          {"tow force at constant speed [N]", run.last().vessel->carriage->about_com.force.norm(), 0, on_ramp},
          {"Munk moment of the water [N m]", run.last().vessel->hydro->torque.z(), -(s["sway"] - s["surge"]) * u * v}};
}

/// The coefficients of a polynomial, from the constant.
VecX product(const VecX& a, const VecX& b) {
  VecX out = VecX::Zero(a.size() + b.size() - 1);
  for (Eigen::Index i = 0; i < a.size(); ++i) out.segment(i, b.size()) += a[i] * b;
  return out;
}

std::complex<double> value(const VecX& a, std::complex<double> s) {
  std::complex<double> sum = 0;
  for (Eigen::Index k = a.size(); k-- > 0;) sum = sum * s + a[k];
  return sum;
}

/// The inverse Laplace transform of above / below at t, for single roots: sum of above(p) / below'(p) exp(p t).
double inverse_transform(const VecX& above, const VecX& below, double t) {
  const Eigen::Index n = below.size() - 1;
  MatX companion = MatX::Zero(n, n);
  companion.bottomLeftCorner(n - 1, n - 1).setIdentity();
  companion.col(n - 1) = -below.head(n) / below[n];
  VecX slope(n);
  for (Eigen::Index k = 1; k <= n; ++k) slope[k - 1] = static_cast<double>(k) * below[k];
  double sum = 0;
  const Eigen::VectorXcd roots = companion.eigenvalues();
  for (const std::complex<double>& p : roots) sum += (value(above, p) / value(slope, p) * std::exp(p * t)).real();
  return sum;
}

/// Cummins' equation M z'' + int K z' + C z = 0 of a release from z0 has the transform
///   Z = z0 (M s + H) / (M s^2 + H s + C), with H = 1000 s (s^2 + 4 s + 4) / ((s^2 + s + 1)(s^2 + 3 s + 4)) of the
///   file.
std::vector<Quantity> released(const Setting& s) {
  constexpr double k_infinite = 5000, k_stiffness = 20000, k_size = 1000, k_lift = 0.1, k_end = 8;
  VecX above(4), one(3), other(3), inertia(2), motion(3);
  above << 0, 4 * k_size, 4 * k_size, k_size;
  one << 1, 1, 1;
  other << 4, 3, 1;
  const VecX below = product(one, other);
  inertia << 0, s["mass"] + k_infinite;
  motion << k_stiffness, 0, s["mass"] + k_infinite;
  VecX upper = product(inertia, below), lower = product(motion, below);
  upper.head(4) += above;
  lower.segment(1, 4) += above;
  Trial run = s.trial({{"vessel/mass/@value", text(s["mass"])}, {"vessel/@position", text(Vec3(0, 0, k_lift))}});
  double worst = 0, exact = 0;
  for (long k = 1; k <= s.steps(k_end); ++k) {
    run.step();
    exact = k_lift * inverse_transform(upper, lower, static_cast<double>(k) * s.h());
    worst = std::max(worst, std::abs(run.body("hull").p.z() - exact));
  }
  return {{"largest error of the heave in 8 s [m]", worst, 0, k_lift},
          {"heave after 8 s [m]", run.body("hull").p.z(), exact, k_lift}};
}

}  // namespace

std::vector<Case> water() {
  FamilyOfCases add('I', "hull-in-water.xml", "Kirchhoff's equations (Lamb 1932, art. 124)");
  const Input surge{"surge", 100, "kg"}, sway{"sway", 400, "kg"}, yaw{"yaw", 200, "kg m^2"};
  const std::vector<std::string> no_contact{"auto"};
  Case& disc =
      add(82, "Heaving floe with added mass", "omega^2 = rho g A/(m + 4/3 rho a^3), stepped by the theta scheme",
          {{"density", 917, "kg/m^3"}, {"thickness", 1, "m"}}, "thickness", heaving_disc);
  disc.scene = "disc-floe.xml";
  disc.source = "Lamb 1932, art. 102: a disc of radius a that moves along its axis";
  disc.solvers = no_contact;
  Case& free = add(83, "Free hull in still water", "P = const; (2 f)'' = (1/M1 - 1/M2) P^2/I sin 2 f, f = angle of P",
                   {surge, sway, yaw}, "sway", free_hull);
  free.solvers = no_contact;
  free.step = 0.04;
  free.orders = {1, 1};
  free.coarsest = {0.03, 0.015};
  free.note = "The load of the water on the vessel is that of the start of the step.";
  Case& tow = add(84, "Oblique tow", "force (m + A_xx) a on the ramp, then none; moment (A22 - A11) u v",
                  {surge, sway, yaw, {"speed", 1, "m/s"}}, "sway", oblique_tow);
  tow.scene = "oblique-tow.xml";
  tow.solvers = no_contact;
  Case& memory = add(85, "Release with the memory of radiated waves", "Z = z0 (M s + H)/(M s^2 + H s + C), H rational",
                     {{"mass", 3000, "kg"}}, "mass", released);
  memory.scene = "memory.xml";
  memory.source = "Cummins 1962; the inverse transform by partial fractions";
  memory.solvers = no_contact;
  memory.integrators = {"moreau"};
  memory.tolerance = 1e-3;
  return add.cases();
}

}  // namespace nilas::verify
