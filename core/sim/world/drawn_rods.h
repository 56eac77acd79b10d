#pragma once
/// The rods that hold a vessel, for pictures.
#include <vector>

#include "core/bodies/drawn_line.h"
#include "core/sim/world/world.h"

namespace nilas::sim {

/// A line for each rod from the vessel to its fixed end at the present poses, with its tension in the last step. Before
/// the first step the tension is 0.
std::vector<bodies::DrawnLine> drawn_rods(const WorldParts& parts);

}  // namespace nilas::sim
