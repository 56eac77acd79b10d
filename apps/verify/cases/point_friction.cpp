/// Family A: sliding, sticking and the artefact of each friction law.
#include <cmath>

#include "apps/verify/families.h"
#include "apps/verify/recurrences.h"
#include "apps/verify/scene_changes.h"
#include "apps/verify/setting.h"

namespace nilas::verify {

namespace {

/// Turns floor and block about Y by `degrees`, downhill along +X, and gives the block this speed downhill [m/s].
scene::Overrides on_slope(double degrees, double speed) {
  const Vec3 up(std::sin(degrees * k_deg), 0, std::cos(degrees * k_deg));
  const Vec3 down(std::cos(degrees * k_deg), 0, -std::sin(degrees * k_deg));
  const std::string turn = "0 " + text(degrees) + " 0";
  return scene::Overrides{{"body[@name='floor']/@rotation_deg", turn}, {"body[@name='block']/@rotation_deg", turn}} +
         of("block", "position", 0.1 * up) + of("block", "velocity", speed * down);
}

scene::Overrides moving(const Vec3& velocity) { return of("block", "velocity", velocity); }

std::vector<Quantity> threshold(const Setting& s) {
  constexpr double k_near = 1e-6;
  const double angle = s["slope_deg"], steep = std::tan(angle * k_deg);
  const long n = s.steps(0.5);
  std::vector<Quantity> found;
  for (const double side : {1.0, -1.0}) {
    const double mu = steep * (1 + side * k_near);
    Trial run = s.trial(on_slope(angle, 0) + friction(mu));
    run.run(n);
    const double a = k_gravity * (std::sin(angle * k_deg) - mu * std::cos(angle * k_deg));
    found.push_back(
        {side > 0 ? "speed at mu = tan(slope) (1 + 1e-6) [m/s]" : "speed at mu = tan(slope) (1 - 1e-6) [m/s]",
         run.body("block").v.norm(), side > 0 ? 0 : static_cast<double>(n) * s.h() * a, 1});
  }
  return found;
}

std::vector<Quantity> slide(const Setting& s) {
  const double angle = s["slope_deg"] * k_deg, n = static_cast<double>(s.steps(1));
  Trial run = s.trial(on_slope(s["slope_deg"], 0) + friction(s["mu"]));
  const Vec3 start = run.body("block").p;
  run.run(s.steps(1));
  const double a = k_gravity * (std::sin(angle) - s["mu"] * std::cos(angle));
  const BodyState block = run.body("block");
  return {{"speed after 1 s [m/s]", block.v.norm(), n * s.h() * a},
          {"distance after 1 s [m]", (block.p - start).norm(), a * s.h() * s.h() * n * (n - 1 + 2 * s.theta()) / 2}};
}

std::vector<Quantity> stop(const Setting& s) {
  Trial run = s.trial(moving({s["speed"], 0, 0}) + friction(s["mu"]));
  const double change = s["mu"] * k_gravity * s.h();
  run.run(static_cast<long>(s["speed"] / change) + 5);
  const BodyState block = run.body("block");
  const double distance = s.model().continuous() ? s["speed"] * s["speed"] / (2 * s["mu"] * k_gravity)
                                                 : stopping_distance(s["speed"], change, s.h(), s.theta());
  return {{"distance to rest [m]", block.p.x(), distance}, {"speed at rest [m/s]", block.v.norm(), 0, 1}};
}

std::vector<Quantity> azimuths(const Setting& s) {
  const double change = s["mu"] * k_gravity * s.h(), distance = stopping_distance(s["speed"], change, s.h(), s.theta());
  double shortest = 1e300, longest = 0, across = 0, turned = 0;
  constexpr int k_directions = 24;
  for (int k = 0; k < k_directions; ++k) {
    const Vec3 along = heading(k * 360.0 / k_directions);
    Trial run = s.trial(moving(s["speed"] * along) + friction(s["mu"]));
    run.run(static_cast<long>(s["speed"] / change) + 5);
    const BodyState block = run.body("block");
    shortest = std::min(shortest, block.p.dot(along));
    longest = std::max(longest, block.p.dot(along));
    across = std::max(across, std::abs(block.p.cross(along).z()));
    turned = std::max(turned, block.q.vec().norm());
  }
  return {{"shortest distance of 24 directions [m]", shortest, distance},
          {"longest distance of 24 directions [m]", longest, distance},
          {"largest distance across [m]", across, 0, 1},
          {"largest rotation [rad]", 2 * turned, 0, 1}};
}

std::vector<Quantity> box_pyramid(const Setting& s) {
  const Vec3 velocity = s["speed"] * heading(s["heading_deg"]);
  const double change = s["mu"] * k_gravity * s.h();
  Trial run = s.trial(moving(velocity) + friction(s["mu"]));
  run.run(static_cast<long>(s["speed"] / change) + 5);
  const Vec3 p = run.body("block").p;
  Vec3 distance(stopping_distance(velocity.x(), change, s.h(), s.theta()),
                stopping_distance(velocity.y(), change, s.h(), s.theta()), 0);
  if (s.model().law != "pyramid")
    distance = stopping_distance(s["speed"], change, s.h(), s.theta()) * heading(s["heading_deg"]);
  return {{"distance along X [m]", p.x(), distance.x()}, {"distance along Y [m]", p.y(), distance.y()}};
}

/// Returns the point of the diamond |x| + |y| <= radius nearest to `to`, which must have x >= y >= 0.
Vec2 in_diamond(const Vec2& to, double radius) {
  if (to.x() + to.y() <= radius) return to;
  const double over = 0.5 * (to.x() + to.y() - radius);
  return to.y() > over ? Vec2(to.x() - over, to.y() - over) : Vec2(radius, 0);
}

std::vector<Quantity> diamond(const Setting& s) {
  const Vec3 velocity = s["speed"] * heading(s["heading_deg"]);
  const double change = s["mu"] * k_gravity * s.h();
  const long n = static_cast<long>(2 * s["speed"] / change);
  Trial run = s.trial(moving(velocity) + friction(s["mu"]));
  run.run(n);
  // The impulse of maximum dissipation is the point of the diamond nearest to the impulse that would stop the block.
  Vec2 v = velocity.head<2>(), distance = Vec2::Zero();
  for (long k = 0; k < n; ++k) {
    const Vec2 after = v - in_diamond(v, change);
    distance += s.h() * ((1 - s.theta()) * v + s.theta() * after);
    v = after;
  }
  const Vec3 p = run.body("block").p;
  return {{"distance along X [m]", p.x(), distance.x()}, {"distance along Y [m]", p.y(), distance.y()}};
}

std::vector<Quantity> facets(const Setting& s) {
  const double sides = std::stod(s.model().law.substr(std::string("pyramid-").size()));
  const double least = std::cos(k_pi / sides), change = s["mu"] * k_gravity * s.h();
  std::vector<Quantity> found;
  for (const bool edge : {true, false}) {
    const Vec3 along = heading(edge ? 0 : 180 / sides);
    Trial run = s.trial(moving(s["speed"] * along) + friction(s["mu"]));
    const long n = static_cast<long>(s["speed"] / change) / 2;
    run.run(n);
    const double mu = (s["speed"] - run.body("block").v.dot(along)) / (static_cast<double>(n) * k_gravity * s.h());
    found.push_back({edge ? "friction towards a corner" : "friction towards the middle of a side", mu,
                     s["mu"] * (edge ? 1 : least)});
  }
  return found;
}

std::vector<Quantity> lift(const Setting& s) {
  const double change = s["mu"] * k_gravity * s.h();
  const long n = s.steps(0.5);
  Trial run = s.trial(moving({s["speed"], 0, 0}) + friction(s["mu"]));
  run.run(n);
  // The convexified law gives u_N = mu |u_T|. The gap and the speeds of each step follow from those of the step before.
  double gap = 0, rising = 0, speed = s["speed"];
  const double share = s.model().law == "ccp" ? s["mu"] : 0;
  for (long k = 0; k < n; ++k) {
    gap += (1 - s.theta()) * s.h() * rising;
    // The normal impulse takes the velocity without contact to u_N, and the friction impulse is mu times it.
    const double wanted_gap = gap / s.h();
    const double normal =
        std::max(0.0, (share * speed - wanted_gap + k_gravity * s.h() - rising) / (1 + share * s["mu"]));
    speed -= s["mu"] * normal;
    rising += normal - k_gravity * s.h();
    gap += s.theta() * s.h() * rising;
  }
  const BodyState block = run.body("block");
  return {{"gap under the block [m]", block.p.z() - 0.1, gap, s["mu"] * s["speed"] * s.h()},
          {"speed [m/s]", block.v.x(), s.model().law == "ccp" ? speed : s["speed"] - static_cast<double>(n) * change}};
}

std::vector<Quantity> oblique_hit(const Setting& s) {
  const double mu = s["mu"], v = s["approach"], w = s["along"];
  Trial run = s.trial(moving({w, 0, -v}) + friction(mu) + gravity(Vec3::Zero()));
  run.step();
  const BodyState block = run.body("block");
  Vec3 after(w - mu * v, 0, 0);
  if (s.model().law == "ccp") after = (w - mu * v) / (1 + mu * mu) * Vec3(1, 0, mu);
  if (w <= mu * v) after.setZero();
  return {{"speed along the floor [m/s]", block.v.x(), after.x(), w},
          {"upward speed [m/s]", block.v.z(), after.z(), w}};
}

std::vector<Quantity> held(const Setting& s) {
  double worst = 0, fastest = 0;
  const double push = s["share"] * s["mu"] * k_gravity;
  constexpr int k_directions = 24;
  for (int k = 0; k < k_directions; ++k) {
    const Vec3 load = push * heading(k * 360.0 / k_directions);
    Trial run = s.trial(moving(Vec3::Zero()) + friction(s["mu"]) + gravity(load - k_gravity * Vec3::UnitZ()));
    run.run(10);
    const BodyState block = run.body("block");
    worst = std::max(worst, (run.contact_force_on("block") / block.mass + load - k_gravity * Vec3::UnitZ()).norm());
    fastest = std::max(fastest, block.v.norm());
  }
  return {{"largest |reaction + load| / mass of 24 directions [m/s^2]", worst, 0, k_gravity},
          {"speed [m/s]", fastest, 0, 1}};
}

std::vector<Quantity> static_and_kinetic(const Setting& s) {
  const long n = s.steps(0.5);
  const auto speed = [&](double start, double share) {
    Trial run = s.trial(moving({start, 0, 0}) +
                        scene::Overrides{{"contact/friction[1]/@static", text(s["mu_static"])},
                                         {"contact/friction[1]/@kinetic", text(s["mu_kinetic"])}} +
                        gravity({share * k_gravity, 0, -k_gravity}));
    run.run(n);
    return run.body("block").v.x();
  };
  const auto won = [&](double share) { return static_cast<double>(n) * s.h() * (share - s["mu_kinetic"]) * k_gravity; };
  const double more = 1.01 * s["mu_static"];
  return {{"speed from rest [m/s]", speed(0, s["share"]), 0, 1},
          {"speed after a nudge [m/s]", speed(s["nudge"], s["share"]), s["nudge"] + won(s["share"])},
          {"speed from rest at 1.01 of the static limit [m/s]", speed(0, more), won(more)}};
}

std::vector<Quantity> straight(const Setting& s) {
  Trial run = s.trial(moving({s["speed"], 0, 0}) + friction(s["mu"]) + of("block", "size", Vec3(3, 2, 2)) +
                      of("block", "position", Vec3(0, 0, 1)));
  double turning = 0, across = 0;
  for (int k = 0; k < 50; ++k) {
    run.step();
    const BodyState block = run.body("block");
    turning = std::max(turning, block.w.norm());
    across = std::max(across, std::abs(block.v.y()));
  }
  return {{"largest angular speed [rad/s]", turning, 0, 1}, {"largest speed across [m/s]", across, 0, 1}};
}

}  // namespace

std::vector<Case> point_friction() {
  const Input mu{"mu", 0.3, ""}, speed{"speed", 2, "m/s"};
  FamilyOfCases add('A', "block.xml", "Coulomb's law, summed over the steps");
  Case& limit =
      add(1, "Block on a slope at the limit of sticking", "rest iff tan(slope) <= mu; else v = n h g (sin - mu cos)",
          {{"slope_deg", 20, "deg"}}, "slope_deg", threshold);
  limit.solvers = {"auto", "newton", "eg", "eg-order-free", "apgd", "admm", "ipm", "enumerate"};
  limit.note =
      "Left out: pgs and nsgs, whose sweeps converge ever more slowly at this limit. After 1e5 sweeps 3e-10 m/s are "
      "left, which these solvers report.";
  add(2, "Block sliding down a slope", "a = g (sin - mu cos), x_n = a h^2 n (n - 1 + 2 theta)/2",
      {{"slope_deg", 30, "deg"}, mu}, "mu", slide);
  add(3, "Stopping distance", "d = sum h ((1 - theta) v_k-1 + theta v_k), v_k = max(0, v0 - k mu g h) -> v0^2/(2 mu g)",
      {speed, mu}, "mu", stop)
      .reference = true;
  add(4, "Stopping distance in 24 directions", "the distance of case 3 in each; no motion across it, no rotation",
      {speed, mu}, "speed", azimuths)
      .step = 0.02;
  add(5, "Sliding at an angle to the tangents",
      "pyramid: x and y each as in case 3, from v0 cos and v0 sin; coulomb: a straight line",
      {speed, {"heading_deg", 30, "deg"}, mu}, "heading_deg", box_pyramid)
      .laws = {"pyramid", "coulomb"};
  add(6, "Diamond of four facets",
      "impulse = point of |x| + |y| <= mu N nearest to the one that stops the block: first along X, then along the "
      "diagonal",
      {speed, {"heading_deg", 30, "deg"}, mu}, "mu", diamond)
      .laws = {"pyramid-4"};
  add(7, "Friction of a k-sided pyramid", "mu towards a corner, mu cos(pi/k) towards the middle of a side", {speed, mu},
      "mu", facets)
      .laws = {"pyramid-4", "pyramid-8", "pyramid-16"};
  add(8, "Hovering of a sliding block", "coulomb: gap 0; ccp: u_N = mu |u_T|, so the block hovers at about h mu v",
      {{"speed", 5, "m/s"}, {"mu", 0.5, ""}}, "speed", lift)
      .laws = {"coulomb", "ccp"};
  add(9, "Oblique inelastic impact of a plate", "coulomb: (w - mu v, 0); ccp: (w - mu v)/(1 + mu^2) (1, mu)",
      {{"along", 3, "m/s"}, {"approach", 2, "m/s"}, mu}, "approach", oblique_hit)
      .laws = {"coulomb", "ccp"};
  add(10, "Reaction on a block that is pushed and held by friction", "r = -load in each of 24 directions, v = 0",
      {mu, {"share", 0.8, ""}}, "share", held);
  add(11, "Static friction above kinetic friction",
      "no motion from rest below mu_s m g; once in motion a = g (share - mu_k)",
      {{"mu_static", 0.4, ""}, {"mu_kinetic", 0.3, ""}, {"share", 0.35, ""}, {"nudge", 0.1, "m/s"}}, "share",
      static_and_kinetic);
  add(13, "Sliding box that does not turn", "w = 0, no speed across", {speed, mu}, "speed", straight);
  return add.cases();
}

}  // namespace nilas::verify
