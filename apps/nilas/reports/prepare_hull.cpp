#include "apps/nilas/reports/prepare_hull.h"

#include <fmt/format.h>

#include "apps/nilas/reports/hull_picture.h"
#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/geometry/mesh_box.h"

namespace nilas::commands {

namespace {

namespace fs = std::filesystem;

constexpr double k_gap_share = 1e-5, k_hole_share = 0.05, k_tolerance_share = 1e-3;  // of the longest side

/// The mesh in metres, with x forward and z up.
mesh::PolygonSoup in_vessel_frame(mesh::PolygonSoup soup, const HullPreparation& how) {
  const Mat3 R = how.axes.to_vessel();
  for (auto& p : soup.points) p = how.scale * (R * p);
  return soup;
}

/// The extent of the coordinates.
struct Reach {
  double longest = 0;   ///< longest side of the box around them [m]
  double furthest = 0;  ///< largest absolute coordinate [m]
};

/// The extent of the mesh. Throws InputError if no ship or platform has such a size.
Reach demand_sensible_size(const mesh::PolygonSoup& soup, const fs::path& file) {
  Eigen::AlignedBox3d box;
  for (const auto& loop : soup.polygons)
    for (const int v : loop) box.extend(soup.points[v]);
  const double longest = box.sizes().maxCoeff(), furthest = std::max(-box.min().minCoeff(), box.max().maxCoeff());
  constexpr double k_shortest = 1e-2, k_longest = 2e3, k_far = 1e5;  // [m]
  if (!(longest >= k_shortest && longest <= k_longest && furthest <= k_far))
    throw InputError(
        fmt::format("{}: the mesh is {:.6g} m long and reaches {:.6g} m from the origin; allowed: {} m to "
                    "{} m long, within {} m (--scale 0.001 reads a file in millimetres, --scale 0.01 one in "
                    "centimetres)",
                    file.string(), longest, furthest, k_shortest, k_longest, k_far));
  return {longest, furthest};
}

mesh::MendSettings mend_settings(const HullPreparation& how, double longest) {
  return {how.gap.value_or(k_gap_share * longest), how.largest_hole.value_or(k_hole_share * longest)};
}

double tolerance_of(const HullPreparation& how, double longest) {
  return how.tolerance.value_or(k_tolerance_share * longest);
}

/// Throws InputError for a tolerance near the size of rounding errors, with which the search would not end.
void demand_tolerance(double tolerance, double longest) {
  constexpr double k_least = 1e-6;  // of the longest side
  if (tolerance < k_least * longest)
    throw InputError(
        fmt::format("--tolerance: found {:.4g} m; allowed: at least {:.4g} m, a millionth of the longest side",
                    tolerance, k_least * longest));
}

/// Throws InputError if the mesh is so far from the origin that float32, in which STL stores coordinates, is too
/// coarse.
void demand_digits(const Reach& reach, const HullPreparation& how, const fs::path& file) {
  constexpr double k_rounding = 1.0 / (1 << 24), k_part = 0.1;  // of a coordinate, and of the tolerance
  const double moved = k_rounding * reach.furthest, tolerance = tolerance_of(how, reach.longest);
  // a gap below the default asks for thinner edges, not for more exact coordinates
  const double gap = std::max(mend_settings(how, reach.longest).gap, k_gap_share * reach.longest);
  const double allowed = std::min(gap, k_part * tolerance);
  if (moved <= allowed) return;
  throw InputError(fmt::format(
      "{}: the coordinates reach {:.4g} m from the origin, where STL files round them by {:.2g} m; allowed: "
      "{:.2g} m (the gap, a tenth of the tolerance). Move the mesh within {:.4g} m of the origin{}",
      file.string(), reach.furthest, moved, allowed, allowed / k_rounding,
      k_part * tolerance < gap ? ", or give a larger --tolerance" : ", or give a larger --gap"));
}

[[noreturn]] void refuse(const fs::path& file, const mesh::MendedMesh& mesh, hull::NewHullFolder& folder) {
  std::string text = file.string() + ": the mesh cannot be mended:";
  constexpr std::size_t k_shown = 8;
  for (const auto& note : mesh.open) {
    text += fmt::format("\n  {} {}", note.count, note.what);
    for (std::size_t k = 0; k < std::min(k_shown, note.places.size()); ++k)
      text += fmt::format("\n    at ({:.6g}, {:.6g}, {:.6g}) m", note.places[k].x(), note.places[k].y(),
                          note.places[k].z());
    if (note.places.size() > k_shown) text += "\n    ...";
  }
  try {
    draw_faults(mesh, folder.staging());
    text += "\n  They are marked in " + (folder.path() / "faults.png").string();
  } catch (const FileError& e) {
    text += std::string("\n  There is no picture: ") + e.what();
  }
  folder.publish();
  throw InputError(text);
}

/// Returns what `work` returns. The name of the file is added to an InputError of it.
template <class Work>
auto naming(const fs::path& file, const Work& work) {
  try {
    return work();
  } catch (const InputError& e) {
    throw InputError(file.string() + ": " + e.what());
  }
}

/// The draught of the report. Throws InputError, before minutes of work on the convex parts, if the hull has no such
/// one.
double draught_of(const geometry::TriangleMesh& mesh, const HullPreparation& how) {
  const double draught = how.draught.value_or(0.5 * geometry::box_of(mesh).sizes().z());
  waterline_level(mesh, draught);
  return draught;
}

PreparedHull from_folder(const fs::path& folder, const HullPreparation& how) {
  PreparedHull prepared;
  prepared.hull = hull::read_hull(folder);
  prepared.draught = draught_of(prepared.hull.fluid, how);
  constexpr double k_precision = 0.05;  // of the tolerance
  prepared.deviation =
      mesh::deviation_of(prepared.hull.parts, prepared.hull.fluid,
                         k_precision * k_tolerance_share * geometry::box_of(prepared.hull.fluid).sizes().maxCoeff());
  return prepared;
}

}  // namespace

PreparedHull prepare_hull(const fs::path& mesh, const HullPreparation& how, hull::NewHullFolder& folder) {
  if (is_folder(mesh)) return from_folder(mesh, how);
  const auto done = [&](const char* stage) {
    if (how.stage_done) how.stage_done(stage);
  };
  const mesh::PolygonSoup soup = in_vessel_frame(mesh::read_polygons(mesh), how);
  const Reach reach = demand_sensible_size(soup, mesh);
  const double longest = reach.longest, tolerance = tolerance_of(how, longest);
  demand_tolerance(tolerance, longest);
  demand_digits(reach, how, mesh);
  done("read");
  mesh::MendedMesh mended = naming(mesh, [&] { return mesh::mend(soup, mend_settings(how, longest)); });
  if (!mended.open.empty()) refuse(mesh, mended, folder);
  PreparedHull prepared;
  prepared.draught = draught_of(mended.mesh, how);
  done("mend");
  mesh::ConvexParts parts = naming(mesh, [&] {
    const bool symmetric = mesh::asymmetry(mended.mesh) <= mesh::k_symmetric_share * longest;
    return mesh::decompose(mended.mesh, {tolerance, how.most_parts, symmetric, how.threads});
  });
  done("decompose");
  prepared.hull = {std::move(mended.mesh), std::move(parts.parts)};
  prepared.mended = std::move(mended.done);
  prepared.deviation = parts.deviation;
  prepared.table = std::move(parts.table);
  prepared.tolerance = tolerance;
  return prepared;
}

}  // namespace nilas::commands
