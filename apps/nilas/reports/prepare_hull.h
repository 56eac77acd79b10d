#pragma once
/// Makes a hull from a user's file.
#include <algorithm>
#include <functional>
#include <optional>
#include <thread>

#include "apps/nilas/reports/hull_report.h"
#include "core/hull/hull_axes.h"
#include "core/hull/new_hull_folder.h"

namespace nilas::commands {

/// How `nilas hull` reads and treats a mesh file. Values that are not given follow from the size of the mesh.
struct HullPreparation {
  double scale = 1;                    ///< metres per unit of the file
  hull::MeshAxes axes;                 ///< the axes of the file that point forward and up
  std::optional<double> gap;           ///< points this close are merged; default 1e-5 of the longest side [m]
  std::optional<double> largest_hole;  ///< the largest hole that is filled; default 1/20 of the longest side [m]
  std::optional<double> tolerance;     ///< tolerance of the convex parts; default 1/1000 of the longest side [m]
  std::size_t most_parts = 64;
  int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::function<void(const char* stage)> stage_done;  ///< called with "read", "mend" and "decompose" as they end
  std::optional<double> draught;  ///< draught of the report's waterline; default half the height [m]
};

/// Reads, mends and decomposes a mesh file; a hull folder is taken as it is. If the mesh cannot be mended, publishes a
/// picture of the places in `folder` and throws InputError with the file and the places. Throws InputError for a
/// draught that the hull does not have, and FileError.
PreparedHull prepare_hull(const std::filesystem::path& mesh, const HullPreparation& how, hull::NewHullFolder& folder);

}  // namespace nilas::commands
