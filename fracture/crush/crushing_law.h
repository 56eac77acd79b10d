#pragma once
/// How hard crushing ice presses. docs/theory/fracture-crushing.md
#include "core/choices/fracture_choices.h"

namespace nilas {

struct CrushingLaw {
  CrushingModel model = CrushingModel::explicit_area;
  double coefficient = 0;         ///< of pressure_area: pressure on 1 m^2 [Pa m^(-2 exponent)]
  double exponent = 0;            ///< of pressure_area, above -1
  double reference_strength = 1;  ///< compressive strength that the coefficient belongs to [Pa]

  bool is_implicit() const { return model != CrushingModel::explicit_area; }
  /// Of ice with this compressive strength [Pa] that crushes on `area` in all [m^2]: the strength; for pressure_area
  ///   p = coefficient (strength / reference_strength) area^exponent,
  /// so that the force p area grows with the area to 1 + exponent (ISO 19906 form; Popov's collision with -0.1 in Daley
  /// 1999). 0 for no area.
  double pressure(double strength, double area) const;
};

}  // namespace nilas
