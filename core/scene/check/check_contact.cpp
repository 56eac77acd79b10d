#include "core/choices/body_choices.h"
#include "core/choices/contact_choices.h"
#include "core/choices/output_choices.h"
#include "core/choices/solver_name.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

static const SceneElement* friction_with(const SceneElement& contact, const char* length) {
  for (const auto& friction : contact.children)
    if (number_of(friction, length).value_or(0) > 0) return &friction;
  return nullptr;
}

static std::optional<Law> law_of(const SceneElement& contact) {
  const auto name = text_of(contact, "law");
  if (!name) return std::nullopt;
  return parse_law(*name).law;
}

/// The solver must support the law, and rolling and spinning friction if present.
static void check_solver(const SceneElement& contact, std::vector<Fault>& faults) {
  const auto solver = choice_of<SolverName>(contact, "solver");
  const auto law = law_of(contact);
  if (!solver || !law) return;
  if (const auto problem = law_problem(*solver, *law)) faults.push_back(fault_of(contact, "solver", *problem));
  for (const char* length : {"rolling", "spinning"})
    if (const SceneElement* friction = friction_with(contact, length))
      if (const auto problem = moment_problem(*solver, *law)) {
        faults.push_back(fault_of(*friction, length, *problem));
        return;
      }
}

static void check_substeps(const SceneElement& contact, std::vector<Fault>& faults) {
  const auto substeps = number_of(contact, "substeps");
  if (substeps && *substeps > 1 && choice_of<Detection>(contact, "detection") == Detection::continuous &&
      choice_of<Integrator>(contact, "integrator") == Integrator::moreau)
    faults.push_back(fault_of(contact, "substeps",
                              "with integrator moreau the impulses of a step act in the middle of its motion, which a "
                              "cut at an impact would move; allowed: 0 or 1, or integrator semi-implicit-euler"));
}

static void check_stored(const SceneElement& root, const SceneElement& contact, std::vector<Fault>& faults) {
  const SceneElement* output = child_of(root, "output");
  if (!output) return;
  const bool reference = choice_of<Integrator>(contact, "integrator") == Integrator::reference;
  if (reference && choice_of<StoredContacts>(*output, "contacts") == StoredContacts::all)
    faults.push_back(fault_of(*output, "contacts",
                              "integrator 'reference' has impacts within its steps, and no contacts to store; "
                              "allowed: hull, none"));
  const auto problems = choice_of<StoredProblems>(*output, "problems");
  if (problems && *problems != StoredProblems::never && friction_with(contact, "spinning"))
    faults.push_back(fault_of(*output, "problems",
                              "found '" + name_of(*problems) +
                                  "'; spinning friction has no place in FCLIB's form of a problem; allowed: never"));
}

/// Refuses everything that integrator `reference` does not support.
static void check_reference(const SceneElement& root, const SceneElement& contact, std::vector<Fault>& faults) {
  if (choice_of<Integrator>(contact, "integrator") != Integrator::reference) return;
  const auto refuse = [&](const SceneElement& element, const char* attribute, const std::string& found,
                          const std::string& allowed) {
    const std::string message = "integrator 'reference' does not take " + found + "; allowed: " + allowed;
    faults.push_back(*attribute ? fault_of(element, attribute, message) : fault_of(element, message));
  };
  if (const auto law = law_of(contact); law && *law != Law::coulomb && *law != Law::frictionless)
    refuse(contact, "law", "law '" + *text_of(contact, "law") + "'", "coulomb, frictionless");
  if (const SceneElement* fracture = child_of(root, "fracture"))
    refuse(*fracture, "", "<fracture>", "ice that cannot break");
  if (const SceneElement* hydro = child_of(root, "hydro"))
    if (const SceneElement* added = child_of(*hydro, "added_mass"))
      refuse(*added, "", "<added_mass>", "a scene without it");
  if (const SceneElement* hydro = child_of(root, "hydro"))
    if (const SceneElement* loads = child_of(*hydro, "wave_loads"))
      refuse(*loads, "", "<wave_loads>", "a scene without it");
  if (const SceneElement* hydro = child_of(root, "hydro"))
    if (const SceneElement* radiation = child_of(*hydro, "radiation"))
      refuse(*radiation, "", "<radiation>, whose memory is a state", "a scene without it");
  if (text_of(contact, "gyroscopic") == "false") refuse(contact, "gyroscopic", "gyroscopic=\"false\"", "true");
  if (const SceneElement* output = child_of(root, "output"); output && number_of(*output, "checkpoint_every") > 0.0)
    refuse(*output, "checkpoint_every", "checkpoints, since what CVODE remembers cannot be saved", "0");
  for (const auto& element : root.children) {
    const bool cylinder = choice_of<SolidShapeKind>(element, "shape") == SolidShapeKind::cylinder;
    if (element.name == "body" && cylinder && !is_true(element, "fixed"))
      refuse(element, "shape", "the free cylinder '" + text_of(element, "name").value_or("") + "'",
             "free spheres, boxes, meshes and floes; fixed cylinders");
    if (element.name != "vessel") continue;
    if (const SceneElement* manoeuvring = child_of(element, "manoeuvring"))
      refuse(*manoeuvring, "", "<manoeuvring>, whose rudder and propeller have a state", "a scene without it");
    for (const auto& part : element.children)
      if (choice_of<SolidShapeKind>(part, "shape") == SolidShapeKind::cylinder)
        refuse(part, "shape", "the cylinder '" + text_of(part, "name").value_or("") + "' as a part of the vessel",
               "spheres, boxes and meshes");
  }
  for (const char* length : {"rolling", "spinning"})
    if (const SceneElement* friction = friction_with(contact, length))
      refuse(*friction, length, std::string(length) + " friction", "static, kinetic and restitution in <friction>");
  for (const auto& friction : contact.children)
    if (text_of(friction, "elastic") == "true") refuse(friction, "elastic", "elastic contacts", "false");
}

void check_contact(const SceneElement& root, const SceneElement& contact, std::vector<Fault>& faults) {
  check_friction(root, contact, faults);
  check_solver(contact, faults);
  check_substeps(contact, faults);
  check_stored(root, contact, faults);
  check_reference(root, contact, faults);
}

}  // namespace nilas::scene
