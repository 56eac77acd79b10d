#pragma once
/// The models of breakable ice as modules of the time step. `ice` and `warnings` must outlive them.
#include <memory>

#include "core/base/log.h"
#include "core/bodies/ice_properties.h"
#include "core/bodies/module.h"
#include "fracture/model/breaking.h"
#include "fracture/model/crushing.h"

namespace nilas {

/// "crushing": contacts of breakable floes with the vessel and with bodies are its own. Column crushed_overlap_max_m;
/// total "crushed_mass" [kg].
std::unique_ptr<Module> make_crushing(const CrushingSettings& settings, const Bodies& bodies, const IceProperties& ice,
                                      WarningCounts& warnings);

/// "breaking": notes loads on floes and names those that fail. Of a body "damage" [-].
std::unique_ptr<Module> make_breaking(const BreakingSettings& settings, const IceProperties& ice);

/// "pieces": puts pieces in the place of floes that fail; must be listed after the modules that name failures. Totals
/// "brash_mass", "extruded_mass" [kg].
std::unique_ptr<Module> make_pieces(const PieceLimits& limits, IceProperties& ice, WarningCounts& warnings);

}  // namespace nilas
