#pragma once
/// Sizes of the floes of a packed field.
#include <vector>

#include "core/base/random.h"
#include "core/field/spec/field_spec.h"

namespace nilas::field {

/// Areas [m^2], largest first, whose sum is `wanted` [m^2] to within half a floe. sqrt(area) follows the spec's
/// distribution, clipped to min..max; uniform spans mean +- sqrt(3) sd, power_law spans min..max.
std::vector<double> draw_areas(const PackedSpec& spec, double wanted, RandomStream& random);
/// The quantile of probability u in [0, 1] of the size sqrt(area) [m] in the distribution of draw_areas.
double size_quantile(const PackedSpec& spec, double u);

}  // namespace nilas::field
