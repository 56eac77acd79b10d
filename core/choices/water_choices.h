#pragma once
/// Choices of a scene's water.
#include "core/choices/choice.h"

namespace nilas {

/// The added mass of floes.
enum class FloeAddedMass { none, automatic, disc, plate };
constexpr ChoiceText choice_text(FloeAddedMass value) {
  switch (value) {
    case FloeAddedMass::none:
      return {"none", "Floes have none."};
    case FloeAddedMass::automatic:
      return {"auto", "Compact floes are discs, and floes longer than 1.5 times their width are plates."};
    case FloeAddedMass::disc:
      return {"disc", "Every floe is the disc of its area."};
    case FloeAddedMass::plate:
      return {"plate", "Every floe is the rectangle of its area and of its second moments."};
  }
  return {};
}

/// The added mass of the vessel.
enum class VesselAddedMass { none, matrix, database };
constexpr ChoiceText choice_text(VesselAddedMass value) {
  switch (value) {
    case VesselAddedMass::none:
      return {"none", "The vessel has none."};
    case VesselAddedMass::matrix:
      return {"matrix", "The scene gives it."};
    case VesselAddedMass::database:
      return {"database", "It is that of infinite frequency in the <database>."};
  }
  return {};
}

}  // namespace nilas
