/// Family G: invariances. These cases need no formula, because a transformed scene must give the transformed motion.
#include <algorithm>
#include <cmath>

#include "apps/verify/families.h"
#include "apps/verify/recurrences.h"
#include "apps/verify/scene_changes.h"
#include "contact/registry.h"

namespace nilas::verify {

namespace {

const std::vector<std::string> k_pile{"low", "side", "high"};
constexpr double k_solved = 1e-10;   // tolerance above the residual that the runs leave [m/s]
constexpr double k_pile_time = 0.6;  // time after which all three balls have met [s]

/// Returns the largest difference of velocities between two runs. Linear velocities of the second are multiplied by
/// `scale`.
double difference(const Trial& one, const Trial& other, const std::string& prefix = "", double scale = 1) {
  double worst = 0;
  for (const auto& name : k_pile) {
    const BodyState a = one.body(name), b = other.body(prefix + name);
    worst = std::max({worst, (a.v - scale * b.v).norm(), (a.w - scale * b.w).norm()});
  }
  return worst;
}

Trial pile(const Setting& s, const scene::Overrides& changes, const std::string& scene = "pile.xml", int threads = 1) {
  Trial run = s.trial_of(scene, friction(s["mu"]) + changes, threads);
  run.run(s.steps(k_pile_time));
  return run;
}

std::vector<Quantity> turned(const Setting& s) {
  const Vec3 angles(40, -25, s["roll_deg"]);
  const Mat3 R =
      (Eigen::AngleAxisd(angles[0] * k_deg, Vec3::UnitZ()) * Eigen::AngleAxisd(angles[1] * k_deg, Vec3::UnitY()) *
       Eigen::AngleAxisd(angles[2] * k_deg, Vec3::UnitX()))
          .toRotationMatrix();
  const Vec3 down(0, 0, -k_gravity), place(0, 0, 0.1), velocity(2, 1, 0);
  Trial run = s.trial(of("block", "velocity", velocity)),
        other = s.trial(gravity(R * down) + of("floor", "rotation_deg", angles) + of("block", "rotation_deg", angles) +
                        of("block", "position", Vec3(R * place)) + of("block", "velocity", Vec3(R * velocity)));
  run.run(30);
  other.run(30);
  const BodyState a = run.body("block"), b = other.body("block");
  return {{"difference from the rotated velocity [m/s]", (R * a.v - b.v).norm(), 0, 1},
          {"difference from the rotated position [m]", (R * a.p - b.p).norm(), 0, 1}};
}

std::vector<Quantity> axes(const Setting& s) {
  const double change = 0.3 * k_gravity * s.h(), speed = 2;
  Trial run = s.trial(of("block", "velocity", Vec3(speed, 0, 0)) +
                      scene::Overrides{{"contact/@axes_deg", text(s["axes_deg"])}});
  run.run(static_cast<long>(speed / change) + 5);
  // Along each axis of the pyramid the velocity falls to zero by itself.
  const Mat3 R = Eigen::AngleAxisd(s["axes_deg"] * k_deg, Vec3::UnitZ()).toRotationMatrix();
  Vec3 distance(stopping_distance(speed, change, s.h(), s.theta()), 0, 0);
  if (s.model().law == "pyramid") {
    const Vec3 own = R.transpose() * Vec3(speed, 0, 0);
    distance = R * Vec3(std::copysign(stopping_distance(std::abs(own.x()), change, s.h(), s.theta()), own.x()),
                        std::copysign(stopping_distance(std::abs(own.y()), change, s.h(), s.theta()), own.y()), 0);
  }
  const Vec3 p = run.body("block").p;
  return {{"distance along X [m]", p.x(), distance.x(), 1}, {"distance along Y [m]", p.y(), distance.y(), 1}};
}

std::vector<Quantity> permuted(const Setting& s) {
  const Trial one = pile(s, {}), other = pile(s, {}, "pile-reversed.xml");
  return {{"difference of velocities [m/s]", difference(one, other), 0, 1}};
}

std::vector<Quantity> swapped(const Setting& s) {
  std::vector<Vec3> left, right, spin;
  for (const char* scene : {"pair.xml", "pair-swapped.xml"}) {
    Trial run = s.trial_of(scene, friction(s["mu"]) + restitution(0.5));
    run.run(s.steps(0.5));
    left.push_back(run.body("left").v);
    right.push_back(run.body("right").v);
    spin.push_back(run.body("right").w);
  }
  return {{"difference of velocities [m/s]", std::max((left[0] - left[1]).norm(), (right[0] - right[1]).norm()), 0, 1},
          {"difference of spins [rad/s]", (spin[0] - spin[1]).norm(), 0, 1},
          {"the balls collide (1: yes)", right[0].norm() > 0.1 ? 1.0 : 0.0, 1}};
}

std::vector<Quantity> heavier(const Setting& s) {
  const double factor = s["factor"];
  const Trial one = pile(s, {});
  Trial other = pile(s, of("low", "mass", 4 * factor) + of("side", "mass", 1.5 * factor) + of("high", "mass", factor));
  const double load = one.contact_force_on("low").norm();
  return {{"difference of velocities [m/s]", difference(one, other), 0, 1},
          {"force on the lower ball over the factor [N]", other.contact_force_on("low").norm() / factor, load}};
}

std::vector<Quantity> enlarged(const Setting& s) {
  // By Froude's law lengths scale by lambda, and speeds and times by its square root.
  const double lambda = s["lambda"], slower = std::sqrt(lambda);
  Trial one = s.trial(of("block", "velocity", "2 1 0"));
  Trial other = s.trial(
      of("block", "velocity", Vec3(slower * Vec3(2, 1, 0))) + of("block", "position", Vec3(0, 0, 0.1 * lambda)) +
      of("block", "size", Vec3(lambda * Vec3(1, 1, 0.2))) + scene::Overrides{{"time/@step", text(slower * s.h())}});
  one.run(30);
  other.run(30);
  const BodyState a = one.body("block"), b = other.body("block");
  return {{"speed over sqrt(lambda) times that of the small block", b.v.norm() / (slower * a.v.norm()), 1},
          {"distance over lambda times that of the small block",
           std::hypot(b.p.x(), b.p.y()) / (lambda * std::hypot(a.p.x(), a.p.y())), 1}};
}

std::vector<Quantity> mirrored(const Setting& s) {
  const auto with = [&](double side) {
    Trial run =
        s.trial(of("side", "position", Vec3(1.2, side * 0.1, 0.4)) + of("side", "velocity", Vec3(-2, side * 0.3, 0)) +
                of("high", "position", Vec3(-0.1, side * 0.2, 1.3)) +
                of("high", "velocity", Vec3(0.4, -side * 0.5, -1)) + friction(s["mu"]));
    run.run(s.steps(k_pile_time));
    return run;
  };
  const Trial one = with(1), other = with(-1);
  double worst = 0;
  for (const auto& name : k_pile) {
    const Vec3 a = one.body(name).v, b = other.body(name).v;
    worst = std::max(worst, (a - Vec3(b.x(), -b.y(), b.z())).norm());
  }
  return {{"difference from the mirrored velocity [m/s]", worst, 0, 1}};
}

std::vector<Quantity> twice(const Setting& s) {
  const Trial one = pile(s, {}), both = pile(s, {}, "two-piles.xml");
  return {{"difference of the near pile from one pile alone [m/s]", difference(one, both), 0, 1},
          {"difference of the far pile from one pile alone [m/s]", difference(one, both, "far-"), 0, 1},
          {"number of contacts over that of one pile",
           static_cast<double>(both.last().contacts) / static_cast<double>(std::max(1, one.last().contacts)), 2}};
}

std::vector<Quantity> smooth(const Setting& s) {
  Trial one = s.trial(friction(0) + of("side", "velocity", Vec3(-s["speed"], 0.3, 0)));
  Trial other = s.trial(of("side", "velocity", Vec3(-s["speed"], 0.3, 0)) +
                        scene::Overrides{{"contact/@law", "frictionless"}, {"contact/@solver", "enumerate"}});
  one.run(s.steps(k_pile_time));
  other.run(s.steps(k_pile_time));
  return {{"difference from the frictionless law by enumerate [m/s]", difference(one, other), 0, 1}};
}

std::vector<Quantity> rough(const Setting& s) {
  const double slope = s["slope_deg"] * k_deg;
  Trial run = s.trial(of("block", "velocity", "0 0 0") + of("block", "size", Vec3(20, 20, 0.2)) + friction(s["mu"]) +
                      gravity(k_gravity * Vec3(std::sin(slope), 0, -std::cos(slope))));
  run.run(20);
  return {{"speed on a steep slope [m/s]", run.body("block").v.norm(), 0, 1},
          {"force along the slope [N]", -run.contact_force_on("block").x(), 2 * k_gravity * std::sin(slope)}};
}

std::vector<Quantity> warm(const Setting& s) {
  const Trial run = pile(s, {});
  const contact::SolvedProblem& solved = run.problem();
  const auto solver = contact::find_solver(s.model().solver).make({.tolerance = k_solved, .max_iterations = 1000});
  const contact::ContactSolution again = solver->solve(solved.problem, solved.solution.r);
  return {{"iterations beyond one", std::max(0, again.iterations - 1) * 1.0, 0, 1},
          {"change of velocities [m/s]", (again.v - solved.solution.v).norm(), 0, 1},
          {"contacts exist (1: yes)", static_cast<double>(run.last().contacts > 0), 1}};
}

std::vector<Quantity> threads(const Setting& s) {
  constexpr int k_steps = 5;
  std::vector<std::uint64_t> hashes;
  int contacts = 0;
  double same = 1;
  for (const int count : {1, 2, 5}) {
    Trial run = s.trial(
        {{"contact/friction[1]/@static", text(s["mu"])}, {"contact/friction[1]/@kinetic", text(s["mu"])}}, count);
    for (std::size_t k = 0; k < k_steps; ++k) {
      const sim::StepRecord& record = run.step();
      contacts = std::max(contacts, record.contacts);
      if (hashes.size() <= k) hashes.push_back(record.state_hash);
      if (hashes[k] != record.state_hash) same = 0;
    }
  }
  return {{"every step has the same bits with 1, 2 and 5 threads (1: yes)", same, 1},
          {"more than 512 contacts take part (1: yes)", contacts > 512 ? 1.0 : 0.0, 1}};
}

}  // namespace

std::vector<Case> invariances() {
  FamilyOfCases add('G', "pile.xml", "Symmetry of the equations");
  const Input mu{"mu", 0.3, ""};
  add(67, "Rotation of the whole scene", "v -> R v", {{"roll_deg", 65, "deg"}}, "roll_deg", turned).scene = "block.xml";
  Case& axes_case = add(68, "Rotation of the contact tangents",
                        "coulomb: nothing changes; pyramid: each axis of the pyramid stops separately",
                        {{"axes_deg", 30, "deg"}}, "axes_deg", axes);
  axes_case.scene = "block.xml";
  axes_case.laws = {"coulomb", "pyramid"};
  add(69, "Bodies in another order", "the same velocities", {mu}, "mu", permuted).also = {"pile-reversed.xml"};
  Case& roles = add(70, "The two bodies of a contact swapped", "the same velocities", {mu}, "mu", swapped);
  roles.scene = "pair.xml";
  roles.also = {"pair-swapped.xml"};
  add(71, "All masses multiplied by a factor", "the same velocities, and forces multiplied by the factor",
      {{"factor", 1000, ""}, mu}, "factor", heavier);
  add(72, "Froude scaling", "lengths scale by lambda, times and speeds by sqrt(lambda)", {{"lambda", 25, ""}}, "lambda",
      enlarged)
      .scene = "block.xml";
  add(73, "Mirror image of the scene", "y -> -y", {mu}, "mu", mirrored);
  add(74, "Two copies of the scene, far apart", "each copy moves as if it were alone", {mu}, "mu", twice).also = {
      "two-piles.xml"};
  add(75, "No friction", "coulomb with mu = 0 gives the motion of the frictionless law, which enumerate solves",
      {{"speed", 2, "m/s"}}, "speed", smooth);
  Case& endless = add(76, "Very large friction", "nothing slides on a slope of less than 90 degrees",
                      {{"mu", 1000, ""}, {"slope_deg", 60, "deg"}}, "slope_deg", rough);
  endless.scene = "block.xml";
  endless.solvers = {"auto", "pgs", "nsgs", "admm", "ipm", "newton", "enumerate"};
  endless.note =
      "Left out: eg and apgd, whose steps shrink with mu^2. After 1e5 steps the block still slides, which these "
      "solvers report.";
  Case& again =
      add(77, "Solver started from its own solution", "at most one iteration, the same velocities", {mu}, "mu", warm);
  again.solvers = {"auto", "pgs", "nsgs", "eg", "eg-order-free", "apgd", "admm", "ipm", "newton"};
  again.note = "Left out: enumerate, which tries all states whatever the initial guess.";
  Case& bits = add(78, "One thread and several", "the same results to the bit", {mu}, "mu", threads);
  bits.scene = "sheet.xml";
  bits.contact_tolerance = 1e-6;
  bits.contact_iterations = 30;
  bits.solvers = {"auto", "pgs", "nsgs", "eg", "eg-order-free", "apgd", "newton"};
  bits.note = "Left out: admm, ipm and enumerate, which would take minutes for one island of two thousand contacts.";
  return add.cases();
}

}  // namespace nilas::verify
