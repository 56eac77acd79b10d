/// Family E: impacts.
#include <array>
#include <cmath>

#include "apps/verify/families.h"
#include "apps/verify/scene_changes.h"

namespace nilas::verify {

namespace {

/// The depth [m] of a body that shall touch where the step's impulses act, so that its contact is found.
constexpr double k_met = 1e-13;

/// Returns the gap [m] under a bouncing ball at time t [s] after it was dropped from `drop` [m].
double bouncing_height(double drop, double e, double t) {
  double up = std::sqrt(2 * k_gravity * drop), since = t - up / k_gravity;
  if (since < 0) return drop - 0.5 * k_gravity * t * t;
  up *= e;
  while (since > 2 * up / k_gravity && up > 0) {
    since -= 2 * up / k_gravity;
    up *= e;
  }
  return up * since - 0.5 * k_gravity * since * since;
}

std::vector<Quantity> bounces_in_time(const Setting& s) {
  const double e = s["e"], drop = s["drop"], radius = 0.5, end = std::sqrt(2 * drop / k_gravity) * (1 + e) / (1 - e);
  Trial run = s.trial(of("ball", "position", Vec3(0, 0, radius + drop)) + of("ball", "velocity", "0 0 0") +
                      restitution(e) + friction(0));
  double worst = 0;
  const long n = s.steps(0.8 * end);
  for (long k = 1; k <= n; ++k) {
    run.step();
    const double t = static_cast<double>(k) * s.h();
    worst = std::max(worst, std::abs(run.body("ball").p.z() - radius - bouncing_height(drop, e, t)));
  }
  run.run(s.steps(0.7 * end));
  return {{"largest error of the height until 0.8 of the time of rest [m]", worst, 0, drop},
          {"speed at 1.5 times sqrt(2 h0/g) (1 + e)/(1 - e) [m/s]", run.body("ball").v.norm(), 0, 1}};
}

std::vector<Quantity> bounces(const Setting& s) {
  if (s.model().continuous()) return bounces_in_time(s);
  const double e = s["e"], drop = s["drop"], radius = 0.5;
  Trial run = s.trial(of("ball", "position", Vec3(0, 0, radius + drop)) + of("ball", "velocity", "0 0 0") +
                      restitution(e) + friction(0));
  double before = 0, ratio = 0;
  const double rest = std::sqrt(2 * drop / k_gravity) * (1 + e) / (1 - e);
  const long n = s.steps(1.5 * rest);
  for (long k = 0; k < n; ++k) {
    const double falling = run.body("ball").v.z();
    run.step();
    const double now = run.body("ball").v.z();
    if (ratio == 0 && now > 0) ratio = -now / falling;
    before = now;
  }
  return {{"speed after the first bounce over that before it", ratio, e},
          {"speed at 1.5 times sqrt(2 h0/g) (1 + e)/(1 - e) [m/s]", before, 0, 1}};
}

std::vector<Quantity> elastic_bounces(const Setting& s) {
  const double drop = s["drop"], radius = 0.5;
  constexpr int k_bounces = 10000;
  Trial run = s.trial(of("ball", "position", Vec3(0, 0, radius + drop)) + of("ball", "velocity", "0 0 0") +
                      restitution(1) + friction(0));
  int count = 0;
  double before = 0, worst = 0, lowest = 1e300;
  const double energy = run.initial_ledger().kinetic + run.initial_ledger().potential;
  const long most = 2 * k_bounces * s.steps(2 * std::sqrt(2 * drop / k_gravity));
  for (long k = 0; count < k_bounces && k < most; ++k) {
    const sim::Ledger& ledger = run.step().ledger;
    const double now = run.body("ball").v.z();
    if (now > 0 && before < 0) ++count;
    before = now;
    const double height = (ledger.kinetic + ledger.potential) / energy * (drop + radius) - radius;
    worst = std::max(worst, height / drop - 1);
    lowest = std::min(lowest, height / drop - 1);
  }
  return {{"bounces", static_cast<double>(count), k_bounces},
          {"height gained in 1e4 bounces, as a share of the drop", worst, 0, 1},
          {"height lost in 1e4 bounces, as a share of the drop", -lowest, 0, 1}};
}

std::vector<Quantity> central_hit(const Setting& s) {
  const double e = s["e"], m1 = 2, m2 = s["mass"], v1 = s["speed"], v2 = -0.5;
  Trial run = s.trial(of("left", "velocity", Vec3(v1, 0, 0)) + of("right", "velocity", Vec3(v2, 0, 0)) +
                      of("right", "mass", m2) + of("right", "position", "0.6 0 0") + restitution(e));
  run.run(s.steps(0.3));
  return {{"speed of the first ball after the impact [m/s]", run.body("left").v.x(),
           (m1 * v1 + m2 * v2 - e * m2 * (v1 - v2)) / (m1 + m2)},
          {"speed of the second ball after the impact [m/s]", run.body("right").v.x(),
           (m1 * v1 + m2 * v2 + e * m1 * (v1 - v2)) / (m1 + m2)}};
}

std::vector<Quantity> cradle(const Setting& s) {
  const double v = s["speed"];
  Trial run = s.trial(of("ball1", "velocity", Vec3(v, 0, 0)));
  run.run(s.steps(0.2));
  return {{"speed of the first ball [m/s]", run.body("ball1").v.x(), -v / 3},
          {"speed of the second ball [m/s]", run.body("ball2").v.x(), 2 * v / 3},
          {"speed of the third ball [m/s]", run.body("ball3").v.x(), 2 * v / 3}};
}

std::vector<Quantity> cannon(const Setting& s) {
  const double ratio = s["ratio"], v = s["speed"];
  const std::array<double, 3> mass{100, 100 / ratio, 100 / ratio / ratio};
  scene::Overrides changes;
  for (std::size_t k = 0; k < mass.size(); ++k) {
    const std::string name = "ball" + std::to_string(k + 1);
    changes = changes + of(name, "mass", mass[k]) + of(name, "velocity", Vec3(0, 0, -v));
  }
  Trial run = s.trial(changes);
  run.run(s.steps(0.6));
  // The impacts come one after another: the ball that rebounds meets the next, which still falls.
  double up = v;
  for (std::size_t k = 0; k + 1 < mass.size(); ++k)
    up = (2 * mass[k] * up + (mass[k] - mass[k + 1]) * v) / (mass[k] + mass[k + 1]);
  return {{"speed of the lightest ball [m/s]", run.body("ball3").v.z(), up}};
}

std::vector<Quantity> end_of_a_rod(const Setting& s) {
  const double angle = s["angle_deg"] * k_deg, e = s["e"], v = s["speed"], length = 2, thick = 0.01, mass = 2;
  const double height =
      0.5 * (length * std::sin(angle) + thick * std::cos(angle)) + (1 - s.theta()) * s.h() * v - k_met;
  Trial run =
      s.trial(of("rod", "rotation_deg", Vec3(0, s["angle_deg"], 0)) + of("rod", "position", Vec3(0, 0, height)) +
              of("rod", "velocity", Vec3(0, 0, -v)) + restitution(e) + gravity(Vec3::Zero()));
  run.step();
  const double arm = 0.5 * (length * std::cos(angle) - thick * std::sin(angle));
  const double inertia = mass * (length * length + thick * thick) / 12;
  const double impulse = mass * (1 + e) * v / (1 + mass * arm * arm / inertia);
  const BodyState rod = run.body("rod");
  return {{"impulse [N s]", run.contact_force_on("rod").z() * s.h(), impulse},
          {"upward speed after the impact [m/s]", rod.v.z(), impulse / mass - v, v},
          {"spin after the impact [rad/s]", rod.w.y(), -impulse * arm / inertia}};
}

std::vector<Quantity> rocking(const Setting& s) {
  const double width = s["width"], height = 1, spin = 0.5;
  const Vec3 velocity(0.5 * spin * height, 0, -0.5 * spin * width), flat(0, 0, 0.5 * height);
  const double early = (1 - s.theta()) * s.h();  // The block stands flat where the impulses act.
  Trial run =
      s.trial(of("block", "size", Vec3(width, 1, height)) + of("block", "position", flat - early * velocity) +
              of("block", "rotation_deg", Vec3(0, -early * spin / k_deg, 0)) + of("block", "velocity", velocity) +
              of("block", "angular_velocity", Vec3(0, spin, 0)) + friction(5) + gravity(Vec3::Zero()));
  run.step();
  const double sine = width / std::hypot(width, height);
  return {{"spin after the impact over that before it", run.body("block").w.y() / spin, 1 - 1.5 * sine * sine}};
}

std::vector<Quantity> break_shot(const Setting& s) {
  const double v = s["speed"];
  Trial run = s.trial(of("cue", "velocity", Vec3(v, 0, 0)));
  run.run(s.steps(0.3));
  Vec3 momentum = Vec3::Zero();
  double energy = 0;
  for (const char* name : {"cue", "apex", "left", "right"}) {
    const BodyState ball = run.body(name);
    momentum += ball.mass * ball.v;
    energy += 0.5 * ball.mass * ball.v.squaredNorm();
  }
  const Vec3 left = run.body("left").v, right = run.body("right").v;
  return {{"change of the total momentum [N s]", (momentum - Vec3(2 * v, 0, 0)).norm(), 0, 2 * v},
          {"total energy over that before the break", energy / (v * v), 1},
          {"difference of the left and the mirrored right ball [m/s]",
           (left - Vec3(right.x(), -right.y(), right.z())).norm(), 0, v},
          {"the left ball moves (1: yes)", left.norm() > 0.1 * v ? 1.0 : 0.0, 1}};
}

std::vector<Quantity> ship_and_floe(const Setting& s) {
  const double ship = 1e7, floe = s["floe_mass"], v = 2;
  Trial run = s.trial(of("left", "mass", ship) + of("left", "velocity", Vec3(v, 0, 0)) + of("right", "mass", floe) +
                      of("right", "position", "0.5 0 0") + of("left", "position", "-0.5 0 0"));
  run.step();
  const double after = ship * v / (ship + floe);
  return {{"common speed [m/s]", run.body("right").v.x(), after},
          {"impulse [N s]", run.contact_force_on("right").x() * s.h(), floe * after}};
}

}  // namespace

std::vector<Case> impacts() {
  FamilyOfCases add('E', "ball.xml", "Newton's law of restitution and conservation of momentum");
  const Input e{"e", 0.8, ""}, speed{"speed", 2, "m/s"};
  add(51, "Bouncing ball", "u+ = -e u-; at rest after sqrt(2 h0/g) (1 + e)/(1 - e)", {e, {"drop", 0.5, "m"}}, "drop",
      bounces)
      .reference = true;
  Case& elastic = add(52, "Elastic ball, 1e4 bounces", "no height is gained or lost", {{"drop", 0.05, "m"}}, "drop",
                      elastic_bounces);
  elastic.integrators = {"moreau"};
  elastic.solvers = {"auto"};
  elastic.source = "The theta scheme with theta = 0.5 is symmetric in time";
  add(53, "Central impact of two balls", "v1' = (m1 v1 + m2 v2 - e m2 (v1 - v2))/(m1 + m2)",
      {e, speed, {"mass", 3, "kg"}}, "mass", central_hit)
      .scene = "pair.xml";
  add(54, "Newton's cradle, simultaneous impacts", "(-1/3, 2/3, 2/3) v: Newton's law at each contact, solved together",
      {speed}, "speed", cradle)
      .scene = "cradle.xml";
  add(55, "Galilean cannon, successive impacts of pairs",
      "v_k+1' = (2 m_k v_k' + (m_k - m_k+1) v)/(m_k + m_k+1), up to (2^n - 1) v",
      {{"ratio", 10, ""}, {"speed", 1, "m/s"}}, "ratio", cannon)
      .scene = "cannon.xml";
  add(56, "Impact of the end of a falling rod", "J = m (1 + e) v/(1 + m x^2/I)",
      {{"angle_deg", 30, "deg"}, {"e", 0.5, ""}, speed}, "angle_deg", end_of_a_rod)
      .scene = "rod.xml";
  Case& housner = add(57, "Rocking block, from edge to edge", "w'/w = 1 - 3/2 sin^2(alpha), tan(alpha) = b/h",
                      {{"width", 0.3, "m"}}, "width", rocking);
  housner.scene = "block.xml";
  housner.source = "Housner 1963";
  add(59, "Billiard break", "momentum and energy are conserved, and the motion stays mirror symmetric", {speed},
      "speed", break_shot)
      .scene = "break.xml";
  Case& ship = add(60, "Inelastic impact of a ship on a floe", "v' = M V/(M + m), impulse m v'",
                   {{"floe_mass", 1000, "kg"}}, "floe_mass", ship_and_floe);
  ship.scene = "pair.xml";
  ship.note = "Added mass is left out, because scenes do not have it.";
  return add.cases();
}

}  // namespace nilas::verify
