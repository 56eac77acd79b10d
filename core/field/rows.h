#pragma once
/// Rows of equal floes: the only arrangement of equal squares, rectangles or parallelograms denser than about 90 %.
#include <vector>

#include "core/base/random.h"
#include "core/field/spec/loose_floe.h"

namespace nilas::field {

/// Lays equal floes with four corners, whose first edge is along X at angle zero, in rows along X or Y, whichever holds
/// more. Water is distributed at random between the rows and between the floes of a row, with at least `gap` [m]
/// everywhere; joints of rows do not line up. Returns the number of floes that the best rows hold. Moves nothing when
/// these are fewer than there are floes.
int place_in_rows(std::vector<LooseFloe>& floes, const FieldBounds& bounds, double gap, RandomStream& random);

}  // namespace nilas::field
