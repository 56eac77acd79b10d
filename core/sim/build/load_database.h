#pragma once
/// Reads the hydrodynamic database that a scene names.
#include "core/sim/world/world.h"

namespace nilas::sim {

/// Reads and checks the database of <hydro><database>, which must be there, once the vessel of `parts` is built.
/// Throws FileError, and InputError for a file that cannot be read so or that contradicts itself: an asymmetric matrix,
/// reversed damping or phases, a wrong length. Smaller doubts are kept in the result, among them a displaced volume
/// more than 5 % beside that of the hull, and a density more than 2 % beside that of the scene's water.
VesselDatabase load_database(const scene::Scene& scene, const WorldParts& parts);

}  // namespace nilas::sim
