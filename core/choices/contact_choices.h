#pragma once
/// Choices of a scene's <contact> besides law and solver.
#include "core/choices/choice.h"

namespace nilas {

/// Named sets of defaults.
enum class ContactPreset { metrikin_2014 };
constexpr ChoiceText choice_text(ContactPreset value) {
  switch (value) {
    case ContactPreset::metrikin_2014:
      return {"metrikin-2014",
              "It sets law pyramid, solver pgs with tolerance 0 and 50 sweeps, stabilisation split-impulse, detection "
              "discrete, integrator semi-implicit-euler and gyroscopic false.",
              "seed-2014"};
  }
  return {};
}

/// The reaction when the solver misses its tolerance.
enum class OnFailure { record, stop, retry };
constexpr ChoiceText choice_text(OnFailure value) {
  switch (value) {
    case OnFailure::record:
      return {"record", "The run continues and the outputs report it."};
    case OnFailure::stop:
      return {"stop", "The run ends."};
    case OnFailure::retry:
      return {"retry", "The solver `auto` continues from the impulses found so far."};
  }
  return {};
}

/// How velocities and positions advance over a step.
enum class Integrator { moreau, semi_implicit_euler, reference };
constexpr ChoiceText choice_text(Integrator value) {
  switch (value) {
    case Integrator::moreau:
      return {"moreau", "Contact impulses act in the middle of the step's motion."};
    case Integrator::semi_implicit_euler:
      return {"semi-implicit-euler", "Contact impulses act before the step's motion."};
    case Integrator::reference:
      return {"reference",
              "Every impact and event is resolved at its own instant. The local error per step is 1e-15 in free motion "
              "and 1e-13 in closed contact. It suits few free bodies and a vessel that touches few of them. It "
              "ignores detection and stabilisation."};
  }
  return {};
}

/// Which gaps at the start of a step become contacts, and whether fast pairs are followed along their path.
enum class Detection { discrete, speculative, continuous };
constexpr ChoiceText choice_text(Detection value) {
  switch (value) {
    case Detection::discrete:
      return {"discrete",
              "Gaps that the step can close become contacts, up to the thickness of the thinner body. A faster body "
              "can pass through."};
    case Detection::speculative:
      return {"speculative",
              "All gaps that the step can close become contacts. With integrator moreau only the motion after the "
              "impulses counts."};
    case Detection::continuous:
      return {"continuous",
              "As speculative. Pairs that move by more than half their thickness are also followed along their path, "
              "so that nothing passes through."};
  }
  return {};
}

/// Who finds the contacts of a pair of convex pieces.
enum class NarrowPhase {
  nilas,       ///< the exact search, after FCL's first answer for pairs without a kept axis
  fcl,         ///< FCL's own distance and penetration, completed to manifolds
  nilas_alone  ///< the exact search without FCL in front of it
};
constexpr ChoiceText choice_text(NarrowPhase value) {
  switch (value) {
    case NarrowPhase::nilas:
      return {"nilas", "An exact search is used, and FCL's first answer shortens it."};
    case NarrowPhase::fcl:
      return {"fcl", "FCL gives points, normals and depths, which are completed to contact patches."};
    case NarrowPhase::nilas_alone:
      return {"nilas-alone", "The exact search is used without FCL."};
  }
  return {};
}

/// How existing penetration is removed.
enum class Stabilisation { none, baumgarte, split_impulse, tasora, projection };
constexpr ChoiceText choice_text(Stabilisation value) {
  switch (value) {
    case Stabilisation::none:
      return {"none", "Penetration stays."};
    case Stabilisation::baumgarte:
      return {"baumgarte", "A contact velocity removes a share of it per step."};
    case Stabilisation::split_impulse:
      return {"split-impulse", "Pseudo-velocities, which add no momentum, remove a share of it per step."};
    case Stabilisation::tasora:
      return {"tasora", "A contact velocity removes all of it per step."};
    case Stabilisation::projection:
      return {"projection", "The bodies are moved apart after the step."};
  }
  return {};
}

}  // namespace nilas
