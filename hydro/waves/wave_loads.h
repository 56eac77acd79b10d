#pragma once
/// The module of wave loads on vessel, floes and free bodies.
#include <memory>
#include <optional>

#include "core/bodies/module.h"
#include "hydro/water.h"
#include "hydro/waves/vessel_excitation.h"

namespace nilas::hydro {

/// First-order excitation and drift of the hull from a database.
struct DatabaseWaveLoads {
  std::shared_ptr<const Database> database;
  Vec3 origin_B = Vec3::Zero();  ///< origin of frame D of the database, in the frame of the hull's body [m]
  double yaw_BD = 0;             ///< angle from the hull's x axis to that of D, about z [rad]
  WaveDrift drift = WaveDrift::none;
};

struct WaveLoadSettings {
  std::optional<DatabaseWaveLoads> database;
  bool hull_pressure = false;  ///< Froude-Krylov loads on hull and parts, up to the actual surface of the waves
  bool floe_pressure = false;  ///< the same on free floes and free rigid bodies
};

/// Makes the module `wave_loads`. It adds nothing where a field has no waves.
///
/// Pressure: WaveSurface::load on each body, beside the buoyancy of still water that <buoyancy> adds. Surfaces are cut
/// until eight edges span the shortest wave. Bodies do not disturb the waves.
///
/// Free bodies with added mass A take A (a, r) as well, with the acceleration a of the undisturbed water at the centre
/// of mass, or at the surface where it is higher, and the angular acceleration r of a horizontal element of it. This is
/// the diffraction of waves that are long beside the body [Faltinsen 1990, 3]; without it added mass would hold a body
/// back that the water carries.
///
/// Database: VesselExcitation at the actual horizontal position of D's origin, in axes turned with the actual yaw. With
/// `hull_pressure` too, the linear Froude-Krylov load on the hull at its present pose is taken away from the
/// excitation, so that diffraction is left.
///
/// The module has a column wave_elevation_m: the height of the surface above still water at the origin of D, or of the
/// hull without a database, or at the origin of G without a vessel.
///
/// Throws InputError where a wave is shorter than twice the longest wet edge of the hull and pressure acts on the hull,
/// and where waves are outside the database.
std::unique_ptr<bodies::ForceModule> make_wave_loads(const Water& water, std::shared_ptr<const WaveField> field,
                                                     const WaveLoadSettings& settings, const bodies::Bodies& bodies,
                                                     int threads);

}  // namespace nilas::hydro
