#pragma once
/// Rows of equal floes: the only way in which equal squares, rectangles or parallelograms lie denser than about 90 %.
#include <vector>

#include "core/base/random.h"
#include "core/field/spec/loose_floe.h"

namespace nilas {

/// Lays equal floes of four corners, whose first edge runs along X at angle zero, in rows along X or along Y, whichever
/// holds more beside the obstacles: random water between the rows and between the floes of a row, at least `gap` [m]
/// everywhere, and joints that do not line up. Returns how many floes of this kind the best rows found hold; moves
/// nothing when these are fewer than there are floes.
int place_in_rows(std::vector<LooseFloe>& floes, const FieldBounds& bounds, double gap, RandomStream& random);

}  // namespace nilas
