#pragma once
/// The pictures of a comparison.
#include <filesystem>
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/merits.h"
#include "apps/compare/scenes/run/study_folder.h"

namespace nilas {

struct Drawings {
  std::vector<std::string> drawn;  ///< names without ending
  std::string trouble;             ///< why others are missing: gnuplot is, or fails
};

/// Writes SVG and PNG of each picture that there is something to draw for: front (time against the primary error),
/// motion (against the distance from the reference), steps (error against step), ablation.
Drawings draw_study(const std::filesystem::path& folder, const Study& study, const Findings& found,
                    const std::vector<std::string>& labels);

}  // namespace nilas
