#pragma once
/// Differences between settings within the same realisation.
#include "apps/compare/scenes/judge/findings.h"

namespace nilas::compare {

/// The difference of the mean loads of the first setting and its perturbed run in a realisation [N]; nothing if one of
/// them is not done.
std::optional<double> perturbed_difference(const RunTable& rows, const std::string& headline, int realisation);

/// Sets Merit::from_reference and Merit::from_own over the realisations of each setting.
std::vector<Merit> with_paired_differences(const Plan& plan, const Findings& found);

/// The settings that solve the law of the first with the same steps and at least as tightly, so that their runs should
/// differ by chance only. They are at least as tight as 1e-6 m/s if the first makes a fixed number of sweeps. The first
/// is among them if it has a tolerance.
std::vector<std::size_t> alike_settings(const Plan& plan);

/// The widest chance limit of a difference over all settings and realisations [N]; 0 if none was measured. `member`:
/// Merit::from_reference or Merit::from_own.
double widest_limit(const std::vector<Merit>& merits, PairedDifference Merit::*member);

}  // namespace nilas::compare
