#pragma once
/// The pictures of a comparison.
#include <filesystem>
#include <string>
#include <vector>

#include "apps/compare/scenes/report/scene_report.h"
#include "apps/compare/workshop/picture.h"

namespace nilas::compare {

/// The pictures for which there is something to draw. They are differences (run by run on the same ice), front
/// (computing time against the error that ranks the settings), motion (against the distance from the reference) and
/// steps (error against step). For an ablation it is the picture of the ablation alone.
std::vector<Picture> pictures_of(const SceneReport& report);

struct Drawings {
  std::vector<std::string> drawn;  ///< names without extension
  std::string trouble;             ///< why others are missing: gnuplot is missing or failed
};

/// Draws each picture into the folder as SVG and PNG.
Drawings draw(const std::filesystem::path& folder, const std::vector<Picture>& pictures);

}  // namespace nilas::compare
