#include "core/scene/check/cross_checks.h"

#include <map>

#include "core/scene/schema/attribute_values.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

static void check_time(const SceneElement& time, std::vector<Fault>& faults) {
  constexpr double k_most_steps = 1e15;  // more than anyone can compute; steps are counted by integers
  const auto start = number_of(time, "start"), end = number_of(time, "end"), step = number_of(time, "step");
  if (start && end && step && (*end - *start) / *step > k_most_steps)
    faults.push_back(fault_of(time, "step",
                              "found " + format_number(*step) + ", which makes more than " +
                                  format_number(k_most_steps) + " steps; allowed: fewer, by a longer step"));
  if (start && end && !(*end > *start))
    faults.push_back(
        fault_of(time, "end",
                 "found " + format_number(*end) + "; allowed: after the start, > " + format_number(*start) + " [s]"));
}

static void check_gravity(const SceneElement& root, std::vector<Fault>& faults) {
  const SceneElement* hydro = child_of(root, "hydro");
  const SceneElement* gravity = child_of(root, "gravity");
  if (!hydro || !gravity || !needs_water(*hydro)) return;
  const auto g = numbers_of(*gravity, "value");
  if (g && (g->at(0) != 0 || g->at(1) != 0 || g->at(2) > 0))
    faults.push_back(
        fault_of(*gravity, "value", "with loads of the water gravity must point along -Z; allowed: 0 0 -g"));
}

/// Names of the vessel, its parts and rods, the bodies and the floes must all differ.
static void check_names(const SceneElement& root, std::vector<Fault>& faults) {
  std::map<std::string, int> line_of_name;
  const auto check = [&](const SceneElement& element) {
    const auto name = text_of(element, "name");
    if (!name || line_of_name.emplace(*name, element.place.line).second) return;
    faults.push_back(fault_of(element, "name",
                              "the name '" + *name + "' is taken by the element of line " +
                                  std::to_string(line_of_name[*name]) + "; names must be unique"));
  };
  for (const auto& element : root.children) {
    if (element.name == "vessel" || element.name == "body") check(element);
    for (const auto& child : element.children)
      if ((element.name == "ice" && child.name == "floe") || child.name == "part" || child.name == "rod") check(child);
  }
}

void check_inertia(const SceneElement& element, std::vector<Fault>& faults) {
  const auto entries = numbers_of(element, "inertia");
  if (!entries) return;
  const auto& i = *entries;
  Mat3 tensor;
  tensor << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
  const Vec3 principal = Eigen::SelfAdjointEigenSolver<Mat3>(tensor, Eigen::EigenvaluesOnly).eigenvalues();
  const std::string found = "found principal moments " + format_number(principal[0]) + ", " +
                            format_number(principal[1]) + ", " + format_number(principal[2]);
  // Thin rods and plates reach the bound itself; their entries are rounded.
  constexpr double k_rounding = 1e-9;
  if (!(principal[0] > 0))
    faults.push_back(fault_of(element, "inertia", found + "; allowed: a positive definite tensor (xx yy zz xy xz yz)"));
  else if (principal[0] + principal[1] < (1 - k_rounding) * principal[2])
    faults.push_back(fault_of(element, "inertia", found + "; allowed: none may exceed the sum of the other two"));
}

static void check_statistics(const SceneElement& output, std::vector<Fault>& faults) {
  const auto window = numbers_of(output, "statistics");
  if (!window || window->size() != 2) return;
  const std::string found = "found " + format_number(window->at(0)) + " to " + format_number(window->at(1)) + " s";
  if (!(window->at(0) < window->at(1)))
    faults.push_back(fault_of(output, "statistics", found + "; allowed: the first time before the second"));
}

/// Bending needs ice that rests on water, and pieces that float.
static void check_fracture(const SceneElement& root, const SceneElement& fracture, std::vector<Fault>& faults) {
  const SceneElement *gravity = child_of(root, "gravity"), *hydro = child_of(root, "hydro");
  const auto g = gravity ? numbers_of(*gravity, "value") : std::nullopt;
  const bool floats = hydro ? is_named(*hydro, "buoyancy") : is_misspelt(root, "hydro");
  for (const auto& child : fracture.children) {
    if (child.name != "bending" && child.name != "splitting") continue;
    if (!floats)
      faults.push_back(fault_of(child, "the ice rests on water as it breaks; allowed: with <hydro><buoyancy>"));
    if (g && !(g->at(0) == 0 && g->at(1) == 0 && g->at(2) < 0))
      faults.push_back(fault_of(child, "the ice rests on water as it breaks; allowed: <gravity> along -Z, 0 0 -g"));
  }
}

void cross_check(const SceneElement& root, std::vector<Fault>& faults) {
  check_gravity(root, faults);
  check_added_mass(root, faults);
  check_waves(root, faults);
  check_database(root, faults);
  check_names(root, faults);
  for (const auto& element : root.children) {
    if (element.name == "time") check_time(element, faults);
    if (element.name == "contact") check_contact(root, element, faults);
    if (element.name == "vessel") check_vessel(root, element, faults);
    if (element.name == "vessel") check_wind_area(element, faults);
    if (element.name == "hydro") check_propeller_wash(root, element, faults);
    if (element.name == "ice") {
      check_ice(element, faults);
      check_vary(element, faults);
    }
    if (element.name == "tank") check_tank(root, element, faults);
    if (element.name == "body") check_body(element, faults);
    if (element.name == "fracture") check_fracture(root, element, faults);
    if (element.name == "output") check_statistics(element, faults);
  }
}

}  // namespace nilas::scene
