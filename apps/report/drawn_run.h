#pragma once
/// The picture of a run: of its vessel, or of the bodies that its scene holds fixed.
#include <filesystem>
#include <string>
#include <vector>

#include "apps/report/contact_picture.h"
#include "core/sim/simulation.h"

namespace nilas::report {

/// The picture of the contacts of a run around chosen times [s], up to `half_width` [s] before and after each. `body`:
/// name of the vessel or of a fixed body; empty: the vessel, or all fixed bodies of a run without a vessel. `notes`:
/// sentences about what the picture lacks. Throws FileError, and InputError if the run has nothing to draw.
ContactPictureInput contact_picture(const std::filesystem::path& run_folder, const scene::Scene& scene,
                                    const sim::Simulation& simulation, const std::string& body,
                                    const std::vector<double>& times, double half_width,
                                    std::vector<std::string>& notes);

}  // namespace nilas::report
