/// Family H: crushing of ice.
#include <algorithm>
#include <cmath>

#include "apps/verify/families.h"
#include "apps/verify/scene_changes.h"

namespace nilas::verify {

namespace {

/// The area of the sides of wedge and pyramid over its projection along the motion. Their half angle is atan 1/2.
const double k_slant = std::sqrt(5.0);

scene::Overrides crushing_ice(const Setting& s, const std::string& model) {
  return {{"fracture/@compressive_strength", text(s["strength"])},
          {"fracture/crushing/@model", model},
          {"ice/floe[1]/@thickness", text(s["thickness"])}};
}

/// The wedge is as wide in the ice as it is deep. The force follows from the area where the step finds the contacts.
std::vector<Quantity> steady_wedge(const Setting& s) {
  const double speed = s["speed"], start = -0.0025;
  Trial run = s.trial(crushing_ice(s, "explicit") + scene::Overrides{{"vessel/carriage/@speed", text(speed)}});
  double worst = 0, largest = 0;
  const long n = s.steps(1);
  double work = 0;
  for (long k = 0; k < n; ++k) {
    const double depth = start + speed * s.h() * (static_cast<double>(k) + 1 - s.theta());
    const double expected = s["strength"] * s["thickness"] * std::max(0.0, depth);
    const Vec3 force = run.step().vessel->contact.force;
    worst = std::max(worst, (force + Vec3(expected, 0, 0)).norm());
    largest = std::max(largest, expected);
    work += expected * speed * s.h();
  }
  return {{"largest error of the force [N]", worst, 0, largest},
          {"crushing energy [J]", run.last().ledger.crushing, work}};
}

scene::Overrides impact(const Setting& s, const std::string& mesh) {
  return of("indenter", "mesh", mesh) + of("indenter", "mass", s["mass"]) +
         of("indenter", "velocity", Vec3(s["speed"], 0, 0));
}

/// The step is implicit in the velocity: m (v - v+) = h strength T (x + h v+) and x+ = x + h v+, until v+ = 0. T is the
/// thickness.
std::vector<Quantity> wedge_impact(const Setting& s) {
  Trial run = s.trial(crushing_ice(s, "compliant") + impact(s, "wedge.stl"));
  const double start = run.body("indenter").p.x(), k = s["strength"] * s["thickness"], m = s["mass"], h = s.h();
  const double limit = s["speed"] * std::sqrt(m / k);
  double x = 0, v = s["speed"], force = 0, largest = 0;
  const long n = s.steps(2 * limit / s["speed"]);
  for (long i = 0; i < n; ++i) {
    const double next = std::max(0.0, (m * v - h * k * x) / (m + h * h * k));
    force = std::max(force, m * (v - next) / h);
    v = next;
    x += h * v;
    run.step();
    largest = std::max(largest, run.contact_force_on("indenter").norm());
  }
  return {{"depth [m]", run.body("indenter").p.x() - start, x},
          {"largest force [N]", largest, force},
          {"speed at the end [m/s]", run.body("indenter").v.norm(), 0, s["speed"]},
          {"crushing energy [J]", run.last().ledger.crushing, 0.5 * m * s["speed"] * s["speed"]}};
}

/// The force is C A^exponent times the projected area, which is k x^q with q = 2 + 2 exponent at the depth x.
std::vector<Quantity> popov(const Setting& s) {
  const double exponent = s["exponent"], coefficient = s["coefficient"], m = s["mass"], speed = s["speed"];
  Trial run = s.trial(crushing_ice(s, "pressure-area") + impact(s, "pyramid.stl") +
                      scene::Overrides{{"fracture/crushing/@coefficient", text(coefficient)},
                                       {"fracture/crushing/@exponent", text(exponent)}});
  const double k = coefficient * std::pow(k_slant, exponent), q = 2 + 2 * exponent;
  const double depth = std::pow((q + 1) * m * speed * speed / (2 * k), 1 / (q + 1));
  const double start = run.body("indenter").p.x();
  double largest = 0;
  const long n = s.steps(2 * depth / speed);
  for (long i = 0; i < n; ++i) {
    run.step();
    largest = std::max(largest, run.contact_force_on("indenter").norm());
  }
  return {{"depth [m]", run.body("indenter").p.x() - start, depth},
          {"largest force [N]", largest, k * std::pow(depth, q)}};
}

}  // namespace

std::vector<Case> crushing() {
  FamilyOfCases add('H', "crush-impact.xml", "The Popov method: 1/2 M v^2 = int F d(delta) (Idrissova et al. 2019)");
  const Input strength{"strength", 1e5, "Pa"}, thickness{"thickness", 0.25, "m"}, speed{"speed", 1, "m/s"},
      mass{"mass", 5000, "kg"};
  Case& steady = add(79, "Wedge driven into a sheet", "F = strength x projected area, which is depth x thickness",
                     {strength, thickness, {"speed", 0.5, "m/s"}}, "strength", steady_wedge);
  steady.scene = "crush-wedge.xml";
  steady.source = "Metrikin (2014): the normal force is at most strength times area";
  Case& implicit = add(80, "Impact of a wedge on a sheet, compliant", "m (v - v+) = h strength T (x + h v+)",
                       {strength, thickness, speed, mass}, "strength", wedge_impact);
  implicit.integrators = {"semi-implicit-euler"};
  implicit.solvers = {"auto", "pgs", "nsgs", "eg", "eg-order-free", "apgd", "admm", "ipm", "newton"};
  implicit.note = "Left out: enumerate (more than 8 contacts).";
  Case& daley =
      add(81, "Impact of a pyramid on a sheet, pressure-area",
          "depth = ((3 + 2 ex) M v^2/(2 C sqrt(5)^ex))^(1/(3 + 2 ex)), F = C (sqrt(5) depth^2)^ex depth^2",
          {strength, {"thickness", 4, "m"}, speed, mass, {"coefficient", 1e5, "Pa m^0.2"}, {"exponent", -0.1, ""}},
          "coefficient", popov);
  daley.integrators = {"semi-implicit-euler"};
  daley.solvers = {"auto"};
  daley.step = 0.02;
  daley.orders = {1};
  daley.coarsest = {0.08};
  return add.cases();
}

}  // namespace nilas::verify
