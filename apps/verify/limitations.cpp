#include "apps/verify/limitations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/verify/recurrences.h"
#include "apps/verify/scene_changes.h"
#include "core/base/error.h"

namespace nilas::verify {

namespace {

/// Returns a case without a formula, for a Setting.
Case scene_case(const std::string& scene) {
  Case one;
  one.scene = scene;
  return one;
}

Trial trial(const std::string& scene, const Model& model, const scene::Overrides& changes) {
  const Case one = scene_case(scene);
  return Setting(one, model, {}).trial(changes);
}

constexpr double k_speed = 2, k_mu = 0.3;

void add_pyramid(std::vector<Limitation>& all) {
  const Vec3 along = heading(30);
  const double change = k_mu * k_gravity * 0.01;
  const auto stop = [&](const std::string& law) {
    Trial run = trial("block.xml", {law, "auto"}, of("block", "velocity", Vec3(k_speed * along)) + friction(k_mu));
    run.run(static_cast<long>(k_speed / change) + 5);
    return run.body("block").p;
  };
  const Vec3 box = stop("pyramid"), cone = stop("coulomb");
  const double exact = stopping_distance(k_speed, change, 0.01, 1);
  const std::string scene = "`block.xml`, 2 m/s at 30 degrees to the tangents, mu 0.3";
  const std::string name = "friction as a pyramid of two directions (`law=\"pyramid\"`) instead of a cone";
  all.push_back(
      {name, "distance to rest [m]", scene, std::hypot(box.x(), box.y()), std::hypot(cone.x(), cone.y()), exact});
  all.push_back({name, "angle between displacement and initial velocity [deg]", scene,
                 std::atan2(box.y(), box.x()) / k_deg - 30, std::atan2(cone.y(), cone.x()) / k_deg - 30, 0});
}

void add_gyroscopic(std::vector<Limitation>& all) {
  const Vec3 w(0.5, 0, 1), moments(1, 2, 2.5);
  const auto lost = [&](const std::string& kept) {
    Trial run = trial("top.xml", {},
                      of("top", "inertia", text(moments) + " 0 0 0") + of("top", "angular_velocity", w) +
                          scene::Overrides{{"contact/@gyroscopic", kept}});
    run.run(1000);
    const BodyState top = run.body("top");
    const Vec3 start = moments.cwiseProduct(w);
    return (top.inertia * top.w - start).norm() / start.norm();
  };
  all.push_back({"gyroscopic torque off (`gyroscopic=\"false\"`)", "change of angular momentum in 10 s, as a share",
                 "`top.xml`, spin (0.5, 0, 1) rad/s", lost("false"), lost("true"), 0});
}

void add_static_friction(std::vector<Limitation>& all) {
  const auto speed = [&](double held) {
    Trial run = trial(
        "block.xml", {},
        of("block", "velocity", "0 0 0") + gravity({0.35 * k_gravity, 0, -k_gravity}) +
            scene::Overrides{{"contact/friction[1]/@static", text(held)}, {"contact/friction[1]/@kinetic", "0.3"}});
    run.run(50);
    return run.body("block").v.x();
  };
  all.push_back({"static friction equal to kinetic friction (0.3) instead of 0.4", "speed after 0.5 s [m/s]",
                 "`block.xml` at rest, pushed with 0.35 of its weight", speed(0.3), speed(0.4), 0});
}

void add_rolling(std::vector<Limitation>& all) {
  constexpr double k_length = 0.02, k_ball_radius = 0.5, k_start = 1, k_step = 0.01;
  constexpr long k_steps = 100;
  const auto speed = [&](double length) {
    Trial run = trial("ball.xml", {},
                      of("ball", "velocity", Vec3(k_start, 0, 0)) +
                          of("ball", "angular_velocity", Vec3(0, k_start / k_ball_radius, 0)) + friction(0.5) +
                          scene::Overrides{{"contact/friction[1]/@rolling", text(length)}});
    run.run(k_steps);
    return run.body("ball").v.x();
  };
  // A solid ball that rolls has 7/5 of the inertia of its mass, so the moment slows it at 5/7 of the rate.
  const double exact = k_start - 5.0 / 7 * k_length / k_ball_radius * k_gravity * k_step * k_steps;
  all.push_back({"rolling friction left out instead of 0.02 m", "speed after 1 s [m/s]",
                 "`ball.xml`, radius 0.5 m, rolls at 1 m/s", speed(0), speed(k_length), exact});
}

void add_rigid_contacts(std::vector<Limitation>& all) {
  constexpr double k_stiffness = 1e5, k_mass = 2, k_height = 0.1;  // [N/m], of `block.xml` [kg], [m]
  const auto depth = [&](const char* elastic) {
    Trial run = trial(
        "block.xml", {},
        of("block", "velocity", "0 0 0") + scene::Overrides{{"contact/friction[1]/@elastic", elastic},
                                                            {"contact/friction[1]/@stiffness", text(k_stiffness)}});
    run.run(300);
    return k_height - run.body("block").p.z();
  };
  all.push_back({"rigid contacts instead of elastic ones (`elastic=\"true\"`)", "indentation of the floor at rest [m]",
                 "`block.xml` at rest, 1e5 N/m", depth("false"), depth("true"), k_mass * k_gravity / k_stiffness});
}

void add_split_impulse(std::vector<Limitation>& all) {
  const auto depth = [&](const std::string& stabilisation) {
    Trial run = trial("block.xml", {},
                      of("block", "velocity", "0 0 0") + of("block", "position", "0 0 0.099") +
                          scene::Overrides{{"contact/@stabilisation", stabilisation}, {"contact/@tolerance", "1e-9"}});
    run.run(100);
    return std::max(0.0, 0.1 - run.body("block").p.z());
  };
  all.push_back({"split impulse instead of projection", "penetration after 1 s [m]",
                 "`block.xml` at rest 1 mm deep in the floor", depth("split-impulse"), depth("projection"), 0});
}

void add_fixed_sweeps(std::vector<Limitation>& all) {
  const auto sunk = [&](const Model& model, const scene::Overrides& more) {
    Trial run = trial("heavy-on-light.xml", model,
                      of("heavy", "mass", 100.0) + scene::Overrides{{"contact/@stabilisation", "none"}} + more);
    run.run(100);
    return run.last().penetration_max;
  };
  const scene::Overrides sweeps{
      {"contact/@tolerance", "0"}, {"contact/@max_iterations", "50"}, {"contact/@warm_start", "false"}};
  all.push_back({"50 sweeps of projected Gauss-Seidel (`solver=\"pgs\"`) instead of a tolerance",
                 "penetration after 1 s [m]", "`heavy-on-light.xml`, 100 kg on 1 kg", sunk({"pyramid", "pgs"}, sweeps),
                 sunk({"coulomb", "auto"}, {}), 0});
}

void add_discrete_detection(std::vector<Limitation>& all) {
  const std::string name =
      "contacts only from gaps up to the thickness of the thinner body (`detection=\"discrete\"`) instead of "
      "continuous "
      "detection";
  const auto below = [&](const std::string& detection) {
    Trial run = trial("ball.xml", {},
                      of("ball", "radius", 0.05) + of("ball", "position", "0 0 0.35") +
                          of("ball", "velocity", "0 0 -40") + scene::Overrides{{"contact/@detection", detection}});
    run.run(5);
    return std::max(0.0, 0.05 - run.body("ball").p.z());
  };
  const auto speed = [&](const std::string& detection) {
    Trial run = trial("bullet.xml", {}, scene::Overrides{{"contact/@detection", detection}});
    run.run(5);
    return run.body("target").v.x();
  };
  constexpr double k_bullet = 100;  // [m/s]
  all.push_back({name, "penetration into the floor after 0.05 s [m]",
                 "`ball.xml`, radius 0.05 m, 40 m/s down, step 0.01 s", below("discrete"), below("continuous"), 0});
  all.push_back({name, "speed of a plate of 2 kg after a plate of 1 kg hit it [m/s]",
                 "`bullet.xml`, plates of 0.01 m, 100 m/s, step 0.01 s", speed("discrete"), speed("continuous"),
                 k_bullet / 3});
}

const std::string k_by_fcl = "contacts as FCL gives them (`narrow_phase=\"fcl\"`) instead of those of an exact search";

struct PlateContact {
  double depth = 0;  ///< depth of the deepest point [m]
  double tilt = 0;   ///< angle between its normal and the vertical [rad]
  double load = 0;   ///< load that the lower plate carries [N]
};

/// Takes one step of plates.xml. The upper plate is displaced from the lower one by `off_centre` along X and `up` along
/// Z [m].
PlateContact plate_contact(const std::string& narrow_phase, double off_centre, double up) {
  Trial run = trial(
      "plates.xml", {},
      of("upper", "position", Vec3(off_centre, 0, up)) + scene::Overrides{{"contact/@narrow_phase", narrow_phase}});
  run.run(1);
  const std::vector<Touch> touches = run.touches();
  const auto deepest =
      std::min_element(touches.begin(), touches.end(), [](const Touch& p, const Touch& q) { return p.gap < q.gap; });
  NILAS_DEMAND(deepest != touches.end());
  const double along = std::hypot(deepest->normal.x(), deepest->normal.y());
  return {-deepest->gap, std::atan2(along, deepest->normal.z()), run.contact_force_on("upper").z()};
}

void add_fcl_in_deep_plates(std::vector<Limitation>& all) {
  constexpr double k_thickness = 0.01, k_off_centre = 0.4, k_up = 0.002, k_plate_mass = 1;
  const std::string scene = "`plates.xml`, two plates of 1 x 1 x 0.01 m, the upper 0.4 m off-centre and 8 mm deep";
  const PlateContact fcl = plate_contact("fcl", k_off_centre, k_up), exact = plate_contact("nilas", k_off_centre, k_up);
  all.push_back({k_by_fcl, "depth [m]", scene, fcl.depth, exact.depth, k_thickness - k_up});
  all.push_back(
      {k_by_fcl, "angle of the normal from the vertical [deg]", scene, fcl.tilt / k_deg, exact.tilt / k_deg, 0});
  all.push_back(
      {k_by_fcl, "load that the lower plate carries [N]", scene, fcl.load, exact.load, k_plate_mass * k_gravity});

  constexpr int k_places = 10;  // along each direction
  const auto wrong = [&](const std::string& narrow_phase) {
    int count = 0;
    for (int x = 0; x < k_places; ++x)
      for (int z = 0; z < k_places; ++z)
        count += plate_contact(narrow_phase, 0.05 * x, 0.001 * (z + 0.5)).tilt > 8 * k_deg;
    return count / static_cast<double>(k_places * k_places);
  };
  all.push_back({k_by_fcl, "share of normals that are wrong by more than 8 degrees",
                 "`plates.xml`, upper plate at 100 positions, 0 to 0.45 m off-centre and 0.5 to 9.5 mm deep",
                 wrong("fcl"), wrong("nilas"), 0});
}

/// Adds the ratio of the times of contact detection. Both narrow phases run in turn in one process, and the least of
/// three runs counts.
void add_time_of_fcl(std::vector<Limitation>& all) {
  constexpr long k_steps = 500;
  const auto time = [&](const std::string& narrow_phase) {
    Trial run = trial("column.xml", {}, {{"contact/@narrow_phase", narrow_phase}});
    double sum = 0;
    for (long k = 0; k < k_steps; ++k) sum += run.step().ms[static_cast<std::size_t>(sim::Phase::detection)];
    return sum;
  };
  double fcl = time("fcl"), exact = time("nilas");
  for (int again = 0; again < 2; ++again) {
    fcl = std::min(fcl, time("fcl"));
    exact = std::min(exact, time("nilas"));
  }
  all.push_back({k_by_fcl, "time of contact detection, as a ratio", "`column.xml`, five cubes at rest on each other",
                 fcl / exact, 1});
}

}  // namespace

std::vector<Limitation> limitations() {
  std::vector<Limitation> all;
  add_pyramid(all);
  add_gyroscopic(all);
  add_static_friction(all);
  add_rolling(all);
  add_rigid_contacts(all);
  add_split_impulse(all);
  add_fixed_sweeps(all);
  add_discrete_detection(all);
  add_fcl_in_deep_plates(all);
  add_time_of_fcl(all);
  return all;
}

std::string limitations_markdown(const std::vector<Limitation>& all) {
  std::string page =
      "# What the simplifications of game-engine based simulators cost\n"
      "\n"
      "Each row is one run made twice, with a simplification and without it. The simplifications are those\n"
      "of game-engine based simulators, such as that of Metrikin (2014). The scenes are in\n"
      "`apps/scenes/verify`. A number below 1e-9 is rounding or what the solver's tolerance leaves, and is\n"
      "written as 0. This page is written by `nilas verify --limitations`.\n"
      "\n"
      "| simplification | measured | scene | with it | without it | exact |\n|---|---|---|---|---|---|\n";
  const auto digits = [](double value) {
    constexpr double k_nothing = 1e-9;
    return std::abs(value) < k_nothing ? std::string("0") : fmt::format("{:.3g}", value);
  };
  for (const auto& one : all)
    page += one.exact ? fmt::format("| {} | {} | {} | {} | {} | {} |\n", one.name, one.measured, one.scene,
                                    digits(one.with), digits(one.without), digits(*one.exact))
                      : fmt::format("| {} | {} | {} | {:.2g} | {:.2g} | - |\n", one.name, one.measured, one.scene,
                                    one.with, one.without);
  page +=
      "\n"
      "**FCL.** In these rows the points, normals and depths that FCL gives are used unchanged. Where two\n"
      "faces lie on each other, FCL gives one point, and the upper body would tip on it. The setting `fcl`\n"
      "therefore adds the other corners along FCL's normal. So these rows show FCL's errors of depth and\n"
      "normal, not the effect of a single point. In `plates.xml` all of FCL's normals are right up to a\n"
      "depth of half the thickness. The time is measured when the page is written. In broken ice detection\n"
      "with `fcl` takes 1.2 to 1.9 times as long\n"
      "([measured contacts](validation-contacts.md#the-narrow-phase-with-and-without-fcl)).\n"
      "\n"
      "**Ice.** What simplified ice costs depends on the scene. `nilas compare SCENE --ablate` takes the\n"
      "simplifications out of any scene and puts them back one at a time\n"
      "([comparison](../theory/compare.md#ablation)). Those of ice are:\n"
      "\n"
      "- crushing by a limit\n"
      "- floes that do not crush each other\n"
      "- crushed ice that stays in the outline\n"
      "- splitting by geometry\n"
      "- straight cracks\n"
      "- uniform ice\n"
      "\n"
      "**Rigid contacts.** A rigid contact leaves open how a jam shares its load, and an impact is over within\n"
      "a step. [Elastic contacts](../theory/contact.md#elastic-contacts) decide both. What they change in\n"
      "mean loads is [measured](validation-loads.md#rigid-and-elastic-contacts).\n"
      "\n"
      "**Not shown.** Nilas itself simplifies the following, so no run shows what it costs:\n"
      "\n"
      "- The water has no added mass, no wave damping and no free surface that moves.\n"
      "- Ice does not creep.\n"
      "- Cracks run through within a step.\n";
  return page;
}

}  // namespace nilas::verify
