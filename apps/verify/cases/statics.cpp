/// Family D: statics, stacks, indeterminate contact forces and rates of convergence.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "apps/verify/families.h"
#include "apps/verify/scene_changes.h"

namespace nilas::verify {

namespace {

double fastest(const Trial& run, const std::vector<std::string>& names) {
  double speed = 0;
  for (const auto& name : names) {
    const BodyState body = run.body(name);
    speed = std::max({speed, body.v.norm(), body.w.norm()});
  }
  return speed;
}

/// Returns 1 where the speed [m/s] is above rounding and what a solver leaves, else 0.
double moves(double speed) {
  constexpr double k_rest = 1e-6;  // [m/s]
  return speed > k_rest ? 1 : 0;
}

std::vector<Quantity> column(const Setting& s) {
  const std::vector<std::string> cubes{"cube1", "cube2", "cube3", "cube4", "cube5"};
  scene::Overrides masses;
  for (const auto& cube : cubes) masses = masses + of(cube, "mass", s["mass"]);
  Trial run = s.trial(masses);
  run.run(20);
  std::vector<Quantity> found;
  std::string below = "floor";
  for (std::size_t k = 0; k < cubes.size(); ++k) {
    found.push_back({"force of " + below + " on " + cubes[k] + " [N]", run.force_between(below, cubes[k]).z(),
                     static_cast<double>(cubes.size() - k) * s["mass"] * k_gravity});
    below = cubes[k];
  }
  found.push_back({"largest speed [m/s]", fastest(run, cubes), 0, 1});
  return found;
}

/// Returns the residual after one sweep more, over the residual before it.
double rate_of_sweeps(const Setting& s, const scene::Overrides& changes, int sweeps) {
  std::array<double, 2> residual{};
  for (const int more : {0, 1}) {
    Trial run = s.trial(changes + scene::Overrides{{"contact/@tolerance", "0"},
                                                   {"contact/@max_iterations", std::to_string(sweeps + more)}});
    residual[more] = run.step().residuals.law_map_m_s;
  }
  return residual[1] / residual[0];
}

std::vector<Quantity> sweeps_of_two(const Setting& s) {
  const double ratio = s["ratio"], light = 2;
  return {{"residual after a sweep over that before it",
           rate_of_sweeps(s, of("light", "mass", light) + of("heavy", "mass", ratio * light), 30),
           ratio / (1 + ratio)}};
}

std::vector<Quantity> sweeps_of_five(const Setting& s) {
  scene::Overrides masses;
  for (int k = 1; k <= 5; ++k) masses = masses + of("ball" + std::to_string(k), "mass", s["mass"]);
  const double c = std::cos(k_pi / 10);
  return {{"residual after a sweep over that before it", rate_of_sweeps(s, masses, 60), c * c}};
}

std::vector<Quantity> heavy_on_light(const Setting& s) {
  Trial run = s.trial(of("heavy", "mass", s["ratio"]));
  run.run(s.steps(1));
  return {{"penetration after 1 s [m]", run.last().penetration_max, 0, 1},
          {"force of the floor [N]", run.force_between("floor", "light").z(), k_gravity * (s["ratio"] + 1)},
          {"largest speed [m/s]", fastest(run, {"light", "heavy"}), 0, 1}};
}

std::vector<Quantity> three_legs(const Setting& s) {
  constexpr double k_arm = 0.5, k_height = 0.1, k_body_mass = 2;
  const double along = s["share"] * k_gravity;
  Trial run = s.trial(gravity({along, 0, -k_gravity}) + friction(0.5));
  run.step();
  std::vector<Quantity> found{{"corners that carry load", static_cast<double>(run.touches().size()), 3}};
  for (const double angle : {0.0, 120.0, 240.0}) {
    const Vec3 corner = k_arm * heading(angle);
    double load = 0;
    for (const auto& touch : run.touches())
      if ((touch.point - corner).norm() < 0.01 * k_arm) load += touch.force.z();
    found.push_back({fmt::format("force at {:g} deg [N]", angle), load,
                     k_body_mass * (k_gravity / 3 + 2.0 / 3 * along * k_height / k_arm * std::cos(angle * k_deg))});
  }
  return found;
}

std::vector<Quantity> ball_on_three(const Setting& s) {
  constexpr double k_sine = 0.6, k_cosine = 0.8;  // of the angle of the line of centres to the vertical
  constexpr double k_below = 2;                   // mass of each ball below [kg]
  const std::vector<std::string> balls{"a", "b", "c", "top"};
  const double normal = s["top_mass"] * k_gravity / 3, half = k_sine / (1 + k_cosine);
  const double between = half, on_floor = normal * half / (k_below * k_gravity + normal);
  const auto with = [&](double ball, double floor) {
    Trial run = s.trial(
        of("top", "mass", s["top_mass"]) + friction(ball) +
        scene::Overrides{{"contact/friction[2]/@static", text(floor)}, {"contact/friction[2]/@kinetic", text(floor)}});
    run.run(10);
    return run;
  };
  std::vector<Quantity> found;
  const Trial stands = with(1.02 * between, 1.02 * on_floor);
  double worst = 0;
  for (const auto& touch : stands.touches()) {
    if (touch.a == "floor") continue;
    const double n = std::abs(touch.force.dot(touch.normal));
    const double t = (touch.force - touch.force.dot(touch.normal) * touch.normal).norm();
    worst = std::max({worst, std::abs(n - normal), std::abs(t - normal * half)});
  }
  found.push_back({"largest error of the forces on the upper ball [N]", worst, 0, normal});
  found.push_back({"speed with 1.02 of both friction coefficients [m/s]", fastest(stands, balls), 0, 1});
  found.push_back(
      {"moves with 0.98 of the friction between balls (1: yes)", moves(fastest(with(0.98 * between, 1), balls)), 1});
  found.push_back(
      {"moves with 0.98 of the friction on the floor (1: yes)", moves(fastest(with(1, 0.98 * on_floor), balls)), 1});
  return found;
}

std::vector<Quantity> books(const Setting& s) {
  const double length = s["length"];
  const std::vector<std::string> names{"book1", "book2", "book3", "book4"};
  std::vector<Quantity> found;
  for (const double share : {0.999, 1.001}) {
    scene::Overrides places;
    double centre = -0.5 * length;
    for (std::size_t k = 0; k < names.size(); ++k) {
      centre += share * length / 2 / static_cast<double>(names.size() - k);
      places = places + of(names[k], "size", Vec3(length, 1, 0.1)) +
               of(names[k], "position", Vec3(centre, 0, 0.05 + 0.1 * static_cast<double>(k)));
    }
    Trial run = s.trial(places);
    run.run(10);
    const double speed = fastest(run, names);
    if (share < 1) {
      found.push_back({"speed at 0.999 of the limit [m/s]", speed, 0, 1});
    } else {
      found.push_back({"falls at 1.001 of the limit (1: yes)", moves(speed), 1});
    }
  }
  return found;
}

std::vector<Quantity> tip_or_slide(const Setting& s) {
  const double width = s["width"], height = 1, mass = 2;
  const auto with = [&](double slope, double mu) {
    Trial run = s.trial(of("block", "size", Vec3(width, 1, height)) +
                        of("block", "position", Vec3(0, 0, 0.5 * height)) + of("block", "velocity", "0 0 0") +
                        friction(mu) + gravity(k_gravity * Vec3(std::sin(slope), 0, -std::cos(slope))));
    run.step();
    return run.body("block");
  };
  const double gentle = std::atan(0.75 * width), steep = std::atan(1.25 * width), low = 0.5 * width, high = 2;
  const double about_edge = mass * (width * width + height * height) / 3;
  const double tipping = 0.5 * mass * k_gravity * (std::sin(steep) * height - std::cos(steep) * width) / about_edge;
  const BodyState rests = with(gentle, high), slides = with(gentle, low), tips = with(steep, high);
  return {{"spin on a gentle slope [rad/s]", rests.w.norm(), 0, 1},
          {"speed on a gentle slope [m/s]", rests.v.norm(), 0, 1},
          {"speed on a gentle slope with low friction [m/s]", slides.v.x(),
           s.h() * k_gravity * (std::sin(gentle) - low * std::cos(gentle))},
          {"spin on a gentle slope with low friction [rad/s]", slides.w.norm(), 0, 1},
          {"spin on a steep slope [rad/s]", tips.w.y(), s.h() * tipping}};
}

std::vector<Quantity> ladder(const Setting& s) {
  const double angle = s["angle_deg"] * k_deg, length = 2, thick = 0.1, mass = 2;
  const double c = std::cos(angle), n = std::sin(angle);
  const Vec3 centre(-0.5 * (length * c + thick * n), 0, 0.5 * (length * n + thick * c));
  // The moments about the foot give this ratio of the wall's force to the weight. The lever arm of the wall's force is
  // length sin(angle).
  const double needed = 0.5 * (length * c - thick * n) / (length * n);
  const auto with = [&](double mu) {
    Trial run = s.trial(of("ladder", "position", centre) + of("ladder", "rotation_deg", Vec3(0, -s["angle_deg"], 0)) +
                        friction(mu));
    run.run(5);
    return run;
  };
  const Trial stands = with(1.001 * needed), slips = with(0.999 * needed);
  return {{"force of the wall [N]", -stands.force_between("wall", "ladder").x(), mass * k_gravity * needed},
          {"speed at 1.001 of the friction needed [m/s]", fastest(stands, {"ladder"}), 0, 1},
          {"slips at 0.999 of the friction needed (1: yes)", moves(fastest(slips, {"ladder"})), 1}};
}

std::vector<Quantity> row_of_floes(const Setting& s) {
  const std::vector<std::string> names{"ship", "floe1", "floe2", "floe3", "floe4", "floe5"};
  const std::array<double, 6> masses{1e7, 1e4, 1e2, 1e6, 1e3, 1e5};
  Trial run = s.trial(of("ship", "velocity", Vec3(s["speed"], 0, 0)));
  double all = 0;
  for (const double mass : masses) all += mass;
  const double after = masses[0] * s["speed"] / all;
  run.step();
  double worst = 0, ahead = all;
  for (std::size_t k = 0; k + 1 < names.size(); ++k) {
    ahead -= masses[k];
    worst = std::max(worst, std::abs(run.force_between(names[k], names[k + 1]).x() * s.h() / (after * ahead) - 1));
  }
  return {{"common speed [m/s]", run.body("floe5").v.x(), after},
          {"largest relative error of an impulse", worst, 0, 1}};
}

std::vector<Quantity> painleve(const Setting& s) {
  const double angle = std::atan(2.0), length = 2, thick = 0.01;
  Trial run = s.trial(of("rod", "rotation_deg", Vec3(0, angle / k_deg, 0)) +
                      of("rod", "position", Vec3(0, 0, 0.5 * (length * std::sin(angle) + thick * std::cos(angle)))) +
                      of("rod", "velocity", Vec3(s["speed"], 0, 0)) + friction(s["mu"]));
  double residual = 0, deepest = 0, largest = 0;
  for (int k = 0; k < 20; ++k) {
    const sim::StepRecord& record = run.step();
    residual = std::max(residual, record.residuals.law_map_m_s);
    deepest = std::max(deepest, record.penetration_max);
    largest = std::max(largest, run.contact_force_on("rod").norm());
  }
  return {{"largest residual of the law [m/s]", residual, 0, 1},
          {"penetration [m]", deepest, 0, 1},
          {"largest force is finite and above zero (1: yes)", std::isfinite(largest) && largest > 0 ? 1.0 : 0.0, 1}};
}

std::vector<Quantity> several_times(const Setting& s) {
  constexpr double k_block_mass = 2;
  const auto with = [&](const std::string& scene) {
    Trial run = s.trial_of(scene, friction(s["mu"]) + of("block", "velocity", "2 1 0"));
    run.run(20);
    return run;
  };
  const Trial once = with("block.xml"), twice = with("two-floors.xml");
  return {{"difference of velocities [m/s]", (once.body("block").v - twice.body("block").v).norm(), 0, 1},
          {"sum of normal forces [N]", twice.contact_force_on("block").z(), k_block_mass * k_gravity},
          {"number of contacts over that of one floor",
           static_cast<double>(twice.last().contacts) / static_cast<double>(once.last().contacts), 2}};
}

/// The solvers that reach 1e-12 m/s on more than eight points.
const std::vector<std::string>& many_contacts() {
  static const std::vector<std::string> solvers{"auto", "nsgs", "newton", "admm", "ipm", "eg", "eg-order-free"};
  return solvers;
}

/// Adds columns of bodies: their forces, and the rates at which Gauss-Seidel finds them.
void add_columns(FamilyOfCases& add) {
  Case& five_cubes = add(34, "Column of five cubes", "force between k and k + 1 = (5 - k) m g; nothing moves",
                         {{"mass", 2, "kg"}}, "mass", column);
  five_cubes.solvers = many_contacts();
  five_cubes.note = "Left out: pgs and apgd, which do not reach 1e-12 m/s; enumerate (more than 8 contacts).";
  Case& two = add(35, "Convergence of Gauss-Seidel: heavy ball on a light one",
                  "a sweep multiplies the residual by M/(M + m)", {{"ratio", 10, ""}}, "ratio", sweeps_of_two);
  two.scene = "two-balls-high.xml";
  two.laws = {"frictionless"};
  two.solvers = {"pgs", "nsgs"};
  two.integrators = {"semi-implicit-euler"};
  two.source = "Eigenvalues of the sweep's matrix";
  Case& five = add(36, "Convergence of Gauss-Seidel: column of five balls",
                   "a sweep multiplies the residual by cos^2(pi/(2 n))", {{"mass", 2, "kg"}}, "mass", sweeps_of_five);
  five.scene = "balls-on-balls.xml";
  five.laws = {"frictionless"};
  five.solvers = {"pgs", "nsgs"};
  five.integrators = {"semi-implicit-euler"};
  five.source = "Eigenvalues of the sweep's matrix";
  Case& heavy = add(37, "Heavy cube on a light one", "force of the floor = (M + m) g, no penetration, no motion",
                    {{"ratio", 100, ""}}, "ratio", heavy_on_light);
  heavy.scene = "heavy-on-light.xml";
  heavy.solvers = {"auto", "pgs", "nsgs", "eg", "eg-order-free", "apgd", "admm", "ipm", "newton"};
  heavy.note = "Left out: enumerate, which takes a quarter of a second for eight contacts.";
}

/// Adds bodies on several supports, and the limits at which they stand, slide or tip.
void add_supports(FamilyOfCases& add) {
  add(38, "Plate on three corners", "N_i = m g/3 + 2/3 m a height/R cos(angle_i) under a load m a to the side",
      {{"share", 0.1, ""}}, "share", three_legs)
      .scene = "tripod.xml";
  add(39, "Ball on three balls",
      "N = m g/3, T = N tan(psi/2); stands iff mu >= tan(psi/2) and mu_floor >= T/(N + m_below g)",
      {{"top_mass", 2, "kg"}}, "top_mass", ball_on_three)
      .scene = "ball-pile.xml";
  Case& harmonic =
      add(40, "Books over the edge of a table", "the books stand with overhangs up to L/2 (1, 1/2, 1/3, 1/4)",
          {{"length", 1, "m"}}, "length", books);
  harmonic.scene = "books.xml";
  harmonic.solvers = many_contacts();
  harmonic.note = "Left out: pgs and apgd, which do not reach 1e-12 m/s; enumerate (more than 8 contacts).";
  add(41, "Block that rests, slides or tips",
      "tips iff tan a > b/h and mu > b/h, slides iff mu < tan a and mu < b/h; w = h M/I about the edge after one step",
      {{"width", 0.4, "m"}}, "width", tip_or_slide)
      .scene = "block.xml";
  add(42, "Ladder at a smooth wall", "stands iff mu >= x_c/(l sin a), force of the wall m g x_c/(l sin a)",
      {{"angle_deg", 60, "deg"}}, "angle_deg", ladder)
      .scene = "ladder.xml";
}

/// Adds problems that are hard for most solvers: a wide range of masses, no finite force, contacts met twice.
void add_hard_problems(FamilyOfCases& add) {
  Case& row = add(48, "Ship hits a row of floes of 1e2 to 1e6 kg",
                  "v' = M v/sum(m), impulse on floe k = v' times the mass of floe k and all floes ahead of it",
                  {{"speed", 1, "m/s"}}, "speed", row_of_floes);
  row.scene = "row.xml";
  row.laws = {"frictionless"};
  row.solvers = {"auto", "newton", "admm", "ipm", "apgd"};
  row.note =
      "Left out: pgs and nsgs, whose speed is wrong by 2e-5 after 1e5 sweeps; eg, whose speed is wrong by 0.9; "
      "enumerate (more than 8 contacts).";
  Case& rod = add(49, "Painleve's rod: sliding where no finite force exists",
                  "1 + 3 cos a (cos a - mu sin a) < 0: impulses stay finite, the law holds, nothing penetrates",
                  {{"mu", 2, ""}, {"speed", 1, "m/s"}}, "mu", painleve);
  rod.scene = "rod.xml";
  rod.solvers = {"auto", "nsgs", "newton", "eg", "eg-order-free", "apgd", "admm", "ipm", "enumerate"};
  rod.note = "Left out: pgs, which updates friction and normal force separately and stops at 2e-6 m/s.";
  Case& doubled = add(50, "Every contact doubled", "the same velocities and the same sum of forces", {{"mu", 0.3, ""}},
                      "mu", several_times);
  doubled.scene = "two-floors.xml";
  doubled.also = {"block.xml"};
}

}  // namespace

std::vector<Case> statics() {
  FamilyOfCases add('D', "column.xml", "Statics");
  add_columns(add);
  add_supports(add);
  add_hard_problems(add);
  return add.cases();
}

}  // namespace nilas::verify
