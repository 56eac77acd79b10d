#pragma once
/// Choices of a scene's bodies.
#include "core/choices/choice.h"

namespace nilas {

/// Shapes of <body> and <part>.
enum class SolidShapeKind { box, sphere, cylinder, mesh, plane };
constexpr ChoiceText choice_text(SolidShapeKind value) {
  switch (value) {
    case SolidShapeKind::box:
      return {"box", "Its edges lie along the body's axes."};
    case SolidShapeKind::sphere:
      return {"sphere", "It has a radius."};
    case SolidShapeKind::cylinder:
      return {"cylinder", "Its axis is the body's z axis."};
    case SolidShapeKind::mesh:
      return {"mesh", "It is read from a file."};
    case SolidShapeKind::plane:
      return {"plane", "It is the half space below the body's z = 0 and is always fixed."};
  }
  return {};
}

}  // namespace nilas
