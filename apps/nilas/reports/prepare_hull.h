#pragma once
/// From a user's file to a hull.
#include <algorithm>
#include <functional>
#include <optional>
#include <thread>

#include "apps/nilas/reports/hull_report.h"
#include "core/hull/hull_axes.h"
#include "core/hull/new_hull_folder.h"

namespace nilas {

/// How `nilas hull` reads and treats a mesh file; what is not given follows from the size of the mesh.
struct HullPreparation {
  double scale = 1;                    ///< metres per unit of the file
  MeshAxes axes;                       ///< of the file, that point forward and up
  std::optional<double> gap;           ///< points this close are one; default 1e-5 of the longest side [m]
  std::optional<double> largest_hole;  ///< filled; default a twentieth of the longest side [m]
  std::optional<double> tolerance;     ///< of the parts; default a thousandth of the longest side [m]
  std::size_t most_parts = 64;
  int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::function<void(const char* stage)> stage_done;  ///< hears of "read", "mend" and "decompose" as they end
  std::optional<double> draught;  ///< of the waterline that the report takes; default half the height [m]
};

/// Reads, mends, decomposes; a hull folder is taken as it is. Throws InputError naming the file where the mesh cannot
/// be mended, with the places, after publishing a picture of them in `folder`, and for a draught that the hull does not
/// have; FileError.
PreparedHull prepare_hull(const std::filesystem::path& mesh, const HullPreparation& how, NewHullFolder& folder);

}  // namespace nilas
