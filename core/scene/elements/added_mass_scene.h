#pragma once
/// Values of <added_mass>.
#include <optional>
#include <vector>

#include "core/base/math.h"
#include "core/choices/water_choices.h"

namespace nilas::scene {

struct AddedMassScene {
  FloeAddedMass floes = FloeAddedMass::automatic;
  VesselAddedMass vessel = VesselAddedMass::none;
  std::vector<double> matrix;  ///< six entries of the diagonal, or 36 row by row [kg, kg m, kg m^2]
  std::optional<Vec3> at;      ///< reference point of the matrix, frame V [m]; default: the centre of mass

  bool operator==(const AddedMassScene&) const = default;
};

}  // namespace nilas::scene
