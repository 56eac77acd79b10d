#pragma once
/// Which runs of a comparison are set against each other.
#include "apps/compare/scenes/judge/merits.h"

namespace nilas {

/// Sets Merit::from_reference and Merit::from_own, over the realisations of the setting.
void pair_up(const Plan& plan, Findings& found);

/// Settings that solve what the first does, with the same steps and at least as tightly (where it goes by sweeps: to
/// 1e-6 m/s): runs of them differ in what should not matter. Holds the first where it has a tolerance.
std::vector<std::size_t> alike_settings(const Plan& plan);

}  // namespace nilas
