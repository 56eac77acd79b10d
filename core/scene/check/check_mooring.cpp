#include <map>

#include "core/choices/contact_choices.h"
#include "core/choices/mooring_choices.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

static bool is_mooring_line(const SceneElement& child) { return child.name == "line" || child.name == "spring_line"; }

static void check_spring_line(const SceneElement& line, std::vector<Fault>& faults) {
  const bool stiffness = is_named(line, "stiffness"), table = is_named(line, "table");
  if (stiffness && table)
    faults.push_back(fault_of(line, "table", "found a stiffness and a table; allowed: one of them"));
  if (!stiffness && !table) faults.push_back(fault_of(line, "found neither stiffness nor table; allowed: one of them"));
  const bool knee = is_named(line, "knee"), second = is_named(line, "second_stiffness");
  if (knee != second)
    faults.push_back(fault_of(line, knee ? "knee" : "second_stiffness",
                              "a knee and a second_stiffness belong together; allowed: both or neither"));
  if (table && (knee || second))
    faults.push_back(fault_of(line, knee ? "knee" : "second_stiffness",
                              "the table has all stiffness of the line; allowed: with stiffness"));
}

/// Height of the sea bed [m]; empty without a bed, or where a value that it follows from is faulty.
static std::optional<double> bed_of(const SceneElement& root, const SceneElement& mooring) {
  auto depth = number_of(mooring, "depth");
  const SceneElement *tank = child_of(root, "tank"), *water = child_of(root, "water");
  if (!is_named(mooring, "depth") && tank && is_true(*tank, "floor")) depth = number_of(*tank, "depth");
  if (!depth) return std::nullopt;
  return (water ? number_of(*water, "level").value_or(0) : 0) - *depth;
}

static void check_mooring_line(const SceneElement& line, std::optional<double> bed, bool has_turret,
                               std::vector<Fault>& faults) {
  if (line.name == "spring_line") check_spring_line(line, faults);
  if (const auto weight = number_of(line, "weight"); weight && *weight == 0)
    faults.push_back(fault_of(line, "weight", "found 0; allowed: a number that is not 0, or <spring_line>"));
  if (is_true(line, "turret") && !has_turret)
    faults.push_back(fault_of(line, "turret", "found 'true' without <turret>; allowed: false, or <turret at=\"...\">"));
  const auto anchor = numbers_of(line, "anchor");
  if (bed && anchor && anchor->at(2) < *bed)
    faults.push_back(fault_of(line, "anchor",
                              "found the height " + format_number(anchor->at(2)) + " m, below the bed at " +
                                  format_number(*bed) + " m; allowed: on the bed or above it"));
}

/// Refuses lines that cannot hold the vessel, or with an integrator that does not know their state.
static void check_moored_motion(const SceneElement& root, const SceneElement& vessel, const SceneElement& mooring,
                                std::vector<Fault>& faults) {
  for (const char* held : {"carriage", "fixed"})
    if (child_of(vessel, held))
      faults.push_back(fault_of(mooring, std::string("found <mooring> beside <") + held +
                                             ">, which holds the vessel; allowed: a free vessel"));
  const SceneElement* contact = child_of(root, "contact");
  if (contact && choice_of<Integrator>(*contact, "integrator") == Integrator::reference)
    faults.push_back(fault_of(mooring,
                              "integrator 'reference' does not take <mooring>, which remembers broken lines; allowed: "
                              "integrator semi-implicit-euler, moreau"));
}

/// The lines of MoorDyn are in its file only.
static void check_moordyn(const SceneElement& mooring, std::vector<Fault>& faults) {
  if (!is_named(mooring, "file"))
    faults.push_back(
        fault_of(mooring, "model 'moordyn' has no file; allowed: file=\"...\", an input file of MoorDyn 2"));
  for (const SceneElement& child : mooring.children)
    faults.push_back(
        fault_of(child, "model 'moordyn' takes its lines from its file; allowed: no <" + child.name + ">"));
}

void check_mooring(const SceneElement& root, const SceneElement& vessel, std::vector<Fault>& faults) {
  const SceneElement* mooring = child_of(vessel, "mooring");
  if (!mooring) return;
  check_moored_motion(root, vessel, *mooring, faults);
  if (choice_of<MooringKind>(*mooring, "model") == MooringKind::moordyn) return check_moordyn(*mooring, faults);
  const SceneElement* turret = child_of(*mooring, "turret");
  const bool has_turret = turret || is_misspelt(*mooring, "turret");
  const std::optional<double> bed = bed_of(root, *mooring);
  std::map<std::string, int> line_of_name;
  bool any_on_turret = false;
  for (const SceneElement& line : mooring->children) {
    if (!is_mooring_line(line)) continue;
    check_mooring_line(line, bed, has_turret, faults);
    any_on_turret = any_on_turret || is_true(line, "turret");
    const auto name = text_of(line, "name");
    if (name && !line_of_name.emplace(*name, line.place.line).second)
      faults.push_back(fault_of(line, "name",
                                "the name '" + *name + "' is taken by the mooring line of line " +
                                    std::to_string(line_of_name[*name]) + "; names must be unique"));
  }
  if (line_of_name.empty() && !is_named(*mooring, "file") && !is_misspelt(*mooring, "line") &&
      !is_misspelt(*mooring, "spring_line"))
    faults.push_back(fault_of(*mooring, "found no line; allowed: <line> or <spring_line>, one or more"));
  if (turret && !any_on_turret)
    faults.push_back(
        fault_of(*turret, "no line is on the turret; allowed: a line with turret=\"true\", or no <turret>"));
}

}  // namespace nilas::scene
