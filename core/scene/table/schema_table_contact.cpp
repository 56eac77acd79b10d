#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

static std::vector<AttributeSpec> law_and_solver() {
  const ContactScene values;
  AttributeSpec law = choice<Law>("law", "It sets the contact law.");
  law.default_value = name_of(values.law);
  return {
      choice<ContactPreset>("preset",
                            "It replaces the defaults of this element by those of a game-engine based simulator. "
                            "Attributes that are given still win."),
      law,
      {.name = "solver",
       .type = ValueType::choice,
       .choices = choice_names<SolverName>(),
       .default_value = written(values.solver),
       .doc = "It sets the contact solver. `nilas solvers` describes each one and lists the laws that it takes. For "
              "studies of symmetry choose `newton-order-free`, which gives mirror images the same bits."},
      {.name = "tolerance",
       .unit = "m/s",
       .range = at_least(0),
       .default_note = written(values.tolerance) +
                       ". With moving ice it is the power of ten below a thousandth of the largest speed in the scene.",
       .doc = "The solver stops when the residual of the law (law_map_m_s) falls to this value. With 0 it stops "
              "only when the residual is 0, when it stalls, or after max_iterations."},
      {.name = "max_iterations",
       .type = ValueType::integer,
       .range = within(1, 1e9),
       .default_value = written(values.max_iterations),
       .doc = "It is the largest number of iterations in one step."},
      choice("on_failure", values.on_failure, "It sets what happens when the solver misses its tolerance."),
      {.name = "warm_start",
       .type = ValueType::boolean,
       .default_value = written(values.warm_start),
       .doc = "Each solve starts from the impulses of the step before."},
      {.name = "axes_deg",
       .unit = "deg",
       .default_value = written(values.axes_deg),
       .doc = "It turns the contact tangents about the normal, which matters to the pyramid laws only."},
  };
}

static std::vector<AttributeSpec> integration() {
  const ContactScene values;
  AttributeSpec integrator = choice<Integrator>("integrator", "It sets how velocities and positions advance.");
  integrator.default_note =
      name_of(values.integrator) + "; with substeps above 1 " + name_of(Integrator::semi_implicit_euler);
  return {integrator,
          {.name = "theta",
           .range = within(0, 1),
           .default_value = written(values.theta),
           .applies = when("integrator", Integrator::moreau),
           .doc = "This share of the step's motion follows the impulses. With 0.5 the method is of second order and "
                  "energies stay bounded."},
          {.name = "gyroscopic",
           .type = ValueType::boolean,
           .default_value = written(values.gyroscopic),
           .doc = "Spinning bodies have their gyroscopic torque."}};
}

static std::vector<AttributeSpec> detection() {
  const ContactScene values;
  return {
      choice("detection", values.detection, "It sets which gaps at the start of a step become contacts."),
      choice("narrow_phase", values.narrow_phase,
             "It sets which search finds the contacts of two convex pieces. Hulls that crush ice and the "
             "integrator reference have searches of their own."),
      {.name = "substeps",
       .type = ValueType::integer,
       .range = within(0, 1000),
       .default_value = written(values.substeps),
       .applies = when("detection", Detection::continuous),
       .doc = "A step is split at the impacts of fast pairs into at most this many substeps. With 0 or 1 such "
              "impacts enter the step as gaps. Integrator moreau does not allow more than 1."},
      {.name = "margin",
       .unit = "m",
       .range = at_least(0),
       .default_value = written(values.margin),
       .doc = "With `discrete` only gaps below this value become contacts; 0 means the distance that the bodies can "
              "move in one step. Other modes add gaps below this value to their own."}};
}

static std::vector<AttributeSpec> stabilisation() {
  const ContactScene values;
  return {
      choice("stabilisation", values.stabilisation, "It sets how existing penetration is removed."),
      {.name = "erp",
       .range = within(0, 1),
       .default_value = written(values.erp),
       .applies = when("stabilisation", Stabilisation::baumgarte, Stabilisation::split_impulse),
       .doc = "This share of the penetration is removed per step."},
      {.name = "slop",
       .unit = "m",
       .range = at_least(0),
       .default_value = written(values.slop),
       .applies = when("stabilisation", Stabilisation::baumgarte, Stabilisation::split_impulse, Stabilisation::tasora,
                       Stabilisation::projection),
       .doc = "Penetration up to this depth is not removed."},
      {.name = "max_speed",
       .unit = "m/s",
       .range = above(0),
       .default_value = written(values.max_speed),
       .applies = when("stabilisation", Stabilisation::baumgarte, Stabilisation::split_impulse, Stabilisation::tasora),
       .doc = "It is the largest speed of the correction."}};
}

static std::vector<AttributeSpec> elasticity() {
  const FrictionScene values;
  const Condition elastic{"elastic", {written(true)}};
  return {
      {.name = "elastic",
       .type = ValueType::boolean,
       .default_value = written(values.elastic),
       .doc = "Contacts of the pair are springs with dashpots instead of rigid. They may overlap, and no stabilisation "
              "acts on them. Where ice crushes, its own law holds."},
      {.name = "stiffness",
       .unit = "N/m",
       .range = above(0),
       .default_note = "that of the edges of ice that meet, in series; a body that is no ice is rigid",
       .applies = elastic,
       .doc = "It is the normal stiffness of one patch of contact, whose points share it."},
      {.name = "edge_factor",
       .range = above(0),
       .default_value = written(values.edge_factor),
       .applies = elastic,
       .doc =
           "The edge of a floe has this factor times Young's modulus times thickness as stiffness. 0.5 and 1 belong "
           "to a contact whose half width is 0.1 and 0.5 of the radius of the floe. It has no effect with stiffness."},
      {.name = "tangential_ratio",
       .range = above(0),
       .default_note = "2 (1 - n) / (2 - n) for Poisson's ratio n of the ice, or 0.3",
       .applies = elastic,
       .doc = "It is the tangential stiffness over the normal one."},
      {.name = "damping_ratio",
       .range = at_least(0),
       .default_value = written(values.damping_ratio),
       .applies = elastic,
       .doc = "It is the damping of both masses on the normal spring; 1 is critical. The implicit step adds damping "
              "of its own."}};
}

static ElementSpec friction() {
  const FrictionScene values;
  ElementSpec element{
      .name = "friction",
      .parent = "contact",
      .count = Count::many,
      .doc =
          "It sets friction and restitution between two materials. A pair that is not named is frictionless; the "
          "run reports this once if the pair touches.",
      .attributes = {
          {.name = "between",
           .type = ValueType::words,
           .min_count = 2,
           .max_count = 2,
           .required = true,
           .doc = "These are two materials: ice, hull, wall, structure, a body's own material, or * for any."},
          {.name = "static",
           .range = at_least(0),
           .default_note = "as kinetic",
           .doc = "It is the coefficient of static friction, which a contact at rest can bear. It must not be below "
                  "the kinetic one."},
          {.name = "kinetic",
           .range = at_least(0),
           .default_note = "as static",
           .doc = "It is the coefficient of kinetic friction."},
          {.name = "rolling",
           .unit = "m",
           .range = at_least(0),
           .default_value = written(values.rolling),
           .doc = "The moment against rolling is at most this length times the normal force."},
          {.name = "spinning",
           .unit = "m",
           .range = at_least(0),
           .default_value = written(values.spinning),
           .doc = "The moment about the normal is at most this length times the normal force."},
          {.name = "restitution",
           .range = within(0, 1),
           .default_value = written(values.restitution),
           .doc = "It is Newton's coefficient of restitution. An elastic pair has none."}}};
  for (AttributeSpec& attribute : elasticity()) element.attributes.push_back(std::move(attribute));
  return element;
}

std::vector<ElementSpec> contact_elements() {
  ElementSpec contact{.name = "contact",
                      .parent = "scene",
                      .always = true,
                      .doc = "It sets how bodies touch: law, solver, time stepping and the removal of penetration."};
  for (const auto& group : {law_and_solver(), integration(), detection(), stabilisation()})
    contact.attributes.insert(contact.attributes.end(), group.begin(), group.end());
  return {contact, friction()};
}

}  // namespace nilas::scene::schema_table
