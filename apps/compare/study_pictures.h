#pragma once
/// The pictures of a comparison, drawn from settings.csv.
#include <filesystem>
#include <string>
#include <vector>

#include "apps/compare/merits.h"
#include "apps/compare/study_folder.h"

namespace nilas {

/// Writes SVG and PNG of each picture that there is something to draw for and returns their names without ending:
/// front (time against the primary error), motion (against the distance from the reference), steps (error against
/// step), ablation. Throws FileError where gnuplot is missing or fails.
std::vector<std::string> draw_study(const std::filesystem::path& folder, const Study& study, const Findings& found,
                                    const std::vector<std::string>& labels);

}  // namespace nilas
