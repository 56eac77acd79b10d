#pragma once
/// The pictures of a comparison.
#include <filesystem>
#include <string>
#include <vector>

#include "apps/compare/scenes/report/scene_report.h"
#include "apps/compare/workshop/picture.h"

namespace nilas {

/// Those that there is something to draw for: differences (run by run on the same ice), front (computing time against
/// the error that ranks the settings), motion (against the distance from the reference), steps (error against step); of
/// an ablation that one alone.
std::vector<Picture> pictures_of(const SceneReport& report);

struct Drawings {
  std::vector<std::string> drawn;  ///< names without ending
  std::string trouble;             ///< why others are missing: gnuplot is, or fails
};

/// Writes SVG and PNG of each into the folder.
Drawings draw(const std::filesystem::path& folder, const std::vector<Picture>& pictures);

}  // namespace nilas
