#pragma once
/// What of a run is drawn: its vessel, or the bodies that its scene holds fixed.
#include <filesystem>
#include <string>
#include <vector>

#include "apps/report/contact_picture.h"
#include "core/sim/simulation.h"

namespace nilas {

/// Picture of the contacts of a run about chosen times [s], up to `half_width` before and after each. `body`: name of
/// the vessel or of a fixed body; empty: the vessel, of a run without one all fixed bodies. `notes`: what the picture
/// lacks, as sentences. Throws FileError, and InputError where the run has nothing to draw.
ContactPictureInput contact_picture(const std::filesystem::path& run_folder, const Scene& scene,
                                    const Simulation& simulation, const std::string& body,
                                    const std::vector<double>& times, double half_width,
                                    std::vector<std::string>& notes);

}  // namespace nilas
