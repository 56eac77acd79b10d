#pragma once
/// The sections at which wedges of ice break whose strength varies from place to place.
#include <vector>

#include "fracture/bend/wedge_series.h"
#include "fracture/cut/crack_lines.h"
#include "fracture/cut/local_ice.h"

namespace nilas::fracture {

struct WeakestSections {
  double strength = 1;        ///< Load of all wedges, over that of wedges as strong as the ice at the load.
  std::vector<double> radii;  ///< Distance of the weakest section of each ray of wedge_cracks from the apex [m].
};

/// Finds the weakest sections. A wedge breaks where its stress over the local strength is largest along its middle. The
/// stress is that of a wedge loaded over a / l, with x_max at the fan's radius. It is sampled at each twentieth of the
/// radius, from 0.1 to 3 of it, and where weak lines cross. The rays between the wedges decide where the crack runs,
/// not when the wedges break. `flexural_strength` [Pa] is that at the load. Throws ContractError unless it is positive,
/// and where wedge_curvatures does.
WeakestSections weakest_sections(const WedgeFan& fan, double a_over_l, double flexural_strength, const LocalIce& ice);

}  // namespace nilas::fracture
