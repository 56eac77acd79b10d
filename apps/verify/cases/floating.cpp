/// Family F: floating bodies.
#include <cmath>

#include "apps/verify/families.h"
#include "apps/verify/scene_changes.h"

namespace nilas::verify {

namespace {

constexpr double k_water = 1025, k_fresh = 1000;  // densities of the scenes' water [kg/m^3]

scene::Overrides floating_ice(double density, double thickness) {
  return {{"ice/@density", text(density)}, {"ice/@thickness", text(thickness)}};
}

/// A linear oscillation, stepped by the theta scheme.
struct Oscillation {
  double x, v;
  void step(const Setting& s, double omega) {
    x += (1 - s.theta()) * s.h() * v;
    v -= s.h() * omega * omega * x;
    x += s.theta() * s.h() * v;
  }
};

std::vector<Quantity> draught(const Setting& s) {
  const double t = s["thickness"], ratio = s["density"] / k_water;
  Trial run = s.trial(floating_ice(s["density"], t));
  const double centre = run.body("floe").p.z();
  run.run(s.steps(1));
  const BodyState floe = run.body("floe");
  return {{"draught at the start [m]", 0.5 * t - centre, t * ratio},
          {"freeboard after 1 s [m]", floe.p.z() + 0.5 * t, t * (1 - ratio)},
          {"speed after 1 s [m/s]", floe.v.norm(), 0, 1}};
}

std::vector<Quantity> heave(const Setting& s) {
  const double t = s["thickness"], draught = t * s["density"] / k_water, offset = 0.02;
  Trial run = s.trial(floating_ice(s["density"], t) + scene::Overrides{{"ice/floe[1]/@z", text(offset)}});
  Oscillation exact{offset, 0};
  double worst = 0;
  for (long k = 0; k < s.steps(5); ++k) {
    run.step();
    const double omega = std::sqrt(k_gravity / draught);
    if (s.model().continuous())
      exact.x = offset * std::cos(omega * static_cast<double>(k + 1) * s.h());
    else
      exact.step(s, omega);
    worst = std::max(worst, std::abs(run.body("floe").p.z() - (0.5 * t - draught) - exact.x));
  }
  return {{"largest error of the heave in 5 s [m]", worst, 0, offset},
          {"heave after 5 s [m]", run.body("floe").p.z() - (0.5 * t - draught), exact.x, offset}};
}

std::vector<Quantity> free_roll(const Setting& s) {
  const double length = 3, beam = s["beam"], t = 1, ratio = 0.9, draught = ratio * t, angle = 1e-5;
  const double mass = ratio * k_fresh * length * beam * t;
  const double metacentric = 0.5 * draught + beam * beam / (12 * draught) - 0.5 * t;
  const auto with = [&](double wide) {
    return s.trial(of("raft", "size", Vec3(length, wide, t)) + of("raft", "position", Vec3(0, 0, 0.5 * t - draught)) +
                   of("raft", "rotation_deg", Vec3(0, 0, angle / k_deg)));
  };
  Trial run = with(beam);
  Oscillation exact{angle, 0};
  const double inertia = mass * (beam * beam + t * t) / 12;
  double worst = 0;
  for (long k = 0; k < s.steps(5); ++k) {
    run.step();
    exact.step(s, std::sqrt(mass * k_gravity * metacentric / inertia));
    worst = std::max(worst, std::abs(2 * run.body("raft").q.x() - exact.x));
  }
  std::vector<Quantity> found{{"largest error of the roll in 5 s [rad]", worst, 0, angle}};
  const double limit = std::sqrt(6 * ratio * (1 - ratio)) * t;
  for (const double share : {1.01, 0.99}) {
    Trial narrow = with(share * limit);
    narrow.run(s.steps(5));
    const bool falls = std::abs(2 * narrow.body("raft").q.x()) > 1.5 * angle;
    found.push_back({share > 1 ? "unstable at 1.01 of b/t = sqrt(6 r (1 - r)) (1: yes)"
                               : "unstable at 0.99 of b/t = sqrt(6 r (1 - r)) (1: yes)",
                     falls ? 1.0 : 0.0, share > 1 ? 0.0 : 1.0, 1});
  }
  return found;
}

std::vector<Quantity> coast(const Setting& s) {
  const double form = s["form"], v0 = s["speed"], area = 0.5, mass = 1000;
  Trial run = s.trial(of("box", "velocity", Vec3(v0, 0, 0)) + scene::Overrides{{"hydro/drag/@form", text(form)}});
  const long n = s.steps(5);
  run.run(n);
  const double k = k_fresh * form * area / (2 * mass);
  double v = v0, x = 0;
  for (long i = 0; i < n; ++i) {
    x += (1 - s.theta()) * s.h() * v;
    v -= s.h() * k * v * v;
    x += s.theta() * s.h() * v;
  }
  const double t = static_cast<double>(n) * s.h();
  if (s.model().continuous()) {
    v = v0 / (1 + k * v0 * t);
    x = std::log(1 + k * v0 * t) / k;
  }
  const BodyState box = run.body("box");
  std::vector<Quantity> found{{"speed after 5 s, quadratic drag [m/s]", box.v.x(), v},
                              {"distance after 5 s, quadratic drag [m]", box.p.x(), x}};
  const double coefficient = 50 * form;
  Trial linear = s.trial_of("driven-floe.xml", {{"hydro/virtual_drag/@coefficient", text(coefficient)},
                                                {"ice/floe[1]/@velocity", text(Vec3(v0, 0, 0))}});
  linear.run(n);
  const BodyState floe = linear.body("floe");
  found.push_back(
      {"speed after 5 s, linear drag [m/s]", floe.v.x(),
       v0 * (s.model().continuous() ? std::exp(-coefficient / floe.mass * t)
                                    : std::pow(1 - s.h() * coefficient / floe.mass, static_cast<double>(n)))});
  return found;
}

std::vector<Quantity> steady_push(const Setting& s) {
  const double speed = s["speed"], drag = 100;
  Trial run = s.trial({{"vessel/carriage/@speed", text(speed)}});
  run.run(s.steps(5));
  std::vector<Quantity> found;
  const std::vector<std::string> names{"barge", "floe1", "floe2", "floe3"};
  for (std::size_t k = 0; k + 1 < names.size(); ++k)
    found.push_back({"force of " + names[k] + " on " + names[k + 1] + " [N]",
                     run.force_between(names[k], names[k + 1]).x(), static_cast<double>(3 - k) * drag * speed});
  found.push_back({"load of the carriage [N]", run.last().vessel->carriage->about_com.force.x(), 3 * drag * speed});
  return found;
}

std::vector<Quantity> sloping_hull(const Setting& s) {
  const double angle = s["angle_deg"] * k_deg, mu = s["mu"];
  const Vec3 normal(std::sin(angle), 0, std::cos(angle));
  const std::string turned = "0 " + text(s["angle_deg"]) + " 0";
  Trial run = s.trial(of("floor", "rotation_deg", turned) + of("block", "rotation_deg", turned) +
                      of("block", "position", Vec3(0.1 * normal)) + of("block", "velocity", "0 0 0") + friction(mu) +
                      gravity({-k_gravity, 0, 0}));
  run.run(10);
  const Vec3 load = run.contact_force_on("block");
  return {{"vertical load over horizontal load", load.z() / load.x(),
           (std::cos(angle) - mu * std::sin(angle)) / (std::sin(angle) + mu * std::cos(angle))},
          {"slides up (1: yes)", run.body("block").v.z() > 0.01 ? 1.0 : 0.0, 1}};
}

}  // namespace

std::vector<Case> floating() {
  FamilyOfCases add('F', "floe.xml", "Archimedes");
  const std::vector<std::string> no_contact{"auto"};
  const Input density{"density", 917, "kg/m^3"}, thickness{"thickness", 1, "m"}, speed{"speed", 2, "m/s"};
  Case& still = add(61, "Floe at rest", "draught = t rho_ice/rho_water", {density, thickness}, "thickness", draught);
  still.solvers = no_contact;
  Case& up = add(62, "Heaving floe", "omega = sqrt(g/draught), stepped by the theta scheme; no added mass",
                 {density, thickness}, "thickness", heave);
  up.solvers = no_contact;
  up.reference = true;
  Case& rolls = add(63, "Rolling raft, and whether it floats upright",
                    "omega = sqrt(m g GM/I), GM = d/2 + b^2/(12 d) - t/2; upright iff b/t > sqrt(6 r (1 - r))",
                    {{"beam", 2, "m"}}, "beam", free_roll);
  rolls.scene = "raft.xml";
  rolls.solvers = no_contact;
  rolls.tolerance = 1e-8;
  rolls.note =
      "The formula holds for small angles. At the 1e-5 rad used here its own error is about 1e-10 of the angle.";
  Case& coasts = add(64, "Coasting against drag", "v' = v - h k v^2, k = rho C A/(2 m); v' = v (1 - h c/m)",
                     {speed, {"form", 1, ""}}, "form", coast);
  coasts.scene = "submerged.xml";
  coasts.also = {"driven-floe.xml"};
  coasts.solvers = no_contact;
  coasts.reference = true;
  coasts.source = "Quadratic and linear drag, summed over the steps";
  Case& pushes = add(65, "Steady push of a row of floes", "force at each contact = drag of all floes ahead of it",
                     {{"speed", 0.5, "m/s"}}, "speed", steady_push);
  pushes.scene = "push.xml";
  pushes.source = "Statics";
  pushes.solvers = {"auto", "pgs", "nsgs", "eg", "eg-order-free", "apgd", "admm", "ipm", "newton"};
  pushes.note = "Left out: enumerate (more than 8 contacts).";
  Case& hull =
      add(66, "Floe on a sloping hull", "vertical load over horizontal load = (cos a - mu sin a)/(sin a + mu cos a)",
          {{"angle_deg", 50, "deg"}, {"mu", 0.1, ""}}, "angle_deg", sloping_hull);
  hull.scene = "block.xml";
  hull.source = "Coulomb's law";
  return add.cases();
}

}  // namespace nilas::verify
