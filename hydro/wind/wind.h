#pragma once
/// The module of the wind on the vessel and on floes.
#include <cstdint>
#include <memory>
#include <optional>

#include "core/bodies/module.h"
#include "hydro/wind/wind_area.h"
#include "hydro/wind/wind_speed.h"

namespace nilas::hydro {

/// The vessel as the wind sees it.
struct WindOnVessel {
  int hull = 0;                 ///< index of the hull
  Vec3 midship = Vec3::Zero();  ///< a point of the midship section, from the centre of mass of the hull, in V [m]
  WindArea area;
};

/// Makes the module.
///
/// On the vessel act the load of wind_area.h. V is the wind at the height of the centroid of the lateral area, less the
/// velocity of the midship section. X acts at that height too. The axes are those of V, turned upright; heel and trim
/// change no area.
///
/// On each free floe whose upper face is dry acts the drag of the wind at 10 m [m/s],
///   F = rho C_a A |w| w,  w = U_10 - v,
/// at the centroid of that face; A is its area seen from above, v the horizontal velocity of the floe, and C_a the drag
/// coefficient [Guest, Davidson 1991: 1.5e-3 smooth first-year ice, 2.0e-3 to 2.2e-3 pack, 3.1e-3 to 3.4e-3 at the ice
/// edge, 8e-3 very rough]. As usual in geophysics there is no factor 1/2. Structures and other bodies take none.
///
/// `level` is z of still water [m]; `seed` is that of the scene.
std::unique_ptr<bodies::ForceModule> make_wind(const WindSettings& settings, double level, std::uint64_t seed,
                                               const std::optional<WindOnVessel>& vessel);

}  // namespace nilas::hydro
