#pragma once
/// Initial places of the floes, with overlaps.
#include <vector>

#include "core/base/random.h"
#include "core/field/spec/loose_floe.h"

namespace nilas::field {

/// Gives each floe a random angle and, of several random places outside the obstacles, the one with the least overlap
/// of circles with earlier floes (Mitchell's best candidate). The ice then starts evenly spread. Floes must be sorted
/// largest first.
void place_floes(std::vector<LooseFloe>& floes, const FieldBounds& bounds, RandomStream& random);

/// A random point of the region outside all obstacles.
Vec2 random_place(const FieldBounds& bounds, RandomStream& random);

}  // namespace nilas::field
