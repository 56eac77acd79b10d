#pragma once
/// Choices of a scene's <fracture>.
#include "core/choices/choice.h"

namespace nilas {

/// How hard crushing ice presses.
enum class CrushingModel { explicit_area, pressure_area, compliant };
constexpr ChoiceText choice_text(CrushingModel value) {
  switch (value) {
    case CrushingModel::explicit_area:
      return {"explicit",
              "The normal force is at most the compressive strength times the contact area at the start of the step.",
              "seed-limit"};
    case CrushingModel::pressure_area:
      return {
          "pressure-area",
          "As compliant, but the pressure is `coefficient * area^exponent`, scaled by the floe's strength over that "
          "of <fracture>."};
    case CrushingModel::compliant:
      return {"compliant", "As explicit, but the growth of the area within the step is taken implicitly."};
  }
  return {};
}

enum class BendingModel { nevel };
constexpr ChoiceText choice_text(BendingModel value) {
  switch (value) {
    case BendingModel::nevel:
      return {"nevel",
              "Radial cracks form when the edge of a half-infinite plate on water reaches the flexural strength. The "
              "wedges between them are narrow beams that break where their stress is largest."};
  }
  return {};
}

enum class SplittingModel { geometric, lefm };
constexpr ChoiceText choice_text(SplittingModel value) {
  switch (value) {
    case SplittingModel::geometric:
      return {"geometric",
              "A floe whose edge has cracked radially splits along the shortest chord in the load's direction. The "
              "chord must be longer than the breaking length in bending and shorter than `multiplier` times it.",
              "seed-geometric"};
    case SplittingModel::lefm:
      return {"lefm",
              "A floe splits where half the sum of the forces across that chord reaches its capacity. The capacity "
              "follows from its length, width and fracture toughness."};
  }
  return {};
}

/// Paths of cracks.
enum class CrackPathKind { straight, curved };
constexpr ChoiceText choice_text(CrackPathKind value) {
  switch (value) {
    case CrackPathKind::straight:
      return {"straight", "Cracks are straight, and the ice is as strong everywhere as at the load."};
    case CrackPathKind::curved:
      return {"curved",
              "Cracks follow weak ice: <weak_line>, the seams of <bond>, and strengths that vary within a floe. A "
              "splitting crack turns to where a kink releases most energy for the toughness there. A wedge breaks "
              "where stress over strength is largest."};
  }
  return {};
}

/// The treatment of pieces below the smallest area or longer than the largest aspect ratio.
enum class SmallPieces { brash, refuse };
constexpr ChoiceText choice_text(SmallPieces value) {
  switch (value) {
    case SmallPieces::brash:
      return {"brash", "They are removed from the bodies, and the outputs give their mass (brash_kg)."};
    case SmallPieces::refuse:
      return {"refuse", "The floe is not cut where a cut would leave one."};
  }
  return {};
}

}  // namespace nilas
