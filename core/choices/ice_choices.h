#pragma once
/// Choices of a scene's <ice>.
#include "core/choices/choice.h"

namespace nilas {

enum class FieldKind { packed, voronoi, grid, level, channel, file };
constexpr ChoiceText choice_text(FieldKind value) {
  switch (value) {
    case FieldKind::packed:
      return {"packed", "Random floes are pushed apart until none overlap."};
    case FieldKind::voronoi:
      return {"voronoi", "The region is divided into cells, which are then shrunk to the concentration."};
    case FieldKind::grid:
      return {"grid", "The region is cut into equal pieces, as in a pre-sawn test."};
    case FieldKind::level:
      return {"level", "One intact sheet fills the region."};
    case FieldKind::channel:
      return {"channel", "Packed floes lie between two fixed sheets."};
    case FieldKind::file:
      return {"file", "The floes are read from a file."};
  }
  return {};
}

/// Outlines of packed floes.
enum class FloeShape {
  polygon,
  rectangle,
  square,
  parallelogram,
  disc,
  library  ///< drawn from given outlines; asked for by their file, not by name
};
constexpr ChoiceText choice_text(FloeShape value) {
  switch (value) {
    case FloeShape::polygon:
      return {"polygon", "The outlines are random convex polygons."};
    case FloeShape::rectangle:
      return {"rectangle"};
    case FloeShape::square:
      return {"square"};
    case FloeShape::parallelogram:
      return {"parallelogram"};
    case FloeShape::disc:
      return {"disc"};
    case FloeShape::library:
      return {};
  }
  return {};
}

/// Distributions of the floe size, the square root of the area.
enum class SizeDistribution { fixed, uniform, lognormal, power_law, as_library };
constexpr ChoiceText choice_text(SizeDistribution value) {
  switch (value) {
    case SizeDistribution::fixed:
      return {"fixed", "All floes have the mean size."};
    case SizeDistribution::uniform:
      return {"uniform", "All sizes between min and max are equally likely."};
    case SizeDistribution::lognormal:
      return {"lognormal", "The lognormal distribution is cut at min and max."};
    case SizeDistribution::power_law:
      return {"power-law", "The power law is cut at min and max."};
    case SizeDistribution::as_library:
      return {"as-library", "The outlines of <shape library> keep their sizes."};
  }
  return {};
}

/// Properties of a floe that a scene may vary. Strengths are attributes of <fracture>.
enum class FloeProperty { thickness, density, flexural_strength, compressive_strength, fracture_toughness };
constexpr ChoiceText choice_text(FloeProperty value) {
  switch (value) {
    case FloeProperty::thickness:
      return {"thickness"};
    case FloeProperty::density:
      return {"density"};
    case FloeProperty::flexural_strength:
      return {"flexural_strength"};
    case FloeProperty::compressive_strength:
      return {"compressive_strength"};
    case FloeProperty::fracture_toughness:
      return {"fracture_toughness"};
  }
  return {};
}

/// Distributions of a property over the floes.
enum class SpreadKind { normal, lognormal, uniform, weibull };
constexpr ChoiceText choice_text(SpreadKind value) {
  switch (value) {
    case SpreadKind::normal:
      return {"normal"};
    case SpreadKind::lognormal:
      return {"lognormal"};
    case SpreadKind::uniform:
      return {"uniform"};
    case SpreadKind::weibull:
      return {"weibull", "It is allowed for strengths only."};
  }
  return {};
}

}  // namespace nilas
