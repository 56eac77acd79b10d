/// Family B: rolling and spinning.
#include <cmath>

#include "apps/verify/families.h"
#include "apps/verify/recurrences.h"
#include "apps/verify/scene_changes.h"

namespace nilas::verify {

namespace {

constexpr double k_radius = 0.5, k_mass = 2;  // radius [m] and mass [kg] of ball, roller and disc in their scenes

/// A round body: its scene and its inertia about the rolling axis, as the share I/(m r^2).
struct Round {
  const char* scene;
  const char* body;
  const char* name;
  double share;
};
constexpr Round k_ball{"ball.xml", "ball", "ball", 0.4}, k_cylinder{"roller.xml", "roller", "cylinder", 0.5},
    k_hoop{"roller.xml", "roller", "hoop", 1};

Trial rolled(const Setting& s, const Round& round, const scene::Overrides& changes) {
  scene::Overrides all = changes;
  const double axial = round.share * k_mass * k_radius * k_radius;
  if (round.body == std::string("roller"))
    all = all + of("roller", "inertia", text(axial) + " " + text(axial) + " " + text(axial) + " 0 0 0");
  return s.trial_of(round.scene, all);
}

void slide_into_rolling(const Setting& s, const Round& round, std::vector<Quantity>& found) {
  const double v0 = s["speed"], last = v0 / (1 + round.share), change = s["mu"] * k_gravity * s.h();
  Trial run = rolled(s, round, of(round.body, "velocity", Vec3(v0, 0, 0)) + friction(s["mu"]));
  const long n = static_cast<long>((v0 - last) / change) + 10;
  run.run(n);
  const BodyState body = run.body(round.body);
  const auto speed = [&](long k) { return std::max(last, v0 - static_cast<double>(k) * change); };
  const std::string name = round.name;
  const double slid = (v0 - last) / (s["mu"] * k_gravity);  // [s]
  const double distance = s.model().continuous()
                              ? 0.5 * (v0 + last) * slid + last * (static_cast<double>(n) * s.h() - slid)
                              : travel(n, s.h(), s.theta(), speed);
  found.push_back({name + ", speed when rolling [m/s]", body.v.x(), last});
  found.push_back({name + ", surface speed when rolling [m/s]", body.w.y() * k_radius, last});
  found.push_back({name + ", distance [m]", body.p.x(), distance});
  found.push_back({name + ", share of energy lost", 1 - run.last().ledger.kinetic / (0.5 * k_mass * v0 * v0),
                   round.share / (1 + round.share)});
}

std::vector<Quantity> ball_slides(const Setting& s) {
  std::vector<Quantity> found;
  slide_into_rolling(s, k_ball, found);
  return found;
}

std::vector<Quantity> rollers_slide(const Setting& s) {
  std::vector<Quantity> found;
  slide_into_rolling(s, k_cylinder, found);
  slide_into_rolling(s, k_hoop, found);
  return found;
}

std::vector<Quantity> spun_ball(const Setting& s) {
  const double last = 2.0 / 7 * k_radius * s["spin"], change = s["mu"] * k_gravity * s.h();
  Trial run = s.trial(of("ball", "velocity", "0 0 0") + of("ball", "angular_velocity", Vec3(0, s["spin"], 0)) +
                      friction(s["mu"]));
  const long n = static_cast<long>(last / change) + 10;
  run.run(n);
  const BodyState ball = run.body("ball");
  const auto speed = [&](long k) { return std::min(last, static_cast<double>(k) * change); };
  return {{"speed when rolling [m/s]", ball.v.x(), last},
          {"distance [m]", ball.p.x(), travel(n, s.h(), s.theta(), speed)}};
}

std::vector<Quantity> masse(const Setting& s) {
  const Vec3 v0(s["speed"], 0, 0), w0(s["side_spin"], s["spin"], 5);
  const Vec3 slip = v0 + w0.cross(-k_radius * Vec3::UnitZ());
  const double change = s["mu"] * k_gravity * s.h();
  const long n = static_cast<long>(2.0 / 7 * slip.norm() / change) + 10;
  Trial run = s.trial(of("ball", "velocity", v0) + of("ball", "angular_velocity", w0) + friction(s["mu"]));
  run.run(n);
  // In each step friction reduces the slip by as much as it can, along the slip (coulomb) or each tangent (pyramid).
  const auto velocity = [&](long k) -> Vec3 {
    const double can = static_cast<double>(k) * change;
    if (s.model().law != "pyramid") return v0 - std::min(can, 2.0 / 7 * slip.norm()) * slip.normalized();
    Vec3 v = v0;
    for (int axis = 0; axis < 2; ++axis)
      v[axis] -= std::copysign(std::min(can, 2.0 / 7 * std::abs(slip[axis])), slip[axis]);
    return v;
  };
  const BodyState ball = run.body("ball");
  const Vec3 distance = travel(n, s.h(), s.theta(), velocity), last = velocity(n);
  return {{"final speed along X [m/s]", ball.v.x(), last.x()},
          {"final speed along Y [m/s]", ball.v.y(), last.y()},
          {"distance along X [m]", ball.p.x(), distance.x()},
          {"distance along Y [m]", ball.p.y(), distance.y()}};
}

std::vector<Quantity> down_a_slope(const Setting& s) {
  const double slope = s["slope_deg"] * k_deg;
  const long n = s.steps(0.5);
  const double t = static_cast<double>(n) * s.h();
  std::vector<Quantity> found;
  for (const Round& round : {k_ball, k_cylinder, k_hoop}) {
    const double limit = round.share / (1 + round.share) * std::tan(slope);
    for (const double mu : {1.01 * limit, 0.5 * limit}) {
      Trial run = rolled(s, round,
                         of(round.body, "velocity", "0 0 0") + friction(mu) +
                             gravity(k_gravity * Vec3(std::sin(slope), 0, -std::cos(slope))));
      run.run(n);
      const bool rolls = mu >= limit;
      const double a = rolls ? k_gravity * std::sin(slope) / (1 + round.share)
                             : k_gravity * (std::sin(slope) - mu * std::cos(slope));
      const double turning = rolls ? a / k_radius : mu * k_gravity * std::cos(slope) / (round.share * k_radius);
      const std::string name = std::string(round.name) + (rolls ? " rolls" : " slides");
      const BodyState body = run.body(round.body);
      found.push_back({name + ", speed [m/s]", body.v.x(), a * t});
      found.push_back({name + ", spin [rad/s]", body.w.y(), turning * t});
    }
  }
  return found;
}

scene::Overrides resisting(double rolling_length, double spinning_length) {
  return {{"contact/friction[1]/@rolling", text(rolling_length)},
          {"contact/friction[1]/@spinning", text(spinning_length)}};
}

std::vector<Quantity> rolling_resistance(const Setting& s) {
  const double v0 = s["speed"], change = 5.0 / 7 * s["length"] / k_radius * k_gravity * s.h();
  Trial run =
      s.trial(of("ball", "velocity", Vec3(v0, 0, 0)) + of("ball", "angular_velocity", Vec3(0, v0 / k_radius, 0)) +
              friction(0.5) + resisting(s["length"], 0));
  run.run(static_cast<long>(v0 / change) + 5);
  std::vector<Quantity> found{
      {"distance to rest [m]", run.body("ball").p.x(), stopping_distance(v0, change, s.h(), s.theta())},
      {"speed at rest [m/s]", run.body("ball").v.norm(), 0, 1}};
  for (const double side : {0.999, 1.001}) {
    const double slope = std::atan(side * s["length"] / k_radius);
    Trial on_slope = s.trial(of("ball", "velocity", "0 0 0") + friction(0.5) + resisting(s["length"], 0) +
                             gravity(k_gravity * Vec3(std::sin(slope), 0, -std::cos(slope))));
    on_slope.run(10);
    const double a = 5.0 / 7 * k_gravity * (std::sin(slope) - s["length"] / k_radius * std::cos(slope));
    found.push_back({side < 1 ? "speed on a slope of 0.999 length/r [m/s]" : "speed on a slope of 1.001 length/r [m/s]",
                     on_slope.body("ball").v.x(), side < 1 ? 0 : 10 * s.h() * a, 1});
  }
  return found;
}

std::vector<Quantity> spinning_resistance(const Setting& s) {
  const double w0 = s["spin"], change = 5 * s["length"] * k_gravity / (2 * k_radius * k_radius) * s.h();
  const auto half = static_cast<long>(0.5 * w0 / change);
  Trial run = s.trial(of("ball", "velocity", "0 0 0") + of("ball", "angular_velocity", Vec3(0, 0, w0)) + friction(0.3) +
                      resisting(0, s["length"]));
  run.run(half);
  const double after = run.body("ball").w.z();
  run.run(half + 5);
  return {{"spin half-way to rest [rad/s]", after, w0 - static_cast<double>(half) * change},
          {"spin at rest [rad/s]", run.body("ball").w.norm(), 0, 1}};
}

std::vector<Quantity> spinning_disc(const Setting& s) {
  const double change = 2 * s["mu"] * k_gravity / k_radius * s.h();
  const auto half = static_cast<long>(0.5 * s["spin"] / change);
  Trial run = s.trial(of("disc", "angular_velocity", Vec3(0, 0, s["spin"])) + friction(s["mu"]));
  run.run(half);
  const double after = run.body("disc").w.z();
  run.run(half + 5);
  return {{"spin half-way to rest [rad/s]", after, s["spin"] - static_cast<double>(half) * change},
          {"spin at rest [rad/s]", run.body("disc").w.norm(), 0, 1}};
}

/// The velocity [m/s] and the spin [rad/s] of the plate after one step: m (v' - v) = -h sum mu N_i u_i/|u_i| with
/// u_i = v' + w' z x r_i. The loads N_i also carry the moment of friction at the floor, k_height below the centre of
/// mass.
struct PlateStep {
  Vec2 v;
  double w;
};
PlateStep plate_step(const Vec2& v, double w, double turned, double mu, double h) {
  constexpr double k_inertia = 0.25, k_height = 0.1;
  constexpr int k_passes = 200;  // Each pass reduces the error by a factor of about mu g h over the slip.
  PlateStep after{v, w};
  Vec2 force = Vec2::Zero();
  for (int pass = 0; pass < k_passes; ++pass) {
    Vec2 sum = Vec2::Zero();
    double couple = 0;
    for (int i = 0; i < 3; ++i) {
      const Vec3 out = heading(turned / k_deg + 120 * i);
      const Vec2 arm = k_radius * out.head<2>(), slip = after.v + after.w * Vec2(-arm.y(), arm.x());
      const double load = k_mass * k_gravity / 3 - 2.0 / 3 * k_height / k_radius * force.dot(out.head<2>());
      const Vec2 friction = -mu * load * slip.normalized();
      sum += friction;
      couple += arm.x() * friction.y() - arm.y() * friction.x();
    }
    force = sum;
    after = {v + h / k_mass * force, w + h / k_inertia * couple};
  }
  return after;
}

std::vector<Quantity> lubricated(const Setting& s) {
  const double spin = s["spin"], v0 = s["ratio"] * k_radius * spin;
  Trial run = s.trial(of("plate", "velocity", Vec3(v0, 0, 0)) + of("plate", "angular_velocity", Vec3(0, 0, spin)) +
                      of("plate", "inertia", "0.25 0.25 0.25 0 0 0") + friction(s["mu"]));
  PlateStep exact{{v0, 0}, spin};
  double turned = 0;
  for (int k = 0; k < 10; ++k) {
    run.step();
    turned += (1 - s.theta()) * s.h() * exact.w;
    exact = plate_step(exact.v, exact.w, turned, s["mu"], s.h());
    turned += s.theta() * s.h() * exact.w;
  }
  const BodyState plate = run.body("plate");
  return {{"speed lost in 10 steps [m/s]", v0 - plate.v.x(), v0 - exact.v.x()},
          {"speed across [m/s]", plate.v.y(), exact.v.y(), v0 - exact.v.x()},
          {"spin [rad/s]", plate.w.z(), exact.w}};
}

std::vector<Quantity> oblique_bounce(const Setting& s) {
  constexpr double k_depth = 1e-13;  // depth at which the ball touches [m]
  const double e = s["e"], mu = s["mu"], down = s["approach"];
  std::vector<Quantity> found;
  for (const double share : {0.5, 2.0}) {
    const double along = share * 3.5 * mu * (1 + e) * down;
    // The ball starts so high that it touches where the step's impulses act.
    const double height = k_radius + (1 - s.theta()) * s.h() * down - k_depth;
    Trial run = s.trial(of("ball", "position", Vec3(0, 0, height)) + of("ball", "velocity", Vec3(along, 0, -down)) +
                        friction(mu) + restitution(e) + gravity(Vec3::Zero()));
    run.step();
    const bool slips = share > 1;
    const double after = slips ? along - mu * (1 + e) * down : 5.0 / 7 * along;
    const double spin = slips ? 5 * mu * (1 + e) * down / (2 * k_radius) : after / k_radius;
    const std::string name = slips ? "slipping" : "gripping";
    const BodyState ball = run.body("ball");
    found.push_back({name + ", speed along the floor [m/s]", ball.v.x(), after});
    found.push_back({name + ", upward speed [m/s]", ball.v.z(), e * down});
    found.push_back({name + ", spin [rad/s]", ball.w.y(), spin});
  }
  return found;
}

}  // namespace

std::vector<Case> rolling() {
  const Input mu{"mu", 0.2, ""}, speed{"speed", 3, "m/s"}, spin{"spin", 20, "rad/s"};
  const std::vector<std::string> with_moments{"auto", "nsgs"};
  const std::string moments_note = "Left out: solvers that do not support rolling and spinning friction.";
  FamilyOfCases add('B', "ball.xml", "Momentum and Coulomb's law, summed over the steps");
  add(14, "Ball that slides, then rolls", "v_k = max(5 v0/7, v0 - k mu g h); 2/7 of the energy is lost", {speed, mu},
      "speed", ball_slides)
      .reference = true;
  add(15, "Cylinder and hoop that slide, then roll",
      "v_k = max(v0/(1 + b), v0 - k mu g h), b = I/(m r^2): 1/2, 1; b/(1 + b) of the energy is lost", {speed, mu}, "mu",
      rollers_slide)
      .scene = "roller.xml";
  add(16, "Ball released spinning", "v_k = min(k mu g h, 2 r w0/7)", {spin, mu}, "spin", spun_ball);
  add(17, "Masse shot of a billiard ball",
      "slip u0 = v0 + w0 x (-r z) keeps its direction, v = v0 - min(k mu g h, 2/7 |u0|) u0/|u0|; pyramid: each axis "
      "separately",
      {speed, {"side_spin", 12, "rad/s"}, {"spin", -10, "rad/s"}, mu}, "side_spin", masse)
      .laws = {"coulomb", "pyramid"};
  add(18, "Ball, cylinder and hoop down a slope",
      "rolls iff mu >= b/(1 + b) tan a, then a = g sin a/(1 + b); else a = g (sin a - mu cos a), w' = mu g cos a/(b r)",
      {{"slope_deg", 25, "deg"}}, "slope_deg", down_a_slope)
      .also = {"roller.xml"};
  Case& with_rolling =
      add(19, "Rolling resistance of a ball", "a = 5/7 (length/r) g; rests on a slope iff tan a <= length/r",
          {{"speed", 1, "m/s"}, {"length", 0.02, "m"}}, "length", rolling_resistance);
  with_rolling.solvers = with_moments;
  with_rolling.note = moments_note;
  Case& with_spinning = add(20, "Spinning resistance of a ball", "w' = -5 length g/(2 r^2)",
                            {spin, {"length", 0.03, "m"}}, "length", spinning_resistance);
  with_spinning.solvers = with_moments;
  with_spinning.note = moments_note;
  Case& disc = add(21, "Disc spinning on its rim", "w' = -2 mu g/R", {spin, mu}, "mu", spinning_disc);
  disc.scene = "disc.xml";
  Case& plate =
      add(23, "Drag of a plate that spins much faster than it slides",
          "m (v' - v) = -h sum mu N_i u_i/|u_i| over three corners; for v << R w the drag is mu m g v/(2 R w)",
          {spin, {"ratio", 0.1, ""}, mu}, "spin", lubricated);
  plate.scene = "tripod.xml";
  add(25, "Oblique bounce of a ball",
      "slips iff mu (1 + e) v_n < 2/7 v_t: v_t' = v_t - mu (1 + e) v_n, w' = 5 mu (1 + e) v_n/(2 r); else v_t' = 5/7 "
      "v_t",
      {{"approach", 2, "m/s"}, {"e", 0.6, ""}, mu}, "approach", oblique_bounce);
  return add.cases();
}

}  // namespace nilas::verify
