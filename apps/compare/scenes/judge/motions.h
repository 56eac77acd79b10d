#pragma once
/// The motions of the runs of a comparison: how long they can be predicted, and their distances until then.
#include <filesystem>

#include "apps/compare/scenes/judge/findings.h"

namespace nilas::compare {

/// Whether the first setting's runs of all shared realisations begin with bodies in the same places. `folder`, here and
/// below: folder of the comparison, in which runs/<id>/bodies.csv hold the motions. Throws FileError.
bool same_ice(const RunTable& rows, const std::vector<int>& shared, const std::filesystem::path& folder);

/// The predictability horizon. A run and its perturbed run diverge exponentially. Motions are compared until the two
/// differ by a ten thousandth of the longest path of a body.
Horizon horizon_of(const Plan& plan, const RunTable& rows, const std::filesystem::path& folder);

/// Sets RunRow::motion.
RunTable with_motion_errors(const Plan& plan, const Horizon& horizon, const std::filesystem::path& folder,
                            RunTable rows);

/// The measure: the mean load if ice loads the vessel, else the distance of bodies, or the attitude of bodies that spin
/// in place.
Measure measure_of(const RunTable& rows, const std::string& headline, const JudgingLoads& reference,
                   const std::filesystem::path& folder);

}  // namespace nilas::compare
