#pragma once
/// Motions of the runs of a comparison: how long they can be predicted, and how far they are apart until then.
#include <filesystem>

#include "apps/compare/scenes/judge/findings.h"

namespace nilas {

/// Whether the first setting's runs of all shared realisations begin with bodies in the same places. `folder`: of the
/// comparison, here and below; runs/<id>/bodies.csv hold the motions. Throws FileError.
bool same_ice(const RunTable& rows, const std::vector<int>& shared, const std::filesystem::path& folder);

/// A run and its perturbed run part exponentially. As soon as they are apart by a ten thousandth of the longest path of
/// a body, motions are no longer compared.
Horizon horizon_of(const Plan& plan, const RunTable& rows, const std::filesystem::path& folder);

/// Sets RunRow::motion.
RunTable with_motion_errors(const Plan& plan, const Horizon& horizon, const std::filesystem::path& folder,
                            RunTable rows);

/// The mean load where ice loads the vessel; else the distance of bodies, or the attitude of one that spins in place.
Measure measure_of(const RunTable& rows, const std::string& headline, const ReferenceLoads& reference,
                   const std::filesystem::path& folder);

}  // namespace nilas
