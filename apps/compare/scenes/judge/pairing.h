#pragma once
/// Differences between settings, run by run in the same realisation.
#include "apps/compare/scenes/judge/findings.h"

namespace nilas {

/// Sets Merit::from_reference and Merit::from_own over the realisations of each setting.
std::vector<Merit> with_paired_differences(const Plan& plan, const Findings& found);

/// Settings that solve the law of the first with the same steps and at least as tightly (where it runs a fixed number
/// of sweeps: to 1e-6 m/s): runs of them should not differ but by chance. Holds the first where it has a tolerance.
std::vector<std::size_t> alike_settings(const Plan& plan);

}  // namespace nilas
