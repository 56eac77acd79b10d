#pragma once
/// The law of the pressure of crushing ice. docs/theory/fracture-crushing.md
#include "core/choices/fracture_choices.h"

namespace nilas::fracture {

struct CrushingLaw {
  CrushingModel model = CrushingModel::explicit_area;
  double coefficient = 0;         ///< Pressure of pressure_area on 1 m^2 [Pa m^(-2 exponent)].
  double exponent = 0;            ///< Exponent of pressure_area, above -1.
  double reference_strength = 1;  ///< Compressive strength that the coefficient belongs to [Pa].

  bool is_implicit() const { return model != CrushingModel::explicit_area; }
  /// The pressure [Pa] of ice with this compressive strength [Pa] that crushes on `area` [m^2] in all. It is the
  /// strength, or for pressure_area
  ///   p = coefficient (strength / reference_strength) area^exponent,
  /// so that the force p area grows with the area to the power 1 + exponent. It is 0 where there is no area.
  double pressure(double strength, double area) const;
};

}  // namespace nilas::fracture
