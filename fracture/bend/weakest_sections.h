#pragma once
/// Where wedges of ice that is not alike everywhere break.
#include <vector>

#include "fracture/bend/wedge_series.h"
#include "fracture/cut/crack_lines.h"
#include "fracture/cut/local_ice.h"

namespace nilas {

struct WeakestSections {
  double strength = 1;        ///< of all wedges together, over that of wedges as strong as the ice at the load
  std::vector<double> radii;  ///< distance from the apex of the weakest section of each ray of wedge_cracks [m]
};

/// A wedge breaks where its stress over the local strength is largest, judged along its middle: stress as in Nevel's
/// wedge loaded over a / l, with its x_max at the fan's radius, by samples each twentieth of that from 0.1 to 3 of it,
/// and where weak lines cross. The rays between them say where the crack runs, not when. `flexural_strength` [Pa] is
/// that at the load, > 0. Throws ContractError as wedge_curvatures.
WeakestSections weakest_sections(const WedgeFan& fan, double a_over_l, double flexural_strength, const LocalIce& ice);

}  // namespace nilas
