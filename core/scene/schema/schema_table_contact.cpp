#include "core/scene/schema/schema_table.h"

namespace nilas::schema_table {

static std::vector<AttributeSpec> law_and_solver() {
  return {
      {.name = "preset",
       .type = ValueType::choice,
       .choices = {"seed-2014"},
       .doc = "Sets the defaults of this element to an older tool's choices: law pyramid, solver pgs with tolerance 0 "
              "and 50 sweeps, stabilisation split-impulse, detection discrete, integrator semi-implicit-euler, "
              "gyroscopic false. Any attribute given beside it wins."},
      {.name = "law",
       .type = ValueType::choice,
       .choices = {"coulomb", "ccp", "pyramid", "pyramid-k", "frictionless"},
       .default_value = "coulomb",
       .doc = "Contact law: coulomb (exact cone), ccp (convexified cone), pyramid (two independent tangential boxes), "
              "pyramid-k (k facets, as in pyramid-8), frictionless."},
      {.name = "solver",
       .type = ValueType::choice,
       .choices = {"auto", "pgs", "nsgs", "eg", "eg-order-free", "apgd", "admm", "newton", "newton-order-free", "ipm",
                   "enumerate"},
       .default_value = "auto",
       .doc = "auto, or a name that `nilas solvers` lists, with the laws that each takes. For studies of symmetry: "
              "newton-order-free, which gives mirror images the same bits."},
      {.name = "tolerance",
       .unit = "m/s",
       .range = at_least(0),
       .default_note =
           "1e-6; of scenes with ice that moves the power of ten below a thousandth of the largest speed that "
           "the scene names",
       .doc = "Residual of the law (law_map_m_s) at which the solver stops; 0: always max_iterations sweeps."},
      {.name = "max_iterations",
       .type = ValueType::integer,
       .range = within(1, 1e9),
       .default_value = "1000",
       .doc = "Largest number of iterations in one step."},
      {.name = "on_failure",
       .type = ValueType::choice,
       .choices = {"record", "stop", "retry"},
       .default_value = "record",
       .doc = "What happens when the solver misses its tolerance: record goes on and says so in the outputs, stop ends "
              "the run, retry climbs the ladder of auto from the impulses found so far."},
      {.name = "warm_start",
       .type = ValueType::boolean,
       .default_value = "true",
       .doc = "Start each solve from the impulses of the step before."},
      {.name = "axes_deg",
       .unit = "deg",
       .default_value = "0",
       .doc = "Turns the contact tangents about the normal; it matters to the pyramid laws only."},
  };
}

static std::vector<AttributeSpec> time_stepping() {
  return {
      {.name = "integrator",
       .type = ValueType::choice,
       .choices = {"moreau", "semi-implicit-euler", "reference"},
       .default_note = "moreau; with substeps above 1 semi-implicit-euler",
       .doc =
           "How velocities and positions advance: impulses in the middle of the motion (moreau) or before it; or, for "
           "few free bodies and a vessel that touches few of them, between impacts and other events at their own "
           "instants, with a local "
           "error of 1e-15 per step in free motion and 1e-13 on closed contacts (reference: detection and "
           "stabilisation have no part in it)."},
      {.name = "theta",
       .range = within(0, 1),
       .default_value = "0.5",
       .applies = {"integrator", {"moreau"}},
       .doc =
           "Share of the step's motion that follows the impulses; 0.5 is of second order and keeps energies bounded."},
      {.name = "gyroscopic",
       .type = ValueType::boolean,
       .default_value = "true",
       .doc = "Keep the gyroscopic torque of spinning bodies."},
      {.name = "detection",
       .type = ValueType::choice,
       .choices = {"discrete", "speculative", "continuous"},
       .default_value = "continuous",
       .doc = "Which gaps at the step's start enter the problem: those that the step can close, but none above the "
              "thinner body's thickness, so that what goes farther in a step can pass (discrete, as in older tools); "
              "all that the step can close (speculative; with moreau: in what follows the impulses); the same, and for "
              "pairs that move more than half their "
              "thickness against each other, what they meet on their way (continuous: nothing passes)."},
      {.name = "narrow_phase",
       .type = ValueType::choice,
       .choices = {"nilas", "fcl", "nilas-alone"},
       .default_value = "nilas",
       .doc =
           "Who finds the contacts of two convex parts: the exact search, which FCL's first answer shortens (nilas); "
           "FCL's own points, normals and depths, completed to manifolds (fcl); the exact search without FCL in "
           "front of it (nilas-alone). Hulls that crush ice and the reference integrator have searches of their own."},
      {.name = "substeps",
       .type = ValueType::integer,
       .range = within(0, 1000),
       .default_value = "0",
       .applies = {"detection", {"continuous"}},
       .doc = "Cuts a step at the first impact of a fast pair, and again, into at most so many parts; 0 or 1: such "
              "impacts enter the step as gaps. Not with moreau."},
      {.name = "margin",
       .unit = "m",
       .range = at_least(0),
       .default_value = "0",
       .doc = "Gap within which contacts enter the problem: with discrete in place of what the bodies can reach in the "
              "step (0: that, along chains of hits), else beside it."},
      {.name = "stabilisation",
       .type = ValueType::choice,
       .choices = {"none", "baumgarte", "split-impulse", "tasora", "projection"},
       .default_value = "projection",
       .doc = "How penetration that has come about is taken back: not; by velocities that push it out (a share per "
              "step, or "
              "all of it); by pseudo velocities; or by moving the bodies apart after the step."},
      {.name = "erp",
       .range = within(0, 1),
       .default_value = "0.2",
       .applies = {"stabilisation", {"baumgarte", "split-impulse"}},
       .doc = "Share of the penetration removed per step; the others remove all."},
      {.name = "slop",
       .unit = "m",
       .range = at_least(0),
       .default_value = "0",
       .applies = {"stabilisation", {"baumgarte", "split-impulse", "tasora", "projection"}},
       .doc = "Penetration that is left alone."},
      {.name = "max_speed",
       .unit = "m/s",
       .range = above(0),
       .default_value = "1",
       .applies = {"stabilisation", {"baumgarte", "split-impulse", "tasora"}},
       .doc = "Largest speed of the correction."},
  };
}

static ElementSpec friction() {
  return {.name = "friction",
          .parent = "contact",
          .count = Count::many,
          .doc =
              "Friction and restitution between two materials. A touching pair that is not named is frictionless, "
              "and the run says so once.",
          .attributes = {
              {.name = "between",
               .type = ValueType::words,
               .min_count = 2,
               .max_count = 2,
               .required = true,
               .doc = "Two materials: ice, hull, wall, structure, a body's own material, or * for any."},
              {.name = "static",
               .range = at_least(0),
               .default_note = "as kinetic",
               .doc = "Coefficient of static friction: what a contact at rest holds. Not below the kinetic one."},
              {.name = "kinetic",
               .range = at_least(0),
               .default_note = "as static",
               .doc = "Coefficient of kinetic friction; not above the static one."},
              {.name = "rolling",
               .unit = "m",
               .range = at_least(0),
               .default_value = "0",
               .doc = "Rolling friction: the moment against rolling is at most this length times the normal force."},
              {.name = "spinning",
               .unit = "m",
               .range = at_least(0),
               .default_value = "0",
               .doc = "Spinning friction: the same for the moment about the normal."},
              {.name = "restitution",
               .range = within(0, 1),
               .default_value = "0",
               .doc = "Newton's coefficient of restitution."}}};
}

std::vector<ElementSpec> contact_elements() {
  ElementSpec contact{.name = "contact",
                      .parent = "scene",
                      .always = true,
                      .doc = "How bodies touch: law, solver, time stepping and the correction of penetration.",
                      .attributes = law_and_solver()};
  for (auto& attribute : time_stepping()) contact.attributes.push_back(attribute);
  return {contact, friction()};
}

}  // namespace nilas::schema_table
