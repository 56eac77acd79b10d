/// Family C: free bodies and joints.
#include <array>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>

#include "apps/verify/families.h"
#include "apps/verify/scene_changes.h"

namespace nilas::verify {

namespace {

std::string principal(const Vec3& moments) { return text(moments) + " 0 0 0"; }

Quat turn(const Vec3& by) {
  const double angle = by.norm();
  return angle > 0 ? Quat(Eigen::AngleAxisd(angle, by / angle)) : Quat::Identity();
}

std::vector<Quantity> symmetric_top(const Setting& s) {
  const Vec3 moments(s["across"], s["across"], s["along"]), w(0.3, 0, s["spin"]);
  Trial run = s.trial(of("top", "inertia", principal(moments)) + of("top", "angular_velocity", w));
  run.run(s.steps(5));
  const double t = static_cast<double>(s.steps(5)) * s.h();
  // R(t) = exp(t L/I1) exp(t w3 (1 - I3/I1) e3)
  const Vec3 momentum = moments.cwiseProduct(w);
  const Quat exact =
      turn(t / s["across"] * momentum) * turn(t * w.z() * (1 - s["along"] / s["across"]) * Vec3::UnitZ());
  const BodyState top = run.body("top");
  const Vec3 exact_w = momentum / s["across"] + w.z() * (1 - s["along"] / s["across"]) * (exact * Vec3::UnitZ());
  const double along = (top.inertia * top.w).dot(momentum) / momentum.squaredNorm();
  return {{"angle between attitude and R(t) [rad]", top.q.angularDistance(exact), 0, 1},
          {"error of angular velocity [rad/s]", (top.w - exact_w).norm(), 0, w.norm()},
          {"angular momentum along its start value, as a ratio", along, 1, 1, true}};
}

/// The free rotation of a body with principal moments I1 < I2 < I3 and L^2 > 2 T I2, in Jacobi's elliptic functions. It
/// starts where w2 = 0 and w1, w3 > 0.
struct Euler {
  Euler(const Vec3& I, double w1, double w3) : moments(I) {
    const double twice_energy = I[0] * w1 * w1 + I[2] * w3 * w3;
    const double squared = I[0] * I[0] * w1 * w1 + I[2] * I[2] * w3 * w3;
    const double high = twice_energy * I[2] - squared, low = squared - twice_energy * I[0];
    amplitude = {std::sqrt(high / (I[0] * (I[2] - I[0]))), std::sqrt(high / (I[1] * (I[2] - I[1]))),
                 std::sqrt(low / (I[2] * (I[2] - I[0])))};
    rate = std::sqrt((I[2] - I[1]) * low / (I[0] * I[1] * I[2]));
    modulus = std::sqrt((I[1] - I[0]) * high / ((I[2] - I[1]) * low));
  }
  Vec3 at(double t) const {
    double cn = 0, dn = 0;
    const double sn = boost::math::jacobi_elliptic(modulus, rate * t, &cn, &dn);
    return {amplitude[0] * cn, amplitude[1] * sn, amplitude[2] * dn};
  }
  /// Returns the time between two changes of the sign of w2 [s].
  double half_period() const { return 2 * boost::math::ellint_1(modulus) / rate; }

  Vec3 moments, amplitude;
  double rate = 0, modulus = 0;
};

const Vec3 k_asymmetric(1, 2, 2.5);

std::vector<Quantity> asymmetric_top(const Setting& s) {
  const Euler exact(k_asymmetric, s["w1"], s["w3"]);
  Trial run = s.trial(of("top", "inertia", principal(k_asymmetric)) + of("top", "angular_velocity", exact.at(0)));
  const long n = s.steps(10);
  run.run(n);
  const BodyState top = run.body("top");
  const Vec3 in_body = top.q.conjugate() * top.w;
  return {{"error of angular velocity in body axes [rad/s]",
           (in_body - exact.at(static_cast<double>(n) * s.h())).norm(), 0, exact.at(0).norm()}};
}

/// Without the gyroscopic torque w is constant in G. The body turns about it, and its angular momentum turns too.
std::vector<Quantity> without_gyroscopic_torque(const Setting& s) {
  const Vec3 w(s["w1"], 0, s["w3"]);
  Trial run = s.trial(of("top", "inertia", principal(k_asymmetric)) + of("top", "angular_velocity", w) +
                      scene::Overrides{{"contact/@gyroscopic", "false"}});
  const long n = s.steps(10);
  run.run(n);
  const BodyState top = run.body("top");
  const Quat exact = turn(static_cast<double>(n) * s.h() * w);
  const Vec3 start = k_asymmetric.cwiseProduct(w),
             wrong = exact * Vec3(k_asymmetric.cwiseProduct(exact.conjugate() * w));
  return {{"error of angular momentum after 10 s", (top.inertia * top.w - start).norm() / start.norm(),
           (wrong - start).norm() / start.norm()}};
}

std::vector<Quantity> flipping_top(const Setting& s) {
  const Euler exact(k_asymmetric, s["w1"], s["w3"]);
  Trial run = s.trial(of("top", "inertia", principal(k_asymmetric)) + of("top", "angular_velocity", exact.at(0)));
  double before = 0, first = 0, last = 0;
  int flips = 0;
  const long n = s.steps(3.6 * exact.half_period());
  for (long k = 1; k <= n; ++k) {
    run.step();
    const BodyState top = run.body("top");
    const double now = (top.q.conjugate() * top.w).y();
    if (k > 1 && before * now < 0) {
      last = (static_cast<double>(k) - now / (now - before)) * s.h();
      if (flips++ == 0) first = last;
    }
    before = now;
  }
  return {{"flips about the intermediate axis", static_cast<double>(flips), 3, 1, true},
          {"time between flips [s]", (last - first) / (flips - 1), exact.half_period()}};
}

std::vector<Quantity> free_flight(const Setting& s) {
  const Vec3 w = Vec3(0.1, 1, 0.2).normalized() * s["spin"], v(1, -2, 0.5);
  Trial run = s.trial(of("top", "inertia", principal(k_asymmetric)) + of("top", "angular_velocity", w) +
                      of("top", "velocity", v));
  const Vec3 momentum = k_asymmetric.cwiseProduct(w);
  const double energy = 0.5 * momentum.dot(w);
  double worst_energy = 0, worst_momentum = 0, worst_unit = 0;
  constexpr long k_steps = 1000000, k_every = 1000;
  for (long k = 0; k < k_steps; k += k_every) {
    run.run(k_every);
    const BodyState top = run.body("top");
    const Vec3 now = top.inertia * top.w;
    worst_energy = std::max(worst_energy, std::abs(0.5 * now.dot(top.w) / energy - 1));
    worst_momentum = std::max(worst_momentum, (now - momentum).norm() / momentum.norm());
    worst_unit = std::max(worst_unit, std::abs(top.q.norm() - 1));
  }
  return {{"largest error of rotational energy in 1e6 steps", worst_energy, 0, 1},
          {"largest error of angular momentum", worst_momentum, 0, 1},
          {"error of velocity [m/s]", (run.body("top").v - v).norm(), 0, v.norm()},
          {"largest error of the quaternion's norm", worst_unit, 0, 1}};
}

/// The mass of the bob of pendulum.xml [kg], and its moment of inertia in pitch about its centre of mass [kg m^2].
constexpr double k_bob_mass = 2, k_bob_inertia = 0.2;

std::vector<Quantity> pendulum(const Setting& s) {
  const Vec3 joint(0, 0, 0.1), arm = Vec3(-s["arm"], 0, 0);  // The bob starts at rest, level with the joint.
  Trial run = s.trial({{"vessel/mass/@cog", text(Vec3(joint + arm))}});
  const double length = (k_bob_inertia / k_bob_mass + arm.squaredNorm()) / arm.norm();
  const double exact = 4 * std::sqrt(length / k_gravity) * boost::math::ellint_1(std::sin(k_pi / 4));
  // At a turning point the pitch rate changes its sign.
  double before = 0, first = 0, last = 0;
  int turns = 0;
  const long n = s.steps(1.2 * exact);
  for (long k = 1; k <= n; ++k) {
    run.step();
    const double now = run.body("bob").w.y();
    if (k > 1 && before * now < 0) {
      last = (static_cast<double>(k) - now / (now - before)) * s.h();
      if (turns++ == 0) first = last;
    }
    before = now;
  }
  return {{"turning points", static_cast<double>(turns), 2, 1, true},
          {"period [s]", 2 * (last - first) / (turns - 1), exact}};
}

std::vector<Quantity> boosted(const Setting& s) {
  const Vec3 boost = s["boost"] * Vec3(0.6, -0.64, 0.48), v(2, 0, 0);
  std::array<Vec3, 2> left, right, spin;
  for (const int k : {0, 1}) {
    const Vec3 frame = k * boost;
    Trial run = s.trial(of("left", "velocity", v + frame) + of("right", "velocity", frame) + restitution(0.5));
    run.run(s.steps(0.5));
    const auto i = static_cast<std::size_t>(k);
    left[i] = run.body("left").v - frame;
    right[i] = run.body("right").v - frame;
    spin[i] = run.body("left").w;
  }
  const double scale = boost.norm();
  return {
      {"difference of velocities [m/s]", std::max((left[0] - left[1]).norm(), (right[0] - right[1]).norm()), 0, scale},
      {"difference of spins [rad/s]", (spin[0] - spin[1]).norm(), 0, scale},
      {"the balls collide (1: yes)", (left[0] - v).norm() > 0.1 ? 1.0 : 0.0, 1}};
}

}  // namespace

std::vector<Case> free_bodies() {
  const std::vector<std::string> no_contact{"auto"};
  FamilyOfCases add('C', "top.xml", "Landau, Lifshitz, Mechanics, sections 35 to 37");
  Case& symmetric =
      add(26, "Free symmetric top", "R(t) = exp(t L/I1) R0 exp(t w3 (1 - I3/I1) e3)",
          {{"across", 2, "kg m^2"}, {"along", 3, "kg m^2"}, {"spin", 1.5, "rad/s"}}, "spin", symmetric_top);
  symmetric.step = 0.08;
  symmetric.orders = {2, 2};
  symmetric.coarsest = {1e-3, 2.5e-4};
  Case& asymmetric = add(27, "Free asymmetric top", "w = (a1 cn, a2 sn, a3 dn)(t rate), Jacobi's elliptic functions",
                         {{"w1", 0.5, "rad/s"}, {"w3", 1, "rad/s"}}, "w1", asymmetric_top);
  asymmetric.step = 0.08;
  asymmetric.orders = {2, 2};
  asymmetric.coarsest = {2e-3, 5e-4};
  asymmetric.reference = true;
  Case& flips = add(28, "Flips about the intermediate axis",
                    "half period 2 K(k)/rate, with the rate and the modulus k of the elliptic functions of case 27",
                    {{"w1", 0.75, "rad/s"}, {"w3", 0.7, "rad/s"}}, "w3", flipping_top);
  flips.step = 0.08;
  flips.orders = {2, 2};
  flips.coarsest = {1e-3, 2.5e-4};
  Case& flight =
      add(30, "Free flight of a spinning body, 1e6 steps", "momentum, angular momentum and energy are conserved",
          {{"spin", 1, "rad/s"}}, "spin", free_flight);
  flight.tolerance = 1e-10;
  Case& swings = add(31, "Pendulum about the joint of a carriage",
                     "period 4 sqrt(l/g) K(sin(theta0/2)), theta0 = 90 deg, l = (I + m a^2)/(m a)", {{"arm", 0.8, "m"}},
                     "arm", pendulum);
  swings.scene = "pendulum.xml";
  swings.step = 0.0025;
  swings.orders = {1, 2};
  swings.coarsest = {2e-2, 5e-6};
  Case& wrong = add(32, "Free rotation without the gyroscopic torque",
                    "w is constant in G: L(t) = R I R^T w with R = exp(t w) R0",
                    {{"w1", 0.5, "rad/s"}, {"w3", 1, "rad/s"}}, "w3", without_gyroscopic_torque);
  wrong.source = "The time step without that torque";
  Case& frame = add(33, "Galilean invariance", "the same motion in a frame of constant velocity",
                    {{"boost", 30, "m/s"}}, "boost", boosted);
  frame.scene = "pair.xml";
  frame.source = "Galileo's principle of relativity";
  std::vector<Case> cases = add.cases();
  for (auto& one : cases)
    if (one.number != 33) one.solvers = no_contact;
  return cases;
}

}  // namespace nilas::verify
