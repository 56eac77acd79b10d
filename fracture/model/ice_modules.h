#pragma once
/// The models of breakable ice as modules of the time step. `ice` and `warnings` must outlive them.
#include <memory>

#include "core/base/log.h"
#include "core/bodies/ice_properties.h"
#include "core/bodies/module.h"
#include "fracture/model/breaking.h"
#include "fracture/model/crushing.h"

namespace nilas::fracture {

/// Makes the module "crushing". It owns the contacts of breakable floes with the vessel and with bodies, and with
/// `between_floes` those of floes. It has the column crushed_overlap_max_m and the total "crushed_mass" [kg].
std::unique_ptr<bodies::Module> make_crushing(const CrushingSettings& settings, const bodies::Bodies& bodies,
                                              const bodies::IceProperties& ice, WarningCounts& warnings);

/// Makes the module "breaking". It notes loads on floes and names those that fail. Its number of a body is "damage"
/// [-].
std::unique_ptr<bodies::Module> make_breaking(const BreakingSettings& settings, const bodies::IceProperties& ice);

/// Makes the module "pieces". It replaces floes that fail by their pieces. It must be listed after the modules that
/// name failures. Its totals are "brash_mass" and "extruded_mass" [kg].
std::unique_ptr<bodies::Module> make_pieces(const PieceLimits& limits, bodies::IceProperties& ice,
                                            WarningCounts& warnings);

}  // namespace nilas::fracture
