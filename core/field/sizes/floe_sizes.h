#pragma once
/// Sizes of the floes of a packed field.
#include <vector>

#include "core/base/random.h"
#include "core/field/spec/field_spec.h"

namespace nilas {

/// Areas [m^2], largest first, whose sum is `wanted` [m^2] to within half a floe. sqrt(area) follows the spec's
/// distribution, clipped to min..max; uniform spans mean +- sqrt(3) sd, power_law spans min..max.
std::vector<double> draw_areas(const PackedSpec& spec, double wanted, RandomStream& random);
/// The size sqrt(area) [m] that is undercut with probability u in [0, 1] in the distribution that draw_areas draws
/// from.
double size_quantile(const PackedSpec& spec, double u);

}  // namespace nilas
